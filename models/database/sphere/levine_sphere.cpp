// SPDX-License-Identifier: MIT
// Levine's smallest sphere (1975, ch. V), with his counts (app. II).
//
// His loops try a three-point sphere only while a fourth point is at hand, so that no triple with
// the last point of all is ever tried: a smallest sphere on such a triple is missed, and with three
// points alone nothing is searched. Here one more turn of the outer loop tries those triples.
#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

#include "models/database/sphere/sphere.hpp"
#include "models/database/sphere/sphere_result.hpp"
#include "models/database/sphere/sphere_through.hpp"

namespace cigsim {
namespace {

// Places in hull.vertices, sharpest first.
std::vector<std::uint32_t> by_sharpness(std::span<const Vec3> points, const Hull& hull) {
  const std::vector<double> angles = solid_angles(points, hull);
  std::vector<std::uint32_t> order(hull.vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return angles[a] < angles[b]; });
  return order;
}

class LevineSearch {
 public:
  LevineSearch(std::span<const Vec3> points, const Hull& hull, const LevineSphereOptions& options)
      : points_(points), options_(options), solid_(hull.dimension == 3) {
    for (const std::uint32_t place : by_sharpness(points, hull))
      order_.push_back(hull.vertices[place]);
    const auto h = static_cast<double>(order_.size());
    result_.hull_points = order_.size();
    result_.spheres_expected =
        (h * (h - 1) * (h - 2) * (h - 3) / 24 + h * (h - 1) * (h - 2) / 6 + 1) / 2;
  }

  LevineSphere run() {
    if (order_.size() == 1) {
      accept(SphereThrough(points_, std::array{order_[0]}), std::array<std::size_t, 1>{1});
    } else {
      const auto pair = farthest_pair();
      if (!try_sphere(pair)) search();
    }
    return result_;
  }

 private:
  // The loops of his step 3, with his names and counted from 1.
  void search() {
    const std::size_t n = order_.size(), last = std::min(options_.last_point.value_or(n), n);
    // The turn after the last one has no fourth point.
    const std::size_t turns = last == n && !options_.published_loops ? n + 1 : last;
    for (std::size_t l = 4; l <= turns; ++l)
      for (std::size_t i = 1; i + 3 <= l; ++i)
        for (std::size_t j = i + 1; j + 2 <= l; ++j)
          for (std::size_t k = l <= n ? j + 1 : n; k + 1 <= l; ++k) {
            if (k + 1 == l && try_sphere(std::array{i, j, k})) return;
            if (solid_ && l <= n && try_sphere(std::array{i, j, k, l})) return;
          }
  }

  // Exactly the two points farthest apart: where doubles cannot tell, whole numbers do.
  std::array<std::size_t, 2> farthest_pair() const {
    // Squares below the underflow room are not worth comparing.
    double most = largest_distance();
    if (most < 0x1p-900) most = 0;
    std::array<std::size_t, 2> best{1, 2};
    Whole best_distance = -1;
    for_each_pair([&](std::size_t i, std::size_t j, double distance) {
      if (distance < most * (1 - 0x1p-44)) return;
      const WholeVec d = points_.whole(order_[i]) - points_.whole(order_[j]);
      const Whole squared = dot(d, d);
      if (squared <= best_distance) return;
      best_distance = squared;
      best = {i + 1, j + 1};
    });
    return best;
  }

  double largest_distance() const {
    double most = 0;
    for_each_pair([&](std::size_t, std::size_t, double d) { most = std::max(most, d); });
    return most;
  }

  template <class Visit>
  void for_each_pair(const Visit& visit) const {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const Vec3 a = points_.work()[order_[i]];
      for (std::size_t j = i + 1; j < order_.size(); ++j) {
        const Vec3 d = points_.work()[order_[j]] - a;
        visit(i, j, dot(d, d));
      }
    }
  }

  template <std::size_t N>
  bool try_sphere(const std::array<std::size_t, N>& place) {
    std::array<std::uint32_t, N> support;
    for (std::size_t i = 0; i < N; ++i) support[i] = order_[place[i] - 1];
    const SphereThrough sphere(points_, support);
    ++result_.spheres_created;
    if (!sphere.is_smallest()) return false;
    ++result_.spheres_tested;
    for (const std::uint32_t point : order_) {
      ++result_.tests;
      if (!sphere.holds(point)) return false;
    }
    accept(sphere, place);
    return true;
  }

  template <std::size_t N>
  void accept(const SphereThrough& sphere, const std::array<std::size_t, N>& place) {
    result_.sphere = rounded(sphere);
    for (const std::size_t p : place) result_.selected.push_back(static_cast<std::uint32_t>(p));
  }

  SpherePoints points_;
  LevineSphereOptions options_;
  bool solid_;
  std::vector<std::uint32_t> order_;  // hull points, sharpest first
  LevineSphere result_;
};

}  // namespace

LevineSphere levine_sphere(std::span<const Vec3> points, const Hull& hull,
                           const LevineSphereOptions& options) {
  if (hull.vertices.empty()) throw std::invalid_argument("a sphere needs a point");
  return LevineSearch(points, hull, options).run();
}

}  // namespace cigsim
