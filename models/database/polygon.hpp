// SPDX-License-Identifier: MIT
// Loops of vertices: orientation, convexity and decomposition into convex loops, all decided
// exactly in the coordinate plane in which the loop is largest.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "models/numeric/orientation2.hpp"
#include "models/numeric/plane.hpp"

namespace cigsim {

using Loop = std::vector<std::uint32_t>;

/// A loop seen along a coordinate axis, so that it runs anticlockwise in (x, y).
class FlatLoop {
 public:
  /// Nothing when the loop has no area (all its vertices on one line).
  static std::optional<FlatLoop> make(std::span<const Vec3> vertices, const Loop& loop);

  Vec2 at(std::uint32_t vertex) const;
  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return orientation(at(a), at(b), at(c));
  }

 private:
  std::span<const Vec3> vertices_;
  int axis_ = 2;
  bool mirrored_ = false;
};

/// Three vertices of the loop, not on one line, that run as the loop runs; the largest triangle
/// with the first vertex among those tried. Nothing when the loop has no area.
std::optional<std::array<std::uint32_t, 3>> spanning_corners(std::span<const Vec3> vertices,
                                                             const Loop& loop);

/// True when every vertex lies exactly on the plane.
bool on_plane(const Plane& plane, std::span<const Vec3> vertices, const Loop& loop);

/// True when the loop is convex (straight corners allowed) and runs round once.
bool is_convex(const FlatLoop& flat, const Loop& loop);

struct Triangulation {
  std::vector<Loop> triangles;
  bool crossing = false;  ///< the loop crosses itself; the triangles follow it as it runs
};

/// Ear clipping; triangles without area are left out.
Triangulation triangulate(const FlatLoop& flat, const Loop& loop);

/// Joins triangles of one planar loop into few convex loops (Hertel and Mehlhorn 1983).
std::vector<Loop> join_convex(const FlatLoop& flat, std::vector<Loop> triangles);

/// Triangles of a loop that is convex but not planar, such that it bulges towards its front
/// everywhere: the upper hull. The hull of a convex body has just these faces.
std::vector<Loop> bulge(std::span<const Vec3> vertices, const Loop& loop);

}  // namespace cigsim
