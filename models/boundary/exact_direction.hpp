// SPDX-License-Identifier: MIT
// Where a vertex lies, seen from the eyepoint, without rounding and without a division.
#pragma once

#include <algorithm>

#include "models/boundary/transactions.hpp"
#include "models/numeric/dyadic.hpp"

namespace cigsim {

/// The vertex in the viewpoint system, all coordinates times one positive number (which is 1 but
/// for vertices of cuts): its direction is exact.
inline Vec3T<Dyadic> exact_direction(const FaceSet& set, std::uint32_t vertex,
                                     const ViewTransform& view) {
  const Mat3T<Dyadic> rotation = convert<Dyadic>(view.rotation);
  const Vec3T<Dyadic> eye = convert<Dyadic>(view.eye);
  const ExactVec* cut = set.exact(vertex);
  if (cut == nullptr) return rotation * (convert<Dyadic>(set.vertices[vertex]) - eye);
  const mpz_class scale = lcm(lcm(cut->x.get_den(), cut->y.get_den()), mpz_class(cut->z.get_den()));
  const auto scaled = [&](const Exact& value) {
    return Dyadic(mpz_class(value.get_num() * (scale / value.get_den())));
  };
  const Vec3T<Dyadic> at{scaled(cut->x), scaled(cut->y), scaled(cut->z)};
  return rotation * (at - eye * Dyadic(scale));
}

}  // namespace cigsim
