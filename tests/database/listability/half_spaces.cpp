// SPDX-License-Identifier: MIT
#include "tests/database/listability/half_spaces.hpp"

namespace cigsim::test {
namespace {

// The condition in which the coordinate `axis` of `up` (positive factor) and `down` (negative
// factor) cancel out.
HalfSpace sum_without(const HalfSpace& up, const HalfSpace& down, int axis) {
  HalfSpace out;
  const Exact u = up.a[axis], v = -down.a[axis];
  for (int k = 0; k < 3; ++k) out.a[k] = up.a[k] * v + down.a[k] * u;
  out.d = up.d * v + down.d * u;
  out.open = up.open || down.open;
  return out;
}

}  // namespace

HalfSpace half_space(const Plane& plane, bool true_side) {
  const ExactVec n = exact_normal(plane);
  HalfSpace out{{n.x, n.y, n.z}, dot(n, convert<Exact>(plane.exact.p)), !true_side};
  if (true_side) return out;
  for (Exact& a : out.a) a = -a;
  out.d = -out.d;
  return out;
}

bool have_common_point(std::vector<HalfSpace> spaces) {
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<HalfSpace> up, down, next;
    for (const HalfSpace& s : spaces)
      (sgn(s.a[axis]) > 0 ? up : sgn(s.a[axis]) < 0 ? down : next).push_back(s);
    for (const HalfSpace& u : up)
      for (const HalfSpace& d : down) next.push_back(sum_without(u, d, axis));
    spaces = std::move(next);
  }
  for (const HalfSpace& s : spaces)
    if (s.open ? sgn(s.d) >= 0 : sgn(s.d) > 0) return false;
  return true;
}

}  // namespace cigsim::test
