// SPDX-License-Identifier: MIT
// Points as the sphere's arithmetic wants them: as doubles of middling size, with a bound on what
// that changed, and as whole numbers.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <span>
#include <vector>

#include "models/numeric/filtered.hpp"
#include "models/numeric/number.hpp"

namespace cigsim {

using Whole = mpz_class;
using WholeVec = Vec3T<Whole>;
using FilteredVec = Vec3T<Filtered>;

class SpherePoints {
 public:
  /// Keeps a view of `points`. Throws std::invalid_argument for a coordinate that is not finite.
  explicit SpherePoints(std::span<const Vec3> points);

  std::size_t size() const { return work_.size(); }
  const Vec3& original(std::uint32_t i) const { return points_[i]; }

  /// The points times 2^-exponent(), largest coordinate between 2^-100 and 2^100: the points
  /// themselves where they already are so.
  std::span<const Vec3> work() const { return work_; }
  int exponent() const { return exponent_; }
  /// The largest magnitude of a coordinate of work().
  double largest() const { return largest_; }

  FilteredVec filtered(std::uint32_t i) const {
    const Vec3& p = work_[i];
    return {Filtered(p.x, scale_error_), Filtered(p.y, scale_error_), Filtered(p.z, scale_error_)};
  }

  /// The point times 2^whole_shift(), a whole number.
  WholeVec whole(std::uint32_t i) const;
  int whole_shift() const { return whole_shift_; }

 private:
  std::span<const Vec3> points_, work_;
  std::vector<Vec3> scaled_;
  double largest_ = 0, scale_error_ = 0;
  int exponent_ = 0, whole_shift_ = 0;
};

}  // namespace cigsim
