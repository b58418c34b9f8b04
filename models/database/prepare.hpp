// SPDX-License-Identifier: MIT
// Offline database development without an operator: an environment becomes a database whose
// priority data are right from every eyepoint.
#pragma once

#include <functional>

#include "models/database/database.hpp"

namespace cigsim {

struct PrepareOptions {
  /// Overrides the scene's sun when set.
  std::optional<Sun> sun;
  /// Called now and then with a share of the work in 0..1.
  std::function<void(double)> progress;
};

/// Never fails on valid numbers: whatever cannot be used is dropped and counted in the report.
Database prepare(const Environment& environment, const PrepareOptions& options = {});

}  // namespace cigsim
