// SPDX-License-Identifier: MIT
// The settings that a run with an error budget chooses from.
#pragma once

#include <vector>

#include "sim/budget/budget.hpp"
#include "sim/measure/setting.hpp"

namespace cigsim {

struct CandidateRange {
  /// On machine words, functional: the raster and the machine that the run has.
  MachineOptions words;
  bool machine_given = false;   ///< the user named the machine: nothing computes on other numbers
  bool floats = true;           ///< single precision may be tried
  bool choices = false;         ///< the scene has levels of detail to choose from
  Level referee = Level::kRtl;  ///< whose cycles count
};

/// For proved pictures the certified ones. Else numbers, resolvers and levels of detail at the
/// functional level; where the budget bounds cycles, levels that know time too, among them the
/// referee. Names are unique. Throws UsageError for a budget of 0 on a machine's words.
std::vector<Setting> candidates(const Budget& budget, const CandidateRange& range);

}  // namespace cigsim
