// SPDX-License-Identifier: MIT
// Exact orientation in a coordinate plane.
#pragma once

#include <cmath>

#include "models/numeric/number.hpp"

namespace cigsim {

struct Vec2 {
  double x = 0, y = 0;
  friend bool operator==(const Vec2&, const Vec2&) = default;
};

/// +1 when a, b, c turn left, -1 right, 0 on one line; decided exactly.
inline int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double l = (b.x - a.x) * (c.y - a.y), r = (b.y - a.y) * (c.x - a.x);
  // Each product carries at most 3 eps, the difference one more.
  const double value = l - r, bound = 5 * 0x1p-53 * (std::abs(l) + std::abs(r)) + 0x1p-900;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return sgn(Exact((Exact(b.x) - Exact(a.x)) * (Exact(c.y) - Exact(a.y)) -
                   (Exact(b.y) - Exact(a.y)) * (Exact(c.x) - Exact(a.x))));
}

}  // namespace cigsim
