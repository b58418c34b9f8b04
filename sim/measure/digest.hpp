// SPDX-License-Identifier: MIT
// A fingerprint of bytes: FNV-1a (Fowler, Noll, Vo) taken eight bytes at a time, with a fold so
// that high bits reach low ones. Not against an adversary.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace cigsim {

class Digest {
 public:
  void add(std::string_view bytes) {
    while (!bytes.empty()) {
      std::uint64_t word = 0;
      const std::size_t part = std::min(bytes.size(), sizeof word);
      std::memcpy(&word, bytes.data(), part);
      value_ = (value_ ^ word) * 0x100000001b3u;
      value_ ^= value_ >> 29;
      bytes.remove_prefix(part);
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace cigsim
