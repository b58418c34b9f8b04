// SPDX-License-Identifier: MIT
// Hull and smallest sphere of many random points beside CGAL's and qhull's, in turn in one run:
//   hull_benchmark [POINTS] [REPEATS]
// All of them use one processor, whose time is measured. CGAL decides exactly (EPICK) as cigsim
// does; qhull's doubles are not exact, and CGAL's sphere is computed in doubles without a proof.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "models/database/hull/hull.hpp"
#include "models/database/sphere/sphere.hpp"
#include "models/environment/random.hpp"

extern "C" {
#include <libqhull_r/libqhull_r.h>
}

namespace {

using cigsim::Vec3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Points = std::vector<Vec3>;

Points make_points(const std::string& kind, std::size_t count) {
  cigsim::Random random(1975);
  Points points;
  while (points.size() < count) {
    const Vec3 p{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double squared = dot(p, p);
    if (kind != "cube" && (squared > 1 || squared < 1e-6)) continue;
    points.push_back(kind == "surface" ? p * (1 / std::sqrt(squared)) : p);
  }
  return points;
}

std::size_t qhull_corners(const Points& points) {
  std::vector<coordT> coordinates;
  for (const Vec3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  qhT state;
  QHULL_LIB_CHECK
  qh_zero(&state, stderr);
  char command[] = "qhull";
  qh_new_qhull(&state, 3, static_cast<int>(points.size()), coordinates.data(), False, command,
               nullptr, stderr);
  const auto corners = static_cast<std::size_t>(state.num_vertices);
  qh_freeqhull(&state, qh_ALL);
  return corners;
}

// One competitor: the figure that must agree, and the seconds of each run.
struct Entry {
  const char* name;
  std::function<double()> work;
  double figure = 0;
  std::vector<double> seconds;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void race(const std::string& title, std::vector<Entry> entries, int repeats) {
  for (int i = 0; i < repeats; ++i)
    for (Entry& entry : entries) {
      const std::clock_t begin = std::clock();
      entry.figure = entry.work();
      entry.seconds.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
  const double ours = median(entries.front().seconds);
  for (const Entry& entry : entries)
    fmt::print("{:<16}{:<8}{:>10.1f} ms{:>8.2f} x  {:.17g}\n", title, entry.name,
               1e3 * median(entry.seconds), median(entry.seconds) / ours, entry.figure);
  std::fflush(stdout);
}

void race_all(const std::string& kind, std::size_t count, int repeats) {
  const Points points = make_points(kind, count);
  std::vector<Kernel::Point_3> given;
  for (const Vec3& p : points) given.emplace_back(p.x, p.y, p.z);
  race("hull " + kind,
       {{"cigsim",
         [&] { return static_cast<double>(cigsim::convex_hull(points).vertices.size()); },
         0,
         {}},
        {"CGAL",
         [&] {
           CGAL::Surface_mesh<Kernel::Point_3> mesh;
           CGAL::convex_hull_3(given.begin(), given.end(), mesh);
           return static_cast<double>(mesh.number_of_vertices());
         },
         0,
         {}},
        {"qhull", [&] { return static_cast<double>(qhull_corners(points)); }, 0, {}}},
       repeats);
  race("sphere " + kind,
       {{"cigsim", [&] { return cigsim::minimum_sphere(points).exact_radius; }, 0, {}},
        {"CGAL",
         [&] {
           using Traits = CGAL::Min_sphere_of_points_d_traits_3<Kernel, double>;
           return CGAL::Min_sphere_of_spheres_d<Traits>(given.begin(), given.end()).radius();
         },
         0,
         {}}},
       3 * repeats);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 3;
  fmt::print("{} points, processor time, median of {} runs (spheres: {})\n", count, repeats,
             3 * repeats);
  for (const char* kind : {"cube", "ball", "surface"}) race_all(kind, count, std::max(repeats, 1));
  return 0;
}
