// SPDX-License-Identifier: MIT
// Ports whose width is a parameter, to and from pins that are words of 32 bits: Verilator makes one
// integer of up to 64 bits, and an array of words beyond that.
#pragma once

#include <cstdint>

#include "verilated.h"

namespace cigsim::rtl {

template <class Integer>
void from_words(const std::uint32_t* words, Integer& port) {
  port = static_cast<Integer>(words[0]);
}
inline void from_words(const std::uint32_t* words, QData& port) {
  port = QData{words[1]} << 32 | words[0];
}
template <std::size_t N>
void from_words(const std::uint32_t* words, VlWide<N>& port) {
  for (std::size_t n = 0; n < N; ++n) port[n] = words[n];
}

template <class Integer>
void to_words(const Integer& port, std::uint32_t* words) {
  words[0] = port;
}
inline void to_words(const QData& port, std::uint32_t* words) {
  words[0] = static_cast<std::uint32_t>(port);
  words[1] = static_cast<std::uint32_t>(port >> 32);
}
template <std::size_t N>
void to_words(const VlWide<N>& port, std::uint32_t* words) {
  for (std::size_t n = 0; n < N; ++n) words[n] = port[n];
}

}  // namespace cigsim::rtl
