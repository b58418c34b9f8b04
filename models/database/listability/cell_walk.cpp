// SPDX-License-Identifier: MIT
#include "models/database/listability/cell_walk.hpp"

#include <bit>

namespace cigsim::listability {
namespace {

WholeVec negative(const WholeVec& v) { return {mpz_class(-v.x), mpz_class(-v.y), mpz_class(-v.z)}; }

// Without common factor, so that numbers do not grow from step to step.
WholeVec reduced(WholeVec v) {
  const mpz_class common = gcd(gcd(v.x, v.y), v.z);
  if (common > 1)
    for (mpz_class* c : {&v.x, &v.y, &v.z}) *c /= common;
  return v;
}

}  // namespace

void CellWalk::run() {
  if (flats_of_three() || flats_of_two() || flats_of_one()) return;
  at_flat({}, 1);
}

// Each of these is false when the normals do not span so many dimensions.
bool CellWalk::flats_of_three() {
  bool any = false;
  for (std::size_t i = 0; i < planes_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const WholeVec ij = cross(planes_[i].n, planes_[j].n);
      if (is_zero(ij)) continue;
      for (std::size_t k = 0; k < j; ++k) {
        const WholePlane &a = planes_[i], &b = planes_[j], &c = planes_[k];
        mpz_class w = dot(ij, c.n);
        if (sgn(w) == 0) continue;
        any = true;
        WholeVec v = cross(b.n, c.n) * a.d + cross(c.n, a.n) * b.d + ij * c.d;
        if (sgn(w) < 0) {
          v = negative(v);
          w = -w;
        }
        if (!at_flat(v, w)) return true;
      }
    }
  return any;
}

bool CellWalk::flats_of_two() {
  bool any = false;
  for (std::size_t i = 0; i < planes_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const WholePlane &a = planes_[i], &b = planes_[j];
      const WholeVec k = cross(a.n, b.n);
      if (is_zero(k)) continue;
      any = true;
      if (!at_flat(cross(b.n, k) * a.d + cross(k, a.n) * b.d, dot(k, k))) return true;
    }
  return any;
}

bool CellWalk::flats_of_one() {
  bool any = false;
  for (const WholePlane& a : planes_) {
    if (is_zero(a.n)) continue;
    any = true;
    if (!at_flat(a.n * a.d, dot(a.n, a.n))) return true;
  }
  return any;
}

bool CellWalk::at_flat(const WholeVec& v, const mpz_class& w) {
  std::uint64_t open = 0, eye_true = 0;
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    const int s = sgn(mpz_class(dot(planes_[p].n, v) - planes_[p].d * w));
    if (s == 0) open |= std::uint64_t{1} << p;
    if (s > 0) eye_true |= std::uint64_t{1} << p;
  }
  if (!flats_.insert(open).second) return true;
  path_ = {v, w, {}};
  return central(open, eye_true);
}

// Planes of `open` go through the point reached so far; the point itself is on their TRUE side.
bool CellWalk::central(std::uint64_t open, std::uint64_t eye_true) {
  if (seen_.insert(eye_true | open).second && !visit_(eye_true | open, path_)) return false;
  std::vector<std::uint32_t> list;
  for (std::uint64_t rest = open; rest != 0; rest &= rest - 1)
    list.push_back(static_cast<std::uint32_t>(std::countr_zero(rest)));
  for (const WholeVec& ray : rays(list)) {
    if (!along(ray, open, eye_true)) return false;
    if (!along(negative(ray), open, eye_true)) return false;
  }
  return true;
}

bool CellWalk::along(const WholeVec& direction, std::uint64_t open, std::uint64_t eye_true) {
  std::uint64_t still_open = 0;
  for (std::uint64_t rest = open; rest != 0; rest &= rest - 1) {
    const std::uint64_t bit = rest & (~rest + 1);
    const int s = sgn(dot(planes_[static_cast<std::size_t>(std::countr_zero(rest))].n, direction));
    if (s == 0) still_open |= bit;
    if (s > 0) eye_true |= bit;
  }
  path_.directions.push_back(direction);
  const bool on = central(still_open, eye_true);
  path_.directions.pop_back();
  return on;
}

// Directions of the smallest rays of the central arrangement of these planes; none without rank.
std::vector<WholeVec> CellWalk::rays(const std::vector<std::uint32_t>& open) const {
  std::vector<WholeVec> lines;
  bool space = false;
  for (std::size_t i = 0; i < open.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const WholeVec line = cross(planes_[open[i]].n, planes_[open[j]].n);
      if (is_zero(line)) continue;
      lines.push_back(reduced(line));
      space = space || !is_zero(cross(lines.front(), lines.back()));
    }
  if (space) return lines;
  std::vector<WholeVec> out;
  for (const std::uint32_t p : open) {
    const WholeVec& n = planes_[p].n;
    if (is_zero(n)) continue;
    // In the plane of the normals across one of them; along the only normal there is.
    out.push_back(lines.empty() ? n : reduced(cross(n, lines.front())));
    if (lines.empty()) break;
  }
  return out;
}

}  // namespace cigsim::listability
