// SPDX-License-Identifier: MIT
// The figures of one frame, whichever machine computed it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "models/boundary/activity.hpp"
#include "models/boundary/transactions.hpp"
#include "sim/level.hpp"

namespace cigsim {

/// Host milliseconds a stage took.
struct StageTimes {
  double frame_calculator = 0, geometry_processor = 0, priority_processor = 0, edge_orderer = 0,
         priority_resolver = 0, video_processor = 0;
};

/// What machine words and capacities did to a frame (docs/machine.md, "Overload").
struct Overload {
  std::array<std::uint64_t, kStageCount> overflows{};  ///< words that were saturated, a stage
  std::uint64_t dropped_items = 0, dropped_faces = 0, dropped_crossings = 0;
  std::uint64_t overfull_lines = 0;
  std::uint64_t late_lines = 0;  ///< shown later than the raster wanted
  Cycle worst_lateness = 0;      ///< of these, cycles
};

/// When things happened to a picture, in cycles of the run.
struct FrameTiming {
  Cycle input = 0;                            ///< its viewpoint was read
  Cycle first_element = 0, last_element = 0;  ///< these left the machine
  std::array<Cycle, 3> period{};  ///< of its frames 1 and 2; of the third up to the last element
  std::array<Activity, kStageCount> activity{};  ///< a stage
  std::uint32_t extended = 0;  ///< of its three frames, those longer than the machine's frame
  /// Share of the stage's frame in which it was busy.
  double utilisation(Stage stage) const {
    const std::size_t frame = stage == Stage::kFrameCalculator     ? 0
                              : stage <= Stage::kGeometryProcessor ? 1
                                                                   : 2;
    const Activity& a = activity[static_cast<std::size_t>(stage)];
    return period[frame] == 0 ? 0
                              : static_cast<double>(a.busy()) / static_cast<double>(period[frame]);
  }
  /// From the input to the last element, both counted.
  Cycle transport_delay() const { return last_element - input + 1; }
};

/// Of a certified frame: what its doubles decided, and how much of that error bounds left in doubt,
/// so that it was decided again in exact numbers.
struct Redone {
  std::uint64_t vertices = 0, vertices_redone = 0;  ///< against the pyramid of vision and the lines
  std::uint64_t faces = 0, faces_redone = 0;        ///< clipped and projected
  std::uint64_t edges = 0;
  std::uint64_t crossings = 0, crossings_redone = 0;
  std::uint64_t exact_tests = 0;  ///< side tests, as in FrameStats
  /// Of vertices, faces and crossings, those redone; 0 without any.
  double share() const {
    const std::uint64_t all = vertices + faces + crossings;
    const std::uint64_t again = vertices_redone + faces_redone + crossings_redone;
    return all == 0 ? 0 : static_cast<double>(again) / static_cast<double>(all);
  }
};

struct FrameStats {
  double host_ms = 0;  ///< all stages, without file output
  StageTimes stages;
  std::uint64_t active_items = 0, faces = 0, edges = 0, crossings = 0, spans = 0;
  /// Groups of which the order was worked out, or kept from the frame before; on machine words all
  /// that were opened. Planes that were tested for it.
  std::uint64_t ordered_groups = 0, reused_groups = 0, tested_planes = 0;
  std::uint64_t worst_line_crossings = 0;  ///< most crossings on one line
  std::uint32_t worst_line = 0;            ///< the first line with so many
  /// Choices that were made: how many show their least detailed description, their second, …
  std::vector<std::uint32_t> detail;
  std::uint32_t faults = 0;                   ///< listability faults
  std::vector<ListabilityFault> listability;  ///< the same by name
  std::uint64_t exact_tests = 0;              ///< side tests redone in rational arithmetic
  bool certified = false;                     ///< every decision was exact
  std::optional<Redone> redone;               ///< in certified numbers
  std::optional<Overload> overload;           ///< on machine words
  std::optional<FrameTiming> timing;          ///< at levels that know time
};

}  // namespace cigsim
