// SPDX-License-Identifier: MIT
// The hull of points on one plane or line: Andrew's monotone chain (1979), seen along an axis that
// the plane does not contain.
#include <algorithm>
#include <numeric>
#include <tuple>

#include "models/database/hull/finish.hpp"

namespace cigsim {
namespace {

// Coordinates in the order axis + 1, axis + 2, axis: the last only orders points of a line.
auto key(const Vec3& p, int axis) {
  return axis == 0   ? std::tuple(p.y, p.z, p.x)
         : axis == 1 ? std::tuple(p.z, p.x, p.y)
                     : std::tuple(p.x, p.y, p.z);
}

std::vector<std::uint32_t> ends_of_line(const ExactPoints& points) {
  std::uint32_t low = 0, high = 0;
  for (std::uint32_t i = 1; i < points.size(); ++i) {
    if (key(points.original(i), 2) < key(points.original(low), 2)) low = i;
    if (key(points.original(i), 2) > key(points.original(high), 2)) high = i;
  }
  return {std::min(low, high), std::max(low, high)};
}

// One half of the polygon: from the first to the last of `order`, turning left only.
std::vector<std::uint32_t> chain(const ExactPoints& points, int axis,
                                 const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t i : order) {
    while (out.size() > 1 && points.turn(axis, out[out.size() - 2], out.back(), i) <= 0)
      out.pop_back();
    out.push_back(i);
  }
  return out;
}

std::vector<std::uint32_t> polygon(const ExactPoints& points, int axis) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto ka = key(points.original(a), axis), kb = key(points.original(b), axis);
    return ka != kb ? ka < kb : a < b;
  });
  order.erase(std::unique(order.begin(), order.end(),
                          [&](std::uint32_t a, std::uint32_t b) {
                            return points.original(a) == points.original(b);
                          }),
              order.end());
  std::vector<std::uint32_t> loop = chain(points, axis, order);
  loop.pop_back();
  std::reverse(order.begin(), order.end());
  const std::vector<std::uint32_t> back = chain(points, axis, order);
  loop.insert(loop.end(), back.begin(), back.end() - 1);
  return loop;
}

}  // namespace

Hull flat_hull(const ExactPoints& points, const HullStart& start) {
  Hull hull;
  hull.dimension = start.dimension;
  hull.counters.tests = start.tests;
  if (start.dimension == 0) hull.vertices = {start.corner[0]};
  if (start.dimension == 1) hull.vertices = ends_of_line(points);
  if (start.dimension == 2) hull.vertices = polygon(points, start.axis);
  return hull;
}

}  // namespace cigsim
