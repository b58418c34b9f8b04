// SPDX-License-Identifier: MIT
#include "models/hidden_line/crossing.hpp"

#include <cmath>
#include <limits>

namespace cigsim::hidden_line {

void Crossing::from_values(double at_a, double error_a, double at_b, double error_b) {
  const double whole = std::abs(at_a) + std::abs(at_b), error = error_a + error_b;
  t_ = std::abs(at_a) / whole;
  // Neither value may be lost in its error: then t has no meaning yet.
  error_ =
      whole > 4 * error ? 2 * error / whole + 0x1p-50 : std::numeric_limits<double>::infinity();
}

Crossing Crossing::of(const SightPlane& plane, const SeenPoint& a, const SeenPoint& b) {
  Crossing c(Kind::kInside, 0);
  c.p_ = plane.p;
  c.q_ = plane.q;
  c.a_ = &a;
  c.b_ = &b;
  c.from_values(plane.value(a), plane.error(a), plane.value(b), plane.error(b));
  return c;
}

Crossing Crossing::of(const Plane& plane, const SeenPoint& a, const SeenPoint& b) {
  Crossing c(Kind::kInside, 0);
  c.exact_ = Eye::crossing(plane, a, b);
  c.t_ = to_double(*c.exact_);
  c.error_ = 0x1p-50;
  return c;
}

const Exact& Crossing::exact(const Eye& eye) const {
  if (!exact_) {
    if (kind_ == Kind::kInside)
      exact_ = eye.crossing(*p_, *q_, *a_, *b_);
    else
      exact_ = kind_ == Kind::kEnd ? 1 : 0;
  }
  return *exact_;
}

int Crossing::compare(const Crossing& other, const Eye& eye) const {
  if (kind_ != other.kind_) return kind_ < other.kind_ ? -1 : 1;
  if (kind_ != Kind::kInside) return 0;
  if (p_ && p_ == other.p_ && q_ == other.q_) return 0;
  const double error = error_ + other.error_, apart = t_ - other.t_;
  if (apart > error) return 1;
  if (apart < -error) return -1;
  return cmp(exact(eye), other.exact(eye));
}

}  // namespace cigsim::hidden_line
