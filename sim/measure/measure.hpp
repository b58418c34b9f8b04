// SPDX-License-Identifier: MIT
// Several settings over the same frames, in rounds that interleave them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/measure/interleave.hpp"
#include "sim/measure/trial.hpp"

namespace cigsim {

struct MeasureOptions {
  std::size_t rounds = 3;  ///< at least 1
  std::uint64_t seed = 1;  ///< of the order
  double limit_s = 300;    ///< for one trial of one setting
  /// Told the share that is done and the setting that comes next.
  std::function<void(double, const std::string&)> progress;
};

/// What the rounds came to.
struct Measured {
  Setting setting;
  Spread frame_ms;            ///< mean of the views
  Spread memory_mib;          ///< as Trial
  Spread mcycles_per_second;  ///< millions, simulated in a second of the host; 0 without time
  std::vector<Cycle> delays;  ///< as Trial
  std::vector<PictureError> errors;     ///< as Trial
  OverloadSum overload;                 ///< as Trial
  std::optional<std::string> given_up;  ///< why there are no figures: it failed, or took too long

  PictureError error() const;  ///< of all views together
};

/// Each setting, measured; those that fail or go beyond the limit are given up, the rest goes on.
/// Throws MeasureError where one gives different pictures in two rounds.
std::vector<Measured> measure(const std::vector<Setting>& settings, const Workload& work,
                              const MeasureOptions& options);

/// What it means to errors in elements that a scene has more numbers than pictures can tell
/// (numbers_saturate() of sim/stats.hpp).
inline constexpr const char* kNumbersSaturate =
    "objects from 65535 on share that number: one of them in the place of another counts as right";

/// The worst of the views: how far its delay is from the referee's, as a share of that; nothing
/// where the two do not have delays of the same views.
std::optional<double> cycle_error(const std::vector<Cycle>& delays,
                                  const std::vector<Cycle>& referee);

}  // namespace cigsim
