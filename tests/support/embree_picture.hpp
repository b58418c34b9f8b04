// SPDX-License-Identifier: MIT
// A picture by Embree's ray casting in float: an oracle that nobody here wrote.
#pragma once

#include <cstdint>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "tests/support/ray_oracle.hpp"

namespace cigsim::test {

/// What a ray through an element meets first.
struct EmbreeHit {
  std::uint32_t polygon = kNone;  ///< index into the polygons
  float distance = 0;             ///< along the line of sight
};

/// Polygons relative to the eyepoint, in float; one-sided ones that look away are left out.
/// Elements row by row from the top. Throws std::runtime_error when Embree cannot work.
std::vector<EmbreeHit> cast_with_embree(const std::vector<OraclePolygon>& polygons,
                                        const ViewTransform& view);

}  // namespace cigsim::test
