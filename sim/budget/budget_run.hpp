// SPDX-License-Identifier: MIT
// A budget of errors instead of knobs: which setting a run takes, from what evidence, and whether
// frames that the evidence did not see keep the budget.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/budget/budget.hpp"
#include "sim/budget/candidates.hpp"
#include "sim/view.hpp"

namespace cigsim {

struct BudgetRequest {
  Budget budget;
  const Database* database = nullptr;
  std::vector<FrameView> views;  ///< of the run, at least one
  CandidateRange range;          ///< its referee is found here
  std::function<void(double)> progress;
};

struct BudgetOutcome {
  Setting chosen;
  bool kept = true;                ///< by every frame that was looked at
  nlohmann::ordered_json json;     ///< "budget" of stats.json
  std::vector<std::string> lines;  ///< for the summary
};

/// Measures the candidates on a few frames of the run (or reads what an earlier run measured of the
/// same), takes the fastest that keeps the budget on each of them, and checks it on frames held
/// back. To be called before the process makes a SystemC module. Throws UsageError where no setting
/// keeps the budget, naming those that come nearest; MeasureError where one fails.
BudgetOutcome settle_budget(const BudgetRequest& request);

}  // namespace cigsim
