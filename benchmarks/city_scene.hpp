// SPDX-License-Identifier: MIT
// The city that every renderer draws, and the eyepoints it is drawn from.
#pragma once

#include <vector>

#include "models/boundary/transactions.hpp"

namespace cigsim::benchmarks {

struct CityScene {
  Database database;
  std::vector<Viewpoint> path;  ///< a slow flight sideways, everything in view from each eyepoint
};

/// `generate city --objects 200 --seed 1`, with its ground or without.
CityScene make_city(bool with_ground);

}  // namespace cigsim::benchmarks
