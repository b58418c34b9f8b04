// SPDX-License-Identifier: MIT
// The pins of priority_processor.sv, for every size.
#pragma once

#include <cstdint>

namespace cigsim::rtl::priority_processor {

/// Words of the control store.
inline constexpr std::uint32_t kImageWords = 64;

struct Pins {
  // In.
  bool rst_i;
  std::uint32_t cfg_object_capacity_i;
  bool image_write_i;
  std::uint32_t image_address_i;
  std::uint64_t image_word_i;
  bool start_valid_i;
  std::uint32_t start_frame_i;
  bool items_ready_i;
  std::uint32_t memory_word_i;
  std::uint32_t bank_word_i;

  // Out.
  bool start_ready_o;
  bool items_valid_o;
  std::uint8_t items_set_o;
  std::uint32_t items_item_o;
  bool items_end_o;
  std::uint32_t memory_address_o;
  bool bank_o;
  std::uint32_t bank_address_o;
  std::uint32_t mon_frame_o;
  std::uint32_t mon_record_o;
  bool mon_stalled_o;
  bool mon_dropped_o;
  bool mon_group_o;
  bool mon_plane_o;
  bool mon_pair_o;
  bool mon_fault_o;
};

}  // namespace cigsim::rtl::priority_processor
