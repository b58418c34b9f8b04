// SPDX-License-Identifier: MIT
// The pins of so_engine.sv. One block serves every size up to 256 objects and 256 planes: words of
// 32 bits, bit n in word n / 32, those beyond the size are neither read nor written.
#pragma once

#include <cstdint>

namespace cigsim::rtl::so_engine {

struct Pins {
  static constexpr unsigned kWords = 8;

  // In.
  bool rst_i;
  std::uint32_t cfg_last_row_i;
  bool row_valid_i;
  std::uint32_t row_index_i;
  std::uint32_t row_tells_i[kWords];
  std::uint32_t row_plus_i[kWords];
  bool start_valid_i;
  std::uint32_t start_eye_i[kWords];
  std::uint32_t start_active_i[kWords];

  // Out.
  bool start_ready_o;
  bool answer_valid_o;
  std::uint32_t answer_row_o;
  std::uint32_t answer_hides_o[kWords];
  std::uint32_t answer_hidden_o[kWords];
  std::uint32_t answer_unresolved_o[kWords];
  std::uint32_t answer_count_o;
  bool answer_last_o;
  bool answer_unique_o;
  bool answer_resolved_o;
};

}  // namespace cigsim::rtl::so_engine
