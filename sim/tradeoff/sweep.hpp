// SPDX-License-Identifier: MIT
// The knobs that a user has for trading speed for accuracy, and how far each is turned.
//
// Smoothing, with its sub-lines and sub-elements (Sandor 1979), does not exist in this machine: the
// raster is the only knob of that kind.
#pragma once

#include <string>
#include <vector>

#include "sim/measure/setting.hpp"

namespace cigsim {

struct SweepPoint {
  std::string knob;  ///< which one is turned; "default" for none, "together" for several
  Setting setting;
};

struct SweepRange {
  Raster raster;                   ///< of the default point and of the reference
  MachineDescription description;  ///< of the settings on machine words; its raster is `raster`
  OverloadPolicy overload = OverloadPolicy::kDrop;
  double eye_reach = 0;       ///< as MachineOptions
  bool choices = true;        ///< the scene has levels of detail to choose from
  std::vector<Level> levels;  ///< those that take part; for time, on machine words
};

/// The default point (functional, doubles) first, then one knob at a time, then some together.
/// Word formats no narrower than a description may have. Rasters that the machine or cigsim cannot
/// have are left out. Names are unique.
std::vector<SweepPoint> sweep(const SweepRange& range);

}  // namespace cigsim
