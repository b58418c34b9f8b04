// SPDX-License-Identifier: MIT
#include "models/database/listability/cell_walk.hpp"

#include <bit>
#include <cmath>

namespace cigsim::listability {
namespace {

// A sum of four products of numbers up to 1, each off by 2^-51, is off by less than 2^-47.
constexpr double kDoubt = 0x1p-46;

WholeVec negative(const WholeVec& v) { return {mpz_class(-v.x), mpz_class(-v.y), mpz_class(-v.z)}; }

// Without common factor, so that numbers do not grow from step to step.
WholeVec reduced(WholeVec v) {
  const mpz_class common = gcd(gcd(v.x, v.y), v.z);
  if (common > 1)
    for (mpz_class* c : {&v.x, &v.y, &v.z}) *c /= common;
  return v;
}

}  // namespace

CellWalk::CellWalk(const std::vector<WholePlane>& planes, const Visit& visit)
    : planes_(planes), visit_(visit) {
  for (const WholePlane& plane : planes)
    near_.push_back(scaled(plane.n.x, plane.n.y, plane.n.z, mpz_class(-plane.d)));
}

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
  const std::array<double, 4> at = scaled(v.x, v.y, v.z, w);
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    const std::array<double, 4>& n = near_[p];
    const double near = n[0] * at[0] + n[1] * at[1] + n[2] * at[2] + n[3] * at[3];
    const int s = std::abs(near) > kDoubt ? (near > 0 ? 1 : -1)
                                          : sgn(mpz_class(dot(planes_[p].n, v) - planes_[p].d * w));
    if (s == 0) open |= std::uint64_t{1} << p;
    if (s > 0) eye_true |= std::uint64_t{1} << p;
  }
  if (!flats_.insert(open).second) return true;
  path_ = {v, w, {}};
  return std::popcount(open) == 3 ? simple_vertex(open, eye_true) : central(open, eye_true);
}

// Three planes meet here. Where their normals are independent, all eight combinations occur, one
// step away.
bool CellWalk::simple_vertex(std::uint64_t open, std::uint64_t eye_true) {
  std::uint64_t bit[3];
  const WholeVec* n[3];
  for (int k = 0; k < 3; ++k, open &= open - 1) {
    bit[k] = open & (~open + 1);
    n[k] = &planes_[static_cast<std::size_t>(std::countr_zero(open))].n;
  }
  const int turn = sgn(triple(*n[0], *n[1], *n[2]));
  if (turn == 0) return central(bit[0] | bit[1] | bit[2], eye_true);
  for (int choice = 0; choice < 8; ++choice) {
    std::uint64_t here = eye_true;
    for (int k = 0; k < 3; ++k)
      if (choice >> k & 1) here |= bit[k];
    if (!seen_.insert(here).second) continue;
    WholeVec direction;
    for (int k = 0; k < 3; ++k) {
      const WholeVec off = cross(*n[(k + 1) % 3], *n[(k + 2) % 3]);
      const bool forward = (turn > 0) == ((choice >> k & 1) != 0);
      direction = forward ? direction + off : direction - off;
    }
    path_.directions.assign(1, direction);
    const bool on = visit_(here, path_);
    path_.directions.clear();
    if (!on) return false;
  }
  return true;
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
