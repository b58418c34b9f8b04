// SPDX-License-Identifier: MIT
// Every decision along every axis in every format: how often it is wrong, where it begins to be,
// and whether what was claimed held.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "sim/stability/decision.hpp"

namespace cigsim::stability {

/// One instance that a format got wrong, so that it can be looked at again.
struct Failure {
  std::uint64_t seed = 0;  ///< of the Random that posed it: Extremes (kMixed), then the instance
  Instance instance;
  Outcome outcome;
};

/// One decision in one format at one value of an axis.
struct Cell {
  std::size_t decision = 0, format = 0;  ///< places in SweepPlan
  Axis axis = Axis::kScale;
  double value = 0;
  std::uint64_t posed = 0;  ///< that the format took: right + wrong + doubtful
  std::uint64_t wrong = 0, doubtful = 0;
  double worst_error = 0;  ///< in the decision's unit
  /// Instances with a claim, those whose error was beyond it, the largest claim, and how much of a
  /// claim above 0 an error came to at most.
  std::uint64_t claims = 0, broken = 0;
  double largest_bound = 0, worst_ratio = 0;
  std::optional<Failure> first;         ///< wrong: the first of this cell
  std::optional<Failure> first_broken;  ///< claim: the first of this cell
};

struct SweepPlan {
  std::vector<Decision> decisions;
  std::vector<Format> formats;
  std::vector<Axis> axes;  ///< those that a decision has are swept
  std::uint64_t seed = 1;
  std::uint32_t trials = 40;  ///< instances of each decision and value
  /// Called now and then with a share of the work in 0..1.
  std::function<void(double)> progress = {};
};

struct Sweep {
  /// Decision by decision, axis by axis, value by value, then formats. A shared decision has cells
  /// of format 0 only, which stand for all.
  std::vector<Cell> cells;
};

/// On all processors; the same for the same plan and material, however many there are. (Poses use
/// the host's sines, so another library may give other instances.)
Sweep sweep(const SweepPlan& plan, const Material& material);

/// The seed of one instance.
std::uint64_t instance_seed(std::uint64_t seed, const Decision& decision, Axis axis, double value,
                            std::uint32_t trial);

/// What a decision came to in a format over all axes, or over one.
struct Summary {
  std::uint64_t posed = 0, wrong = 0, doubtful = 0, claims = 0, broken = 0;
  double worst_error = 0, largest_bound = 0, worst_ratio = 0;
  const Cell* worst = nullptr;  ///< of the largest share of wrong answers; null: none wrong
  double worst_share() const {
    return worst ? static_cast<double>(worst->wrong) / static_cast<double>(worst->posed) : 0;
  }
};
Summary summary(const Sweep& sweep, std::size_t decision, std::size_t format,
                std::optional<Axis> axis = {});
/// The least extreme cell of an axis with a wrong answer; null: there is none.
const Cell* first_failure(const Sweep& sweep, std::size_t decision, std::size_t format, Axis axis);

}  // namespace cigsim::stability
