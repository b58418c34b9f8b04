// SPDX-License-Identifier: MIT
// Where an eyepoint can be among separation planes. Each plane has a closed TRUE side (on the plane
// counts as TRUE, Stump 1986, ch. III) and an open FALSE side; an eyepoint has a side at each
// plane. Which combinations of sides occur is decided in whole numbers.
//
// Two questions are answered. *Can an eyepoint have these sides at up to three planes* (`can_see`):
//  - planes with independent normals: the three values n . x - d can be any three numbers, so every
//    combination occurs;
//  - two of the planes parallel: along their common normal the sides are intervals, and intervals
//    that meet two and two have a common point (Helly 1923, in one dimension); a third plane that
//    is not parallel takes any value on their common set. So it is enough to ask two and two;
//  - three normals in one plane, no two parallel: n_r = a n_p + b n_q, so that the value at the
//    third plane is a v_p + b v_q + g with v_p, v_q free. Where a v_p and b v_q have one sign, the
//    values run from g to infinity on that side, and the end g itself occurs when both sides are
//    closed.
//
// *Which combinations occur over all planes* (`for_each_cell`). The set F of the points with one
// combination of values +, 0, - has in its closure a smallest flat v of the arrangement (a vertex,
// when the normals span space). At planes that miss v every point of F has the sides of v. At those
// through v its combination is one of the central arrangement of their normals, and the closure of
// that cone has a smallest ray: the combination is that of the ray at the planes which the ray
// leaves, and of a central arrangement of smaller rank at the others. So every combination is that
// of a point v + e1 r1 + e2 r2 + e3 r3 with e1 >> e2 >> e3 and up to three rays, and to go through
// all vertices, rays at them and so on finds all of them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "models/database/listability/whole_plane.hpp"

namespace cigsim::listability {

/// Planes at most, in for_each_cell: a bit each.
inline constexpr std::size_t kMostCellPlanes = 64;

struct EyeSide {
  std::uint32_t plane = 0;
  bool eye_true = false;
  friend bool operator==(const EyeSide&, const EyeSide&) = default;
};

/// How a combination was found: the point v / w, and directions that lead from it into the cell,
/// each by an infinitely smaller step than the one before.
struct CellPath {
  WholeVec v;
  mpz_class w;
  std::vector<WholeVec> directions;
};

class Arrangement {
 public:
  explicit Arrangement(const std::vector<Plane>& planes);

  /// True when an eyepoint with these sides exists. At most three sides; a plane may occur twice.
  bool can_see(std::span<const EyeSide> sides) const;

  /// Calls `visit` once for every combination of sides over all planes that an eyepoint can have
  /// (bit p set: TRUE at plane p), until it returns false. At most kMostCellPlanes planes.
  void for_each_cell(
      const std::function<bool(std::uint64_t eye_true, const CellPath& path)>& visit) const;

  /// The point of a path, near enough to it that its sides are those of the cell. `reach` bounds
  /// each step where the cell does not.
  ExactVec point_of(const CellPath& path, const Exact& reach) const;

  /// A point with these sides, or nothing when there is none. Meant for few planes.
  std::optional<ExactVec> point_with(std::span<const EyeSide> sides, const Exact& reach) const;

 private:
  bool parallel(std::uint32_t p, std::uint32_t q) const;
  bool independent(std::uint32_t p, std::uint32_t q, std::uint32_t r) const;
  bool constant_allows(const EyeSide& s) const;
  bool pair_can(const EyeSide& p, const EyeSide& q) const;
  bool dependent_can(const EyeSide& p, const EyeSide& q, const EyeSide& r) const;

  std::vector<WholePlane> planes_;
  std::vector<Vec3> near_;  // normals in doubles, largest coordinate about 1, each within 2^-50
  std::vector<bool> flat_;  // without a normal
};

}  // namespace cigsim::listability
