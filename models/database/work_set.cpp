// SPDX-License-Identifier: MIT
#include "models/database/work_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace cigsim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::array<double, 3> coordinates(const Vec3& v) { return {v.x, v.y, v.z}; }

// The filter of a side test over a whole box: sign of n·(x - p) when it is the same all over.
int box_side(const Plane& plane, const WorkItem& item) {
  const std::array<double, 3> n = coordinates(plane.normal), e = coordinates(plane.error),
                              p = coordinates(plane.exact.p);
  double low = 0, high = 0, bound = 0;
  for (int i = 0; i < 3; ++i) {
    const double a = item.low[i] - p[i], b = item.high[i] - p[i];
    low += std::min(n[i] * a, n[i] * b);
    high += std::max(n[i] * a, n[i] * b);
    bound += std::max(std::abs(a), std::abs(b)) * e[i];
  }
  if (low > 2 * bound && low > 0x1p-900) return 1;
  if (high < -2 * bound && high < -0x1p-900) return -1;
  return 0;
}

}  // namespace

void WorkSet::add_polygon(const std::vector<std::uint32_t>& corners, std::uint32_t plane,
                          const FaceOrigin& origin) {
  polygons.push_back({static_cast<std::uint32_t>(corners_.size()),
                      static_cast<std::uint32_t>(corners.size()), plane, origin});
  corners_.insert(corners_.end(), corners.begin(), corners.end());
}

std::uint32_t WorkSet::add_item(std::uint32_t count) {
  WorkItem item;
  item.first_polygon = static_cast<std::uint32_t>(polygons.size()) - count;
  item.polygon_count = count;
  item.low.fill(kInfinity);
  item.high.fill(-kInfinity);
  for (std::uint32_t p = item.first_polygon; p < polygons.size(); ++p)
    for (std::uint32_t c = 0; c < polygons[p].corner_count; ++c) {
      const std::uint32_t v = corners(polygons[p])[c];
      const std::array<double, 3> x = coordinates(vertices_[v]);
      const bool rounded = exact(v) != nullptr;
      for (int i = 0; i < 3; ++i) {
        item.low[i] = std::min(item.low[i], rounded ? std::nextafter(x[i], -kInfinity) : x[i]);
        item.high[i] = std::max(item.high[i], rounded ? std::nextafter(x[i], kInfinity) : x[i]);
      }
    }
  items.push_back(item);
  return static_cast<std::uint32_t>(items.size() - 1);
}

double WorkSet::contact_tolerance_of(const WorkItem& item, double depth) const {
  double largest = 0;
  for (int i = 0; i < 3; ++i)
    largest = std::max({largest, std::abs(item.low[i]), std::abs(item.high[i])});
  return std::min(contact_tolerance * largest, 0x1p-16 * depth);
}

bool WorkSet::reaches(const Plane& plane, const WorkItem& item) const {
  return box_side(plane, item) == 0;
}

int WorkSet::classify(const Plane& plane, const WorkItem& item, std::uint32_t face_plane,
                      bool* tolerated) const {
  if (tolerated) *tolerated = false;
  if (const int s = box_side(plane, item)) return s;
  seen_.resize(vertices_.size(), 0);
  if (++call_ == 0) {
    std::fill(seen_.begin(), seen_.end(), 0);
    call_ = 1;
  }
  const std::uint32_t end = item.first_polygon + item.polygon_count;
  if (face_plane != kNothing)
    for (std::uint32_t p = item.first_polygon; p < end; ++p)
      if (polygons[p].plane == face_plane)
        for (std::uint32_t c = 0; c < polygons[p].corner_count; ++c)
          seen_[corners(polygons[p])[c]] = call_;
  bool positive = false, negative = false;
  for (std::uint32_t p = item.first_polygon; p < end; ++p)
    for (std::uint32_t c = 0; c < polygons[p].corner_count; ++c) {
      const std::uint32_t v = corners(polygons[p])[c];
      if (seen_[v] == call_) continue;
      seen_[v] = call_;
      const int s = side_of(plane, v);
      positive = positive || s > 0;
      negative = negative || s < 0;
      if (!positive || !negative) continue;
      const int where = across_or_touching(plane, item);
      if (tolerated) *tolerated = where != 2;
      return where;
    }
  return positive ? 1 : negative ? -1 : 0;
}

int WorkSet::across_or_touching(const Plane& plane, const WorkItem& item) const {
  // Depths in doubles cannot tell nothing from an overlap below their rounding.
  if (contact_tolerance == 0) return 2;
  double high = 0, low = 0;
  for (std::uint32_t p = item.first_polygon; p < item.first_polygon + item.polygon_count; ++p)
    for (std::uint32_t c = 0; c < polygons[p].corner_count; ++c) {
      const double value = dot(plane.normal, vertices_[corners(polygons[p])[c]] - plane.exact.p);
      high = std::max(high, value);
      low = std::max(low, -value);
    }
  const Vec3& n = plane.normal;
  const double length = std::hypot(n.x, n.y, n.z);
  high /= length;
  low /= length;
  if (high > low && low <= contact_tolerance_of(item, high)) return 1;
  if (low > high && high <= contact_tolerance_of(item, low)) return -1;
  return 2;
}

