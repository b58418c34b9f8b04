// SPDX-License-Identifier: MIT
// Where a vertex lies, seen from the eyepoint, without rounding and without a division.
#pragma once

#include <algorithm>

#include "models/boundary/transactions.hpp"
#include "models/numeric/dyadic.hpp"

namespace cigsim {

/// What turns the environment into the viewpoint system, of a view.
struct ExactAxes {
  ExactAxes() = default;
  explicit ExactAxes(const ViewTransform& view)
      : rotation(convert<Dyadic>(view.rotation)), eye(convert<Dyadic>(view.eye)) {}

  Mat3T<Dyadic> rotation;
  Vec3T<Dyadic> eye;
};

/// The vertex in the viewpoint system, all coordinates times one positive number (which is 1 but
/// for vertices of cuts): its direction is exact.
inline Vec3T<Dyadic> exact_direction(const FaceSet& set, std::uint32_t vertex,
                                     const ExactAxes& axes) {
  const ExactVec* cut = set.exact(vertex);
  if (cut == nullptr) return axes.rotation * (convert<Dyadic>(set.vertices[vertex]) - axes.eye);
  const mpz_class scale = lcm(lcm(cut->x.get_den(), cut->y.get_den()), mpz_class(cut->z.get_den()));
  const auto scaled = [&](const Exact& value) {
    return Dyadic(mpz_class(value.get_num() * (scale / value.get_den())));
  };
  const Vec3T<Dyadic> at{scaled(cut->x), scaled(cut->y), scaled(cut->z)};
  return axes.rotation * (at - axes.eye * Dyadic(scale));
}

}  // namespace cigsim
