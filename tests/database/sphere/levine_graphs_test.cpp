// SPDX-License-Identifier: MIT
// What Levine's text says of his graphs (1975, app. I and II), on fewer cases than his 500.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "models/database/sphere/sphere.hpp"
#include "models/environment/point_sets.hpp"

namespace cigsim {
namespace {

constexpr std::uint64_t kSeed = 1975;

// Means over some cases of one size.
struct HullMeans {
  double points = 0, tests = 0, equivalent = 0;  // NPTH, NT/NPTH, NEQ/NPTH
};

HullMeans hull_means(PointDistribution d, std::uint32_t count, std::uint32_t cases) {
  HullMeans means;
  for (std::uint32_t number = 0; number < cases; ++number) {
    const auto points = random_points(d, count, kSeed, number);
    const Hull hull = levine_hull(points);
    const double h = static_cast<double>(hull.vertices.size()) * cases;
    means.points += h / cases / cases;
    means.tests += static_cast<double>(hull.counters.tests) / h;
    means.equivalent += static_cast<double>(equivalent_tests(count, hull.triangles.size())) / h;
  }
  return means;
}

// His fit: m of y = 10^b x^m, least squares of the logarithms of the last four sizes.
struct Fit {
  double sx = 0, sy = 0, sxx = 0, sxy = 0, n = 0;
  void add(double x, double y) {
    x = std::log10(x);
    y = std::log10(y);
    sx += x, sy += y, sxx += x * x, sxy += x * y, ++n;
  }
  double slope() const { return (n * sxy - sx * sy) / (n * sxx - sx * sx); }
};

struct Fits {
  double points, tests, equivalent;
};
Fits fits_of(PointDistribution d, std::uint32_t cases) {
  Fit points, tests, equivalent;
  const auto sizes = published_sizes(d);
  for (const std::uint32_t count : sizes.last(4)) {
    const HullMeans means = hull_means(d, count, cases);
    points.add(count, means.points);
    tests.add(count, means.tests);
    equivalent.add(count, means.equivalent);
  }
  return {points.slope(), tests.slope(), equivalent.slope()};
}

std::vector<LevineSphere> spheres_of(PointDistribution d, std::uint32_t count,
                                     std::uint32_t cases) {
  std::vector<LevineSphere> spheres;
  for (std::uint32_t number = 0; number < cases; ++number) {
    const auto points = random_points(d, count, kSeed, number);
    spheres.push_back(levine_sphere(points, convex_hull(points)));
  }
  return spheres;
}

template <class Value>
double middle(const std::vector<LevineSphere>& spheres, const Value& value) {
  std::vector<double> values;
  for (const LevineSphere& s : spheres) values.push_back(value(s));
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

// App. I: hull points of the cubes grow as n^.29 (σ = 1) and n^.20 (σ = 4).
TEST(LevineGraphs, HullPointsOfTheCubesGrowAsPublished) {
  EXPECT_NEAR(fits_of(PointDistribution::kCube1, 40).points, 0.29, 0.03);
  EXPECT_NEAR(fits_of(PointDistribution::kCube4, 40).points, 0.20, 0.03);
}

// App. I: NT/NPTH grows about as n^.75, Chand and Kapur's as n; near ten times fewer at 3200.
TEST(LevineGraphs, TestsAHullPointGrowAsPublished) {
  for (const PointDistribution d : kPointDistributions) {
    SCOPED_TRACE(name_of(d));
    const Fits fits = fits_of(d, 12);
    EXPECT_NEAR(fits.tests, 0.75, 0.13);
    EXPECT_NEAR(fits.equivalent, 1, 0.05);
    const HullMeans largest = hull_means(d, published_sizes(d).back(), 12);
    EXPECT_GT(largest.equivalent / largest.tests, 7);
    EXPECT_LT(largest.equivalent / largest.tests, 17);
  }
}

// App. II: of the ellipse's 1600 points half the cases need one sphere, about 10^7 expected.
TEST(LevineGraphs, OneSphereIsEnoughForHalfTheEllipses) {
  const auto spheres = spheres_of(PointDistribution::kEllipse, 1600, 41);
  EXPECT_EQ(middle(spheres, [](const auto& s) { return double(s.spheres_created); }), 1);
  const double expected = middle(spheres, [](const auto& s) { return s.spheres_expected; });
  EXPECT_GT(expected, 0.7e7);
  EXPECT_LT(expected, 4e7);
}

// App. II: point 1 is on the smallest sphere of at least half the σ = 1 cubes, at every size.
TEST(LevineGraphs, TheSharpestPointTakesPartForHalfTheCubes) {
  for (const std::uint32_t count : published_sizes(PointDistribution::kCube1)) {
    int with_first = 0;
    for (const LevineSphere& s : spheres_of(PointDistribution::kCube1, count, 40))
      with_first += !s.selected.empty() && s.selected.front() == 1;
    EXPECT_GE(with_first, 20) << count;
  }
}

// App. II: NT/NPTH is practically constant for the cubes and grows with n for the σ = 1 sphere.
TEST(LevineGraphs, SphereTestsStayConstantForCubesAndGrowForTheSphere) {
  const auto tests = [](const LevineSphere& s) {
    return s.sphere ? double(s.tests) / double(s.hull_points) : 1e9;
  };
  for (const auto d :
       {PointDistribution::kCube1, PointDistribution::kCube2, PointDistribution::kCube4})
    for (const std::uint32_t count : published_sizes(d)) {
      const double middle_tests = middle(spheres_of(d, count, 41), tests);
      EXPECT_GE(middle_tests, 1) << name_of(d) << ' ' << count;
      EXPECT_LE(middle_tests, 2) << name_of(d) << ' ' << count;
    }
  const double few = middle(spheres_of(PointDistribution::kSphere1, 50, 41), tests),
               many = middle(spheres_of(PointDistribution::kSphere1, 400, 41), tests);
  EXPECT_GT(many, 3 * few);
}

// App. II: the σ = 1 sphere is the worst case; of 800 points 40 % of the cases found no sphere by
// point 26. With the generator here it is 54 % of 500 cases.
TEST(LevineGraphs, ManySpheresOf800PointsAreGivenUp) {
  int given_up = 0;
  for (const LevineSphere& s : spheres_of(PointDistribution::kSphere1, 800, 60))
    given_up += !s.sphere;
  EXPECT_GT(given_up, 60 * 3 / 10);
  EXPECT_LT(given_up, 60 * 7 / 10);
}

}  // namespace
}  // namespace cigsim
