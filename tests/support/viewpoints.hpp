// SPDX-License-Identifier: MIT
// Eyepoints where pictures are hard to get right.
#pragma once

#include "models/boundary/transactions.hpp"
#include "models/environment/random.hpp"

namespace cigsim::test {

/// A viewpoint near an object, far from it, or about its middle, in general position. Fields of
/// view from 1 to 170 degrees; with and without roll.
Viewpoint plain_viewpoint(const Environment& environment, Random& random);

/// A plain one, or: in the plane of a face, on a vertex, on an edge, in the middle of an object,
/// level with a vertex and along an axis.
Viewpoint random_viewpoint(const Environment& environment, Random& random);

/// A raster of at most `largest` elements a side, now and then of one element or one line.
Raster random_raster(Random& random, int largest);

}  // namespace cigsim::test
