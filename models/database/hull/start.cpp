// SPDX-License-Identifier: MIT
#include "models/database/hull/start.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim {
namespace {

constexpr std::size_t kDirections = 7;

std::array<double, kDirections> distances(const Vec3& p) {
  return {p.x, p.y, p.z, p.x + p.y + p.z, -p.x + p.y + p.z, p.x + p.y - p.z, -p.x + p.y - p.z};
}

// The first point that differs from point a, or a.
std::uint32_t other_than(const ExactPoints& points, std::uint32_t a,
                         const std::vector<std::uint32_t>& extreme) {
  for (const std::uint32_t i : extreme)
    if (!(points.original(i) == points.original(a))) return i;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (!(points.original(i) == points.original(a))) return i;
  return a;
}

// The first point that is not on the line through a and b, or a.
std::uint32_t off_the_line(const ExactPoints& points, std::uint32_t a, std::uint32_t b,
                           const std::vector<std::uint32_t>& extreme) {
  for (const std::uint32_t i : extreme)
    if (!points.collinear(a, b, i)) return i;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (!points.collinear(a, b, i)) return i;
  return a;
}

struct Farthest {
  std::uint32_t point;
  int side;  // exactly; 0: every point is on the plane
};

Farthest farthest_from(const ExactPoints& points, std::uint32_t a, std::uint32_t b,
                       std::uint32_t c) {
  const FilterPlane plane = points.plane(a, b, c);
  Farthest best{a, 0};
  double distance = plane.bound;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const double value = plane.value(points.scaled(i));
    if (std::abs(value) > distance) {
      distance = std::abs(value);
      best = {i, value > 0 ? 1 : -1};
    }
  }
  if (best.side != 0) return best;
  std::uint64_t exact = 0;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (const int side = points.side(a, b, c, i, exact)) return {i, side};
  return best;
}

}  // namespace

std::vector<std::uint32_t> extreme_points(const ExactPoints& points) {
  if (points.size() == 0) return {};
  std::array<std::uint32_t, kDirections> high{}, low{};
  std::array<double, kDirections> most = distances(points.scaled(0)), least = most;
  for (std::uint32_t i = 1; i < points.size(); ++i) {
    const auto d = distances(points.scaled(i));
    for (std::size_t k = 0; k < kDirections; ++k) {
      if (d[k] > most[k]) most[k] = d[k], high[k] = i;
      if (d[k] < least[k]) least[k] = d[k], low[k] = i;
    }
  }
  std::vector<std::uint32_t> extreme;
  for (std::size_t k = 0; k < kDirections; ++k)
    for (const std::uint32_t i : {high[k], low[k]})
      if (std::find(extreme.begin(), extreme.end(), i) == extreme.end()) extreme.push_back(i);
  return extreme;
}

HullStart find_start(const ExactPoints& points, const std::vector<std::uint32_t>& extreme) {
  HullStart start;
  if (points.size() == 0) return start;
  const std::uint32_t a = extreme.front(), b = other_than(points, a, extreme);
  start.dimension = 0;
  start.corner = {a, a, a, a};
  if (b == a) return start;
  const std::uint32_t c = off_the_line(points, a, b, extreme);
  start.dimension = 1;
  start.corner = {a, b, a, a};
  if (c == a) return start;
  const Farthest d = farthest_from(points, a, b, c);
  start.tests = points.size();
  start.dimension = 2;
  start.corner = {a, b, c, a};
  if (d.side == 0) {
    while (points.turn(start.axis, a, b, c) == 0) ++start.axis;
    return start;
  }
  start.dimension = 3;
  // The fourth point has to see the others run clockwise.
  start.corner = d.side < 0 ? std::array{a, b, c, d.point} : std::array{b, a, c, d.point};
  return start;
}

}  // namespace cigsim
