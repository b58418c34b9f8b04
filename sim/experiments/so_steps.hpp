// SPDX-License-Identifier: MIT
// The separating-object matrix (Levine 1975, ch. VI.E) over the frames of a flight: worked out anew
// in every frame, or kept up to date plane by plane.
#pragma once

#include <string_view>

#include "models/priority_processor/so_incremental.hpp"
#include "sim/measure/interleave.hpp"
#include "sim/view.hpp"

namespace cigsim {

/// Sums over the frames, of the groups with planes and two active members or more.
struct SoSteps {
  std::uint64_t frames = 0, groups = 0, pairs = 0;  ///< pairs of active members
  /// Of those groups, not among `groups`: that have no matrix (so_steps()).
  std::uint64_t groups_left_out = 0;
  /// Anew: a row of so_engine.sv a cycle, for every active member.
  std::uint64_t full_cycles = 0;
  /// Kept: telling a group's planes when it is first in view,
  priority_processor::SoUpdateWork first;
  /// then crossings of planes, pairs that they part, and cycles of so_update.sv; and, of the
  /// groups where anything changed, a cycle for each row that is read again.
  priority_processor::SoUpdateWork update;
  std::uint64_t row_cycles = 0;
  /// Rows that the two disagree on. A check of the experiment: 0.
  std::uint64_t wrong_rows = 0;
  /// Host time of a frame's matrices, milliseconds.
  Spread full_ms, update_ms;

  /// Why groups, or all of them, have no part in the figures; empty where none is left out.
  std::string_view why_not() const;
};

/// The engine's matrix has a row of planes a member: a plane parts all members on its one side from
/// all on the other. A table made by hand may list fewer pairs, and then has no such matrix.
SoSteps so_steps(const Database& database, const std::vector<FrameView>& views,
                 const Raster& raster, std::size_t rounds, std::uint64_t seed);

}  // namespace cigsim
