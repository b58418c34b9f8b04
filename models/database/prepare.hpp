// SPDX-License-Identifier: MIT
// Offline database development without an operator: an environment becomes a database whose
// priority data are right from every eyepoint.
#pragma once

#include <functional>
#include <string>

#include "models/database/database.hpp"

namespace cigsim {

struct PrepareOptions {
  /// Overrides the scene's sun when set.
  std::optional<Sun> sun;
  /// Bodies and faces that touch along a slanted plane seldom do so exactly once their coordinates
  /// are rounded. One that reaches across a separation plane by no more than this share of its
  /// largest coordinate (and no more than 2^-16 of its depth on the other side) counts as touching
  /// it; within such an overlap the order of the two is not defined. The default covers coordinates
  /// with six decimals at a thousand units. 0 cuts every overlap.
  double contact_tolerance = 0x1p-28;
  /// Keeps of every choice the most detailed description alone: the database is that of the scene
  /// without levels of detail.
  bool most_detailed = false;
  /// What messages call the scene.
  std::string file = "the scene";
  /// Called now and then with a share of the work in 0..1.
  std::function<void(double)> progress;
};

/// Whatever cannot be used is dropped and counted in the report. Throws InputError only for a
/// separation table made by hand that does not fit its objects, and std::invalid_argument for what
/// check_choices() refuses.
Database prepare(const Environment& environment, const PrepareOptions& options = {});

}  // namespace cigsim
