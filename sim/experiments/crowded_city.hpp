// SPDX-License-Identifier: MIT
// A city in view, and as many further buildings as wanted on all sides of the pyramid of vision.
#pragma once

#include "models/boundary/transactions.hpp"

namespace cigsim {

struct CrowdedCity {
  Environment environment;
  Viewpoint viewpoint;
};

/// The first `visible` objects are in view, the others are not. The same seed gives the same city.
CrowdedCity make_crowded_city(std::uint32_t visible, std::uint32_t objects, std::uint64_t seed = 1);

}  // namespace cigsim
