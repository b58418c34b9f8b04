// SPDX-License-Identifier: MIT
// The smallest sphere round points in space, twice: Levine's search of 1975 with his counters, and
// a fast one.
//
// Which points the sphere rests on is decided exactly for any finite doubles; only the centre and
// the radius are rounded, the radius upward, so that the sphere given encloses every point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "models/database/hull/hull.hpp"
#include "models/numeric/vec3.hpp"

namespace cigsim {

struct BoundingSphere {
  Vec3 centre;              ///< rounded to doubles
  double radius = 0;        ///< from the rounded centre, rounded upward: no point is farther
  double exact_radius = 0;  ///< of the exact sphere, nearest double
  /// One to four places in the points given: the exact sphere is the smallest round these and
  /// passes through them. Ascending.
  std::vector<std::uint32_t> support;
};

/// Fast: pivots, each a pass over the points for the farthest one and then the exact smallest
/// sphere of at most five points (after Gärtner 1999, Welzl 1991). Some ten passes. Throws
/// std::invalid_argument for no points, a coordinate that is not finite, or a radius beyond the
/// largest double.
BoundingSphere minimum_sphere(std::span<const Vec3> points);

/// The number of the last point that Levine's search looks at before it gives up (app. II).
inline constexpr std::size_t kPublishedLastPoint = 26;

struct LevineSphere {
  std::optional<BoundingSphere> sphere;  ///< none: given up
  /// The points of `sphere` as places in the order of ascending solid angle, from 1, ascending
  /// (Levine's SP). Their number, 2 to 4, is the type of the sphere (TSC); 1 for a single point.
  std::vector<std::uint32_t> selected;
  std::uint64_t hull_points = 0;      ///< NPTH
  std::uint64_t tests = 0;            ///< NT: a point put into the equation of a sphere
  std::uint64_t spheres_created = 0;  ///< NSC
  std::uint64_t spheres_tested = 0;   ///< NST: those whose centre lies among their points
  /// ESC, of a search without the order: (C(h,4) + C(h,3) + 1) / 2 for h hull points.
  double spheres_expected = 0;
};

struct LevineSphereOptions {
  std::optional<std::size_t> last_point = kPublishedLastPoint;  ///< none: never gives up
  /// His loops, to the letter: no three-point sphere with the last of all points is ever tried, and
  /// three points alone are never searched.
  bool published_loops = false;
};

/// Levine 1975, ch. V: the points of `hull` in the order of ascending solid angle; the sphere on
/// the two that are farthest apart, then the spheres through three and four. Time h² for the
/// farthest pair and h · L⁴ / 24 for a search that ends at point L.
LevineSphere levine_sphere(std::span<const Vec3> points, const Hull& hull,
                           const LevineSphereOptions& options = {});

/// The solid angle at each of hull.vertices, steradians; of a polygon its plane angles in radians,
/// and zeros below dimension 2.
std::vector<double> solid_angles(std::span<const Vec3> points, const Hull& hull);

}  // namespace cigsim
