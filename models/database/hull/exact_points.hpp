// SPDX-License-Identifier: MIT
// Points with exact predicates, for any finite doubles.
//
// The points are also kept scaled by one power of two, so that the largest coordinate lies between
// 1/2 and 1: neither overflow nor (but for coordinates more than 2^250 times smaller than the
// largest) underflow can then trouble arithmetic on them. Decisions that a filter on the scaled
// points leaves open come here: expansions where all scaled coordinates are exact and large enough
// for them, rationals of the original ones else.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/numeric/number.hpp"

namespace cigsim {

/// Absolute room that every filter on scaled points leaves for underflow: what it lost is far less.
inline constexpr double kUnderflowRoom = 0x1p-900;

/// Distances from a plane in doubles: value = normal · (p − base), wrong by at most `bound`.
struct FilterPlane {
  Vec3 base, normal;
  double bound = 0;

  double value(const Vec3& p) const { return dot(normal, p - base); }
};

class ExactPoints {
 public:
  /// Keeps a view of `points`. Throws std::invalid_argument for a coordinate that is not finite.
  explicit ExactPoints(std::span<const Vec3> points);

  std::size_t size() const { return scaled_.size(); }
  /// scaled(i) · 2^exponent() is the point, but for coordinates that became denormal.
  const Vec3& scaled(std::uint32_t i) const { return scaled_[i]; }
  std::span<const Vec3> scaled() const { return scaled_; }
  const Vec3& original(std::uint32_t i) const { return points_[i]; }
  int exponent() const { return exponent_; }

  /// The plane through a, b, c, normal on the side from which they run anticlockwise, with a bound
  /// that holds for all the points.
  FilterPlane plane(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

  /// Side of the plane through a, b, c: +1 when d sees a, b, c run anticlockwise. Without a filter.
  int exact_side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;

  /// The same, filtered with what d's own distance allows. Counts in `exact` where that failed.
  int side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
           std::uint64_t& exact) const;

  /// Sign of the component `axis` (0, 1, 2) of (b − a) × (c − a).
  int turn(int axis, std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

  bool collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

 private:
  std::span<const Vec3> points_;
  std::vector<Vec3> scaled_;
  Vec3 extent_;  // lengths of the sides of the scaled points' box, rounded up
  int exponent_ = 0;
  bool expansions_ = true;  // every scaled coordinate is 0 or at least 2^-250
};

}  // namespace cigsim
