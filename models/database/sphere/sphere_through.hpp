// SPDX-License-Identifier: MIT
// The sphere through one to four points, and exact answers to the two questions that every search
// for the smallest one asks (Levine 1975, ch. V): does the centre lie among the points that make
// it, and does another point lie in it?
//
// Seen from the first point, a sphere is a vector N and a number w > 0: the centre lies at N / 2w,
// and a point P is in or on the sphere when w P·P − N·P <= 0. Both are polynomials of the
// coordinates:
//   one point     N = 0, w = 1
//   two           N = B, w = 1
//   three         n = B × C,  N = |B|² C × n + |C|² n × B,  w = |n|²
//   four          N = |B|² C × D + |C|² D × B + |D|² B × C,  w = B · C × D, signs turned so that w
//   > 0
// and so are the weights of the centre among the points. They are evaluated in doubles with an
// error bound, and in whole numbers where that leaves the sign open.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "models/database/sphere/sphere_points.hpp"

namespace cigsim {

template <class N>
struct SphereForm {
  Vec3T<N> base, toward;  ///< the first point; N
  N weight{};             ///< w
};

class SphereThrough {
 public:
  /// One to four places in `points`.
  SphereThrough(const SpherePoints& points, std::span<const std::uint32_t> support);

  /// True when the points do not lie in a space too small for them (three on a line, four in a
  /// plane) and the centre is in or on their triangle or tetrahedron: then no smaller sphere holds
  /// them.
  bool is_smallest() const;

  /// In or on the sphere. Only for one that is_smallest().
  bool holds(std::uint32_t point) const;

  std::span<const std::uint32_t> support() const { return {support_.data(), count_}; }

  /// Exactly, in the points' own units.
  ExactVec centre() const;
  Exact squared_radius() const;

 private:
  template <class N>
  int smallest_sign(const std::array<Vec3T<N>, 3>& edge) const;
  const SphereForm<Whole>& whole_form() const;

  const SpherePoints* points_;
  std::array<std::uint32_t, 4> support_{};
  std::size_t count_ = 0;
  SphereForm<Filtered> filtered_;
  mutable std::optional<SphereForm<Whole>> whole_;
};

}  // namespace cigsim
