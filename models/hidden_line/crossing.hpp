// SPDX-License-Identifier: MIT
// Places along an edge where it meets planes: a rounded parameter with its error bound, and the
// exact one when an order is in doubt.
#pragma once

#include <optional>

#include "models/hidden_line/eye.hpp"

namespace cigsim::hidden_line {

/// Where the edge from a to b meets a plane through the eye and an edge p q, or a face's plane;
/// or one of its ends. 0 <= t <= 1 from a to b in space.
class Crossing {
 public:
  enum class Kind : std::uint8_t { kStart, kInside, kEnd };

  static Crossing start() { return Crossing(Kind::kStart, 0); }
  static Crossing end() { return Crossing(Kind::kEnd, 1); }
  /// The plane must have a and b strictly on its two sides.
  static Crossing of(const SightPlane& plane, const SeenPoint& a, const SeenPoint& b);
  static Crossing of(const Plane& plane, const SeenPoint& a, const SeenPoint& b);

  Kind kind() const { return kind_; }
  /// Within 2^-40.
  double t(const Eye& eye) const { return error_ < 0x1p-40 ? t_ : to_double(exact(eye)); }
  const Exact& exact(const Eye& eye) const;
  /// -1, 0 or 1; both lie on the same edge, taken in the same direction.
  int compare(const Crossing& other, const Eye& eye) const;

 private:
  Crossing(Kind kind, double t) : kind_(kind), t_(t) {}
  void from_values(double at_a, double error_a, double at_b, double error_b);

  Kind kind_ = Kind::kInside;
  double t_ = 0, error_ = 0;
  const SeenPoint *p_ = nullptr, *q_ = nullptr, *a_ = nullptr, *b_ = nullptr;
  mutable std::optional<Exact> exact_;
};

}  // namespace cigsim::hidden_line
