// SPDX-License-Identifier: MIT
#include "sim/stability/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/stability/directions.hpp"

namespace cigsim::stability {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// An eyepoint level with a plane across an axis, at a coordinate of so few bits beside the largest
// one that every format holds it: equal coordinates stay equal, and no rounding parts the two.
bool level_with(const Plane& plane, const Vec3& eye, double largest) {
  constexpr int kBits = 20;
  if (!(largest > 0)) return false;
  const Vec3 &n = plane.normal, &p = plane.exact.p;
  const auto held = [&](double a, double b) {
    const double whole = std::ldexp(a, kBits - std::ilogb(largest));
    return a == b && whole == std::floor(whole);
  };
  if (n.y == 0 && n.z == 0) return held(p.x, eye.x);
  if (n.x == 0 && n.z == 0) return held(p.y, eye.y);
  return n.x == 0 && n.y == 0 && held(p.z, eye.z);
}

double height(const Plane& plane, const Vec3& eye, double largest) {
  const Vec3 n = direction_of(plane.normal);
  if (n == Vec3{} || level_with(plane, eye, largest)) return kInfinity;
  return std::abs(dot(n, eye - plane.exact.p));
}

double to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = direction_of(b - a);
  const double t = std::clamp(dot(p - a, along), 0.0, length(b - a));
  return length(p - (a + along * t));
}

double to_face(const FaceSet& set, const Item& item, const PreparedFace& face, const Vec3& eye) {
  const Vec3 n = direction_of(set.planes[face.plane].normal);
  const auto corner = [&](std::uint32_t c) {
    return set.vertices[item.first_vertex + set.corners[face.first_corner + c]];
  };
  double nearest = kInfinity;
  bool inside = true;
  for (std::uint32_t c = 0; c < face.corner_count; ++c) {
    const Vec3 a = corner(c), b = corner((c + 1) % face.corner_count);
    inside = inside && dot(cross(n, direction_of(b - a)), eye - a) >= 0;
    nearest = std::min(nearest, to_segment(eye, a, b));
  }
  return inside ? std::abs(dot(n, eye - corner(0))) : nearest;
}

bool reaches_out(const FaceSet& set, const Item& item, const PreparedFace& face,
                 const ViewTransform& view) {
  for (std::uint32_t c = 0; c < face.corner_count; ++c) {
    const Vec3 p =
        view.rotation *
        (set.vertices[item.first_vertex + set.corners[face.first_corner + c]] - view.eye);
    if (std::abs(p.y) * view.focal > p.x * view.raster.width / 2 ||
        std::abs(p.z) * view.focal > p.x * view.raster.height / 2 || !(p.x > 0))
      return true;
  }
  return false;
}

// Distances of the nearest face, and of the nearest one that reaches out of the pyramid.
struct Nearest {
  double face = kInfinity, cut = kInfinity;
};

Nearest nearest_faces(const std::array<const FaceSet*, 3>& sets, const std::vector<ItemRef>& items,
                      const ViewTransform& view) {
  struct Candidate {
    double bound;  // no point of the item is nearer
    ItemRef ref;
  };
  std::vector<Candidate> candidates;
  for (const ItemRef& ref : items) {
    const Sphere& sphere = sets[static_cast<std::size_t>(ref.set)]->items[ref.item].sphere;
    candidates.push_back({length(sphere.centre - view.eye) - sphere.radius, ref});
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.bound < b.bound; });
  Nearest nearest;
  for (const Candidate& candidate : candidates) {
    if (candidate.bound > nearest.cut) break;  // a cut face is a face
    const FaceSet& set = *sets[static_cast<std::size_t>(candidate.ref.set)];
    const Item& item = set.items[candidate.ref.item];
    for (std::uint32_t f = item.first_face; f < item.first_face + item.face_count; ++f) {
      const double distance = to_face(set, item, set.faces[f], view.eye);
      nearest.face = std::min(nearest.face, distance);
      if (distance < nearest.cut && reaches_out(set, item, set.faces[f], view))
        nearest.cut = distance;
    }
  }
  return nearest;
}

double nearest_separation(const Database& database, const ActiveEnvironment& active,
                          double largest) {
  const PriorityHierarchy& hierarchy = database.systems[0].hierarchy;
  double least = kInfinity;
  for (const ActiveGroup& in_view : active.groups) {
    const Group& group = hierarchy.groups[in_view.group];
    for (std::uint32_t n = group.first_node; n < group.first_node + group.node_count; ++n) {
      const SeparationNode& node = hierarchy.nodes[n];
      if ((node.true_members & in_view.active) && (node.false_members & in_view.active))
        least = std::min(least, height(hierarchy.planes[node.plane], active.view.eye, largest));
    }
  }
  return least;
}

double nearest_face_plane(const std::array<const FaceSet*, 3>& sets,
                          const std::vector<ItemRef>& items, const Vec3& eye, double largest) {
  double least = kInfinity;
  for (const ItemRef& ref : items) {
    const FaceSet& set = *sets[static_cast<std::size_t>(ref.set)];
    const Item& item = set.items[ref.item];
    for (std::uint32_t f = item.first_face; f < item.first_face + item.face_count; ++f)
      least = std::min(least, height(set.planes[set.faces[f].plane], eye, largest));
  }
  return least;
}

}  // namespace

Measures& Measures::operator|=(const Measures& other) {
  smallest = std::min(smallest, other.smallest);
  largest = std::max(largest, other.largest);
  demand = std::max(demand, other.demand);
  lines = std::max(lines, other.lines);
  cut = std::max(cut, other.cut);
  nearness = std::min(nearness, other.nearness);
  clearance = std::min(clearance, other.clearance);
  return *this;
}

Measures measures_of(const Database& database, const ActiveEnvironment& active,
                     const FaceSet& moving, const std::vector<ItemRef>& items) {
  const std::array<const FaceSet*, 3> sets{&database.systems[0].set, &moving, &database.ground};
  const ViewTransform& view = active.view;
  Measures m;
  m.smallest = kInfinity;
  m.largest = largest_coordinate(view.eye);
  m.lines = std::max(view.raster.width, view.raster.height);
  for (const ItemRef& ref : items) {
    const Sphere& sphere = sets[static_cast<std::size_t>(ref.set)]->items[ref.item].sphere;
    m.smallest = std::min(m.smallest, sphere.radius);
    m.largest = std::max(m.largest, largest_coordinate(sphere.centre) + sphere.radius);
  }
  const Nearest nearest = nearest_faces(sets, items, view);
  m.demand = m.largest / nearest.face * view.focal;
  m.cut = m.largest / nearest.cut * view.focal;
  m.nearness = nearest.face / m.largest;
  m.clearance = std::min(nearest_face_plane(sets, items, view.eye, m.largest),
                         nearest_separation(database, active, m.largest)) /
                m.largest;
  return m;
}

}  // namespace cigsim::stability
