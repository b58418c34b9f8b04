// SPDX-License-Identifier: MIT
// What capacities and machine words did to some frames together (docs/machine.md, "Overload").
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>

#include "sim/frame_stats.hpp"

namespace cigsim {

struct OverloadSum {
  std::uint64_t frames = 0;      ///< on machine words
  std::uint64_t overloaded = 0;  ///< of these, those that lost something to a capacity
  std::uint64_t saturated = 0;   ///< of these, those with saturated words
  std::uint64_t dropped_items = 0, dropped_faces = 0, dropped_crossings = 0, overfull_lines = 0;
  std::uint64_t saturated_words = 0;

  /// Another frame; numbers other than machine words have no overload, and do not count.
  void add(const FrameStats& frame);
};

/// By the names of its members.
nlohmann::ordered_json overload_sum_json(const OverloadSum& sum);
OverloadSum overload_sum_from_json(const nlohmann::ordered_json& json);

}  // namespace cigsim
