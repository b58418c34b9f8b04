// SPDX-License-Identifier: MIT
#include "tests/database/hull/cgal.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <tuple>

namespace cigsim::test {

std::vector<Vec3> cgal_hull_corners(std::span<const Vec3> points) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> given, corners;
  for (const Vec3& p : points) given.emplace_back(p.x, p.y, p.z);
  CGAL::extreme_points_3(given, std::back_inserter(corners));
  std::vector<Vec3> out;
  for (const Point& p : corners) out.push_back({p.x(), p.y(), p.z()});
  std::sort(out.begin(), out.end(), [](const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  return out;
}

double cgal_radius(std::span<const Vec3> points) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Traits = CGAL::Min_sphere_of_points_d_traits_3<Kernel, double>;
  std::vector<Kernel::Point_3> given;
  for (const Vec3& p : points) given.emplace_back(p.x, p.y, p.z);
  CGAL::Min_sphere_of_spheres_d<Traits> sphere(given.begin(), given.end());
  return sphere.radius();
}

}  // namespace cigsim::test
