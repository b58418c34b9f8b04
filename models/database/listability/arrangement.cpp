// SPDX-License-Identifier: MIT
#include "models/database/listability/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "models/database/listability/cell_walk.hpp"

namespace cigsim::listability {
namespace {

constexpr double kCrossDoubt = 0x1p-47, kTripleDoubt = 0x1p-45;

int first_axis(const WholeVec& v) { return sgn(v.x) != 0 ? 0 : sgn(v.y) != 0 ? 1 : 2; }

const mpz_class& coordinate(const WholeVec& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

Exact magnitude(const ExactVec& v) {
  const Exact x = abs(v.x), y = abs(v.y), z = abs(v.z);
  return std::max(std::max(x, y), z);
}

ExactVec exact(const WholeVec& v) { return {Exact(v.x), Exact(v.y), Exact(v.z)}; }

}  // namespace

Arrangement::Arrangement(const std::vector<Plane>& planes) : planes_(whole_planes(planes)) {
  for (const WholePlane& plane : planes_) {
    const auto n = scaled(plane.n.x, plane.n.y, plane.n.z, 0);
    near_.push_back({n[0], n[1], n[2]});
    flat_.push_back(is_zero(plane.n));
  }
}

bool Arrangement::parallel(std::uint32_t p, std::uint32_t q) const {
  const Vec3 c = cross(near_[p], near_[q]);
  if (std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}) > kCrossDoubt) return false;
  return is_zero(cross(planes_[p].n, planes_[q].n));
}

bool Arrangement::independent(std::uint32_t p, std::uint32_t q, std::uint32_t r) const {
  if (std::abs(dot(near_[p], cross(near_[q], near_[r]))) > kTripleDoubt) return true;
  return sgn(triple(planes_[p].n, planes_[q].n, planes_[r].n)) != 0;
}

bool Arrangement::constant_allows(const EyeSide& s) const {
  return (sgn(planes_[s.plane].d) <= 0) == s.eye_true;
}

bool Arrangement::pair_can(const EyeSide& p, const EyeSide& q) const {
  if (p.plane == q.plane) return p.eye_true == q.eye_true;
  if (!parallel(p.plane, q.plane)) return true;
  // v_q = l v_p + g with l = n_q / n_p and g = l d_p - d_q.
  const WholePlane &a = planes_[p.plane], &b = planes_[q.plane];
  const int axis = first_axis(a.n);
  const mpz_class &na = coordinate(a.n, axis), &nb = coordinate(b.n, axis);
  const int l = sgn(na) * sgn(nb);
  const int g = sgn(mpz_class(nb * a.d - na * b.d)) * sgn(na);
  const bool up = (l > 0) == p.eye_true;
  if (up == q.eye_true) return true;
  // The end g of the values at q decides; it occurs when the side at p is closed.
  if (up) return g < 0;
  return g > 0 || (g == 0 && p.eye_true);
}

bool Arrangement::dependent_can(const EyeSide& p, const EyeSide& q, const EyeSide& r) const {
  const WholePlane &P = planes_[p.plane], &Q = planes_[q.plane], &R = planes_[r.plane];
  // n_r = (a n_p + b n_q) / k.k and v_r = (a v_p + b v_q + g) / k.k.
  const WholeVec k = cross(P.n, Q.n);
  const mpz_class a = dot(cross(R.n, Q.n), k), b = dot(cross(P.n, R.n), k);
  const int g = sgn(mpz_class(a * P.d + b * Q.d - dot(k, k) * R.d));
  const bool up_p = (sgn(a) > 0) == p.eye_true, up_q = (sgn(b) > 0) == q.eye_true;
  if (up_p != up_q || up_p == r.eye_true) return true;
  if (up_p) return g < 0;
  return g > 0 || (g == 0 && p.eye_true && q.eye_true);
}

bool Arrangement::can_see(std::span<const EyeSide> sides) const {
  std::vector<EyeSide> distinct;
  for (const EyeSide& s : sides) {
    if (flat_[s.plane]) {
      if (!constant_allows(s)) return false;
      continue;
    }
    const auto same = std::find_if(distinct.begin(), distinct.end(),
                                   [&](const EyeSide& d) { return d.plane == s.plane; });
    if (same == distinct.end())
      distinct.push_back(s);
    else if (same->eye_true != s.eye_true)
      return false;
  }
  for (std::size_t i = 0; i < distinct.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!pair_can(distinct[i], distinct[j])) return false;
  if (distinct.size() < 3) return true;
  const auto [p, q, r] = std::tie(distinct[0], distinct[1], distinct[2]);
  if (independent(p.plane, q.plane, r.plane)) return true;
  if (parallel(p.plane, q.plane) || parallel(p.plane, r.plane) || parallel(q.plane, r.plane))
    return true;
  return dependent_can(p, q, r);
}

void Arrangement::for_each_cell(
    const std::function<bool(std::uint64_t, const CellPath&)>& visit) const {
  if (planes_.size() > kMostCellPlanes)
    throw std::invalid_argument("cells of more than 64 planes are not enumerated");
  CellWalk(planes_, visit).run();
}

ExactVec Arrangement::point_of(const CellPath& path, const Exact& reach) const {
  ExactVec point{Exact(path.v.x, path.w), Exact(path.v.y, path.w), Exact(path.v.z, path.w)};
  for (Exact* c : {&point.x, &point.y, &point.z}) c->canonicalize();
  for (const WholeVec& direction : path.directions) {
    const ExactVec along = exact(direction);
    Exact step = reach / magnitude(along);
    for (const WholePlane& plane : planes_) {
      const Exact value = dot(exact(plane.n), point) - Exact(plane.d);
      const Exact slope = dot(exact(plane.n), along);
      // Half way to the plane at most, so that the side stays.
      if (sgn(value) * sgn(slope) < 0) step = std::min(step, Exact(abs(value) / abs(slope) / 2));
    }
    point = point + along * step;
  }
  return point;
}

std::optional<ExactVec> Arrangement::point_with(std::span<const EyeSide> sides,
                                                const Exact& reach) const {
  Arrangement few(std::vector<Plane>{});
  std::uint64_t want = 0;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    few.planes_.push_back(planes_[sides[s].plane]);
    want |= std::uint64_t{sides[s].eye_true} << s;
  }
  std::optional<ExactVec> found;
  few.for_each_cell([&](std::uint64_t eye_true, const CellPath& path) {
    if (eye_true == want) found = few.point_of(path, reach);
    return !found;
  });
  return found;
}

}  // namespace cigsim::listability