std::uint32_t WorkSet::cut_vertex(const Plane& plane, const ExactVec& normal, std::uint32_t a,
                                  std::uint32_t b) {
  const ExactVec pa = exact_position(a), pb = exact_position(b);
  const ExactVec origin = convert<Exact>(plane.exact.p);
  const Exact da = dot(normal, pa - origin), db = dot(normal, pb - origin);
  const ExactVec at = pa + (pb - pa) * Exact(da / (da - db));
  const Vec3 rounded{at.x.get_d(), at.y.get_d(), at.z.get_d()};
  const std::uint32_t v = add_vertex(rounded);
  first_cut_ = std::min(first_cut_, v);
  if (!(convert<Exact>(rounded) == at)) exact_.emplace(v, at);
  return v;
}

std::array<std::uint32_t, 2> WorkSet::cut(const Plane& plane, std::uint32_t item_index) {
  const WorkItem item = items[item_index];
  const ExactVec normal = exact_normal(plane);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> made;
  struct Part {
    std::vector<std::uint32_t> corners;
    std::uint32_t plane;
    FaceOrigin origin;
  };
  std::array<std::vector<Part>, 2> parts;
  std::vector<int> sides;
  for (std::uint32_t p = item.first_polygon; p < item.first_polygon + item.polygon_count; ++p) {
    const WorkPolygon polygon = polygons[p];
    const std::uint32_t n = polygon.corner_count;
    const std::vector<std::uint32_t> loop(corners(polygon), corners(polygon) + n);
    sides.clear();
    for (const std::uint32_t v : loop) sides.push_back(side_of(plane, v));
    std::array<std::vector<std::uint32_t>, 2> halves;
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = (i + 1) % n;
      if (sides[i] >= 0) halves[0].push_back(loop[i]);
      if (sides[i] <= 0) halves[1].push_back(loop[i]);
      if (sides[i] * sides[j] >= 0) continue;
      const auto key = std::minmax(loop[i], loop[j]);
      auto at = made.find(key);
      if (at == made.end())
        at = made.emplace(key, cut_vertex(plane, normal, key.first, key.second)).first;
      halves[0].push_back(at->second);
      halves[1].push_back(at->second);
    }
    const bool front = std::any_of(sides.begin(), sides.end(), [](int s) { return s > 0; });
    const bool back = std::any_of(sides.begin(), sides.end(), [](int s) { return s < 0; });
    if (front) parts[0].push_back({std::move(halves[0]), polygon.plane, polygon.origin});
    if (back || !front) parts[1].push_back({std::move(halves[1]), polygon.plane, polygon.origin});
  }
  std::array<std::uint32_t, 2> made_items{};
  for (int half = 0; half < 2; ++half) {
    for (const Part& part : parts[half]) add_polygon(part.corners, part.plane, part.origin);
    made_items[half] = add_item(static_cast<std::uint32_t>(parts[half].size()));
  }
  return made_items;
}

bool WorkSet::lies_in(const Plane& plane, const WorkPolygon& polygon) const {
  for (std::uint32_t c = 0; c < polygon.corner_count; ++c)
    if (side_of(plane, corners(polygon)[c]) != 0) return false;
  return true;
}

std::array<std::uint32_t, 2> WorkSet::detach(const Plane& plane, std::uint32_t item_index,
                                             unsigned sides) {
  const WorkItem item = items[item_index];
  std::vector<WorkPolygon> in, rest;
  for (std::uint32_t p = 0; p < item.polygon_count; ++p) {
    const WorkPolygon& polygon = polygons[item.first_polygon + p];
    const bool take = (seen_from(plane, polygon) & sides) != 0 && lies_in(plane, polygon);
    (take ? in : rest).push_back(polygon);
  }
  if (in.empty() || rest.empty()) return {item_index, kNothing};
  std::array<std::uint32_t, 2> made{};
  polygons.insert(polygons.end(), rest.begin(), rest.end());
  made[0] = add_item(static_cast<std::uint32_t>(rest.size()));
  polygons.insert(polygons.end(), in.begin(), in.end());
  made[1] = add_item(static_cast<std::uint32_t>(in.size()));
  return made;
}

std::vector<std::uint32_t> WorkSet::explode(std::uint32_t item_index) {
  const WorkItem item = items[item_index];
  std::vector<std::uint32_t> made;
  for (std::uint32_t p = item.first_polygon; p < item.first_polygon + item.polygon_count; ++p) {
    const WorkPolygon polygon = polygons[p];
    polygons.push_back(polygon);
    made.push_back(add_item(1));
  }
  return made;
}

}  // namespace cigsim
