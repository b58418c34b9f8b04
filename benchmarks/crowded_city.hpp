// SPDX-License-Identifier: MIT
// A city in view, and as many further buildings as wanted on all sides of the pyramid of vision.
#pragma once

#include "models/boundary/transactions.hpp"

namespace cigsim::benchmarks {

struct CrowdedCity {
  Environment environment;
  Viewpoint viewpoint;
};

/// The first `visible` objects are in view, the others are not.
CrowdedCity make_crowded_city(std::uint32_t visible, std::uint32_t objects);

}  // namespace cigsim::benchmarks
