// SPDX-License-Identifier: MIT
// The smallest enclosing sphere by pivots, after Gärtner ("Fast and Robust Smallest Enclosing
// Balls", 1999) and Welzl (1991).
//
// The sphere always is the exact smallest one of a few support points. A pivot takes a point
// outside and finds the smallest sphere of the support and that point by trying each set of at most
// four of them, exactly. As the radius grows with every pivot the search ends, however many points
// lie on one sphere. Pivots go on among few points, first a sample, then those that stuck out of
// each block of a pass over all, so that two or three passes are enough.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "models/database/sphere/rounding.hpp"
#include "models/database/sphere/sphere.hpp"
#include "models/database/sphere/sphere_result.hpp"
#include "models/database/sphere/sphere_scan.hpp"
#include "models/database/sphere/sphere_through.hpp"

namespace cigsim {
namespace {

constexpr std::size_t kSample = 1024;

TwoDoubles two_doubles(const Exact& value) {
  const double high = value.get_d();
  return {high, Exact(value - Exact(high)).get_d()};
}

class Search {
 public:
  explicit Search(const SpherePoints& points) : points_(points), sphere_(points, std::array{0u}) {
    measure();
  }

  void run() {
    std::vector<std::uint32_t> sample;
    const std::size_t step = std::max<std::size_t>(points_.size() / kSample, 1);
    for (std::size_t i = 0; i < points_.size(); i += step)
      sample.push_back(static_cast<std::uint32_t>(i));
    solve(sample);
    if (step == 1) return;
    SphereScan scan(points_.work());
    while (solve(scan.outside(scanned_))) {
    }
    while (solve_closer(scan)) {
    }
  }

  const SphereThrough& sphere() const { return sphere_; }

 private:
  // Makes the sphere hold these points too; false when it does already.
  bool solve(const std::vector<std::uint32_t>& places) {
    if (places.empty()) return false;
    std::vector<Vec3> chosen;
    for (const std::uint32_t i : places) chosen.push_back(points_.work()[i]);
    SphereScan scan(chosen);
    bool changed = false;
    while (add_farthest(scan, places) || add_closer(scan, places)) changed = true;
    return changed;
  }

  // The same for all points, where those that doubles show outside have been dealt with.
  bool solve_closer(const SphereScan& scan) {
    const SphereScan::Closer closer = scan.closer_look(scanned_);
    if (solve(closer.outside)) return true;
    return add_doubtful(closer.doubtful);
  }

  bool add_farthest(SphereScan& scan, const std::vector<std::uint32_t>& places) {
    const SphereScan::Farthest far = scan.farthest(scanned_);
    if (far.squared_distance <= scanned_.squared_radius.high + SphereScan::band(scanned_))
      return false;
    return add_outside(places[far.point]);
  }

  bool add_closer(const SphereScan& scan, const std::vector<std::uint32_t>& places) {
    SphereScan::Closer closer = scan.closer_look(scanned_);
    if (closer.excess > 0 && add_outside(places[closer.farthest])) return true;
    for (std::uint32_t& point : closer.doubtful) point = places[point];
    return add_doubtful(closer.doubtful);
  }

  bool add_doubtful(const std::vector<std::uint32_t>& doubtful) {
    return std::any_of(doubtful.begin(), doubtful.end(), [&](std::uint32_t point) {
      return !repeats_support(point) && add_outside(point);
    });
  }

  bool repeats_support(std::uint32_t point) const {
    const auto support = sphere_.support();
    return std::any_of(support.begin(), support.end(), [&](std::uint32_t s) {
      return points_.original(s) == points_.original(point);
    });
  }

  bool add_outside(std::uint32_t point) {
    if (sphere_.holds(point)) return false;
    pivot(point);
    measure();
    return true;
  }

  // The smallest sphere of the support and one point outside goes through that point: the first set
  // with it whose own smallest sphere holds the others.
  void pivot(std::uint32_t point) {
    const std::vector<std::uint32_t> old(sphere_.support().begin(), sphere_.support().end());
    const unsigned sets = 1u << old.size();
    for (int size = 1; size <= 3; ++size)
      for (unsigned set = 1; set < sets; ++set) {
        if (std::popcount(set) != size) continue;
        std::vector<std::uint32_t> chosen{point};
        for (std::size_t i = 0; i < old.size(); ++i)
          if (set >> i & 1) chosen.push_back(old[i]);
        const SphereThrough candidate(points_, chosen);
        if (!candidate.is_smallest() || !std::all_of(old.begin(), old.end(), [&](std::uint32_t i) {
              return candidate.holds(i);
            }))
          continue;
        sphere_ = candidate;
        return;
      }
    throw std::logic_error("no sphere through the support and a point outside");
  }

  // Centre and squared radius in the units of the work points.
  void measure() {
    const ExactVec centre = sphere_.centre();
    Exact squared = sphere_.squared_radius();
    const auto scale = [&](Exact value, int exponent) {
      if (exponent >= 0)
        mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
      else
        mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
      return two_doubles(value);
    };
    const int e = points_.exponent();
    scanned_ = {scale(centre.x, e), scale(centre.y, e), scale(centre.z, e), scale(squared, 2 * e),
                points_.largest()};
  }

  const SpherePoints& points_;
  SphereThrough sphere_;
  ScannedSphere scanned_;
};

}  // namespace

BoundingSphere rounded(const SphereThrough& sphere) {
  const ExactVec centre = sphere.centre();
  const Exact squared = sphere.squared_radius();
  BoundingSphere out;
  out.centre = {nearest_double(centre.x), nearest_double(centre.y), nearest_double(centre.z)};
  const ExactVec shift = centre - convert<Exact>(out.centre);
  out.radius = sum_up(root_up(squared), root_up(dot(shift, shift)));
  out.exact_radius = root_nearest(squared);
  if (!std::isfinite(out.radius))
    throw std::invalid_argument("the sphere's radius is beyond the largest double");
  out.support.assign(sphere.support().begin(), sphere.support().end());
  std::sort(out.support.begin(), out.support.end());
  return out;
}

BoundingSphere minimum_sphere(std::span<const Vec3> given) {
  if (given.empty()) throw std::invalid_argument("a sphere needs a point");
  const SpherePoints points(given);
  Search search(points);
  search.run();
  return rounded(search.sphere());
}

}  // namespace cigsim
