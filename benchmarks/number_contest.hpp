// SPDX-License-Identifier: MIT
// Certified numbers beside doubles on the frames of a path, for the benchmark of pictures.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/summary_reporter.hpp"
#include "sim/functional_machine.hpp"
#include "sim/view.hpp"

namespace cigsim::benchmarks {

class NumberContest {
 public:
  /// The database must outlive it.
  NumberContest(std::string name, const Database& database, std::vector<FrameView> views,
                const Raster& raster);

  /// Compares the certified pictures of all frames, or a few dozen of them, with those in exact
  /// numbers, element by element, and tells what was redone. False: one differs.
  bool agree();
  /// Two benchmarks: a frame each, in turn.
  void register_all();
  /// How many times longer a certified frame takes, beside the goal.
  void print_ratio(const SummaryReporter& summary) const;

 private:
  std::string name_;
  const Database& database_;
  std::vector<FrameView> views_;
  Raster raster_;
  FunctionalMachine rounded_, certified_;
};

}  // namespace cigsim::benchmarks
