// SPDX-License-Identifier: MIT
// The pins of so_update.sv, of up to 64 objects and 64 planes.
#pragma once

#include <cstdint>

namespace cigsim::rtl::so_update {

struct Pins {
  // In.
  bool rst_i;
  bool clear_i;
  bool column_valid_i;
  std::uint32_t column_plane_i;
  std::uint64_t column_tells_i;
  std::uint64_t column_plus_i;
  bool side_valid_i;
  std::uint32_t side_plane_i;
  bool side_plus_i;
  std::uint32_t row_i;

  // Out.
  bool side_ready_o;
  std::uint64_t row_hides_o;
  std::uint64_t row_hidden_o;
  std::uint64_t row_unresolved_o;
};

}  // namespace cigsim::rtl::so_update
