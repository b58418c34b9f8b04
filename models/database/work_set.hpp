// SPDX-License-Identifier: MIT
// The working set of preparation: polygons over a pool of vertices, gathered into items that the
// partition separates and, where it must, cuts. Cut vertices keep their exact coordinates, so that
// every later side test is exact however often a polygon has been cut.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "models/environment/environment.hpp"
#include "models/numeric/plane.hpp"

namespace cigsim {

/// What a polygon keeps of the face it came from.
struct FaceOrigin {
  std::uint32_t object = 0;  ///< number, from 1
  std::uint32_t order = 0;   ///< place among all faces of the system: earlier wins where coplanar
  Colour colour;
  bool two_sided = false;
};

struct WorkPolygon {
  std::uint32_t first_corner = 0, corner_count = 0;
  std::uint32_t plane = 0;
  FaceOrigin origin;
};

/// Consecutive polygons of one convex object, so that their order does not matter, or a single one.
struct WorkItem {
  std::uint32_t first_polygon = 0, polygon_count = 0;
  std::array<double, 3> low{}, high{};  ///< contains every vertex, exactly
  /// Of a composite (detail/composite.hpp): polygons are among its parts by themselves.
  bool flat_parts = false;
};

class WorkSet {
 public:
  static constexpr std::uint32_t kNothing = 0xffffffffu;

  std::vector<Plane> planes;
  std::vector<WorkPolygon> polygons;
  std::vector<WorkItem> items;

  std::uint32_t add_vertex(const Vec3& v) {
    vertices_.push_back(v);
    return static_cast<std::uint32_t>(vertices_.size() - 1);
  }
  std::uint32_t add_plane(const Plane& plane) {
    planes.push_back(plane);
    return static_cast<std::uint32_t>(planes.size() - 1);
  }
  /// Corners are vertices of the pool.
  void add_polygon(const std::vector<std::uint32_t>& corners, std::uint32_t plane,
                   const FaceOrigin& origin);
  /// Makes an item of the last `count` polygons.
  std::uint32_t add_item(std::uint32_t count);

  const Vec3& vertex(std::uint32_t v) const { return vertices_[v]; }
  std::size_t vertex_count() const { return vertices_.size(); }
  /// The exact position of a cut vertex, or nullptr when the double is exact.
  const ExactVec* exact(std::uint32_t v) const {
    if (v < first_cut_) return nullptr;
    const auto at = exact_.find(v);
    return at == exact_.end() ? nullptr : &at->second;
  }
  const std::uint32_t* corners(const WorkPolygon& p) const { return &corners_[p.first_corner]; }

  int side_of(const Plane& plane, std::uint32_t v) const {
    const ExactVec* e = exact(v);
    return e ? side(plane, vertices_[v], *e) : side(plane, vertices_[v]);
  }

  /// How far an item may reach across a plane and still count as touching it, as a share of its
  /// largest coordinate (see PrepareOptions). Never more than 2^-16 of its depth on the other side.
  double contact_tolerance = 0;
  double contact_tolerance_of(const WorkItem& item, double depth) const;

  /// Where an item lies: +1 on the closed positive side, -1 on the closed negative side, 0 in the
  /// plane, 2 across it. Within the contact tolerance it counts as on the side of its body;
  /// `tolerated`, when given, tells of that. `face_plane` is the plane's index in `planes` when it
  /// is a face's: the corners of that face need no test.
  int classify(const Plane& plane, const WorkItem& item, std::uint32_t face_plane = kNothing,
               bool* tolerated = nullptr) const;

  /// False when the item's box shows that none of its points lies in the plane.
  bool reaches(const Plane& plane, const WorkItem& item) const;

  /// Adds the two parts of an item that lies across the plane; returns {positive, negative}.
  std::array<std::uint32_t, 2> cut(const Plane& plane, std::uint32_t item);

  /// True when the polygon lies in the plane, exactly.
  bool lies_in(const Plane& plane, const WorkPolygon& polygon) const;

  /// The sides from which polygons in the plane are seen: bit 0 the normal's, bit 1 the other.
  unsigned seen_from(const Plane& plane, const WorkPolygon& polygon) const {
    if (polygon.origin.two_sided) return 3;
    return dot(planes[polygon.plane].normal, plane.normal) > 0 ? 1 : 2;
  }
  unsigned seen_from(const Plane& plane, const WorkItem& item) const {
    unsigned sides = 0;
    for (std::uint32_t p = 0; p < item.polygon_count; ++p)
      sides |= seen_from(plane, polygons[item.first_polygon + p]);
    return sides;
  }

  /// Parts the polygons of an item that lie in the plane and are seen from one of `sides` from its
  /// others; returns {the rest, an item of those}, or the item itself and kNothing when there is
  /// none.
  std::array<std::uint32_t, 2> detach(const Plane& plane, std::uint32_t item, unsigned sides);

  /// Adds one item for each polygon of an item.
  std::vector<std::uint32_t> explode(std::uint32_t item);

 private:
  int across_or_touching(const Plane& plane, const WorkItem& item) const;
  std::uint32_t cut_vertex(const Plane& plane, const ExactVec& normal, std::uint32_t a,
                           std::uint32_t b);
  ExactVec exact_position(std::uint32_t v) const {
    const ExactVec* e = exact(v);
    return e ? *e : convert<Exact>(vertices_[v]);
  }

  std::vector<Vec3> vertices_;
  std::uint32_t first_cut_ = 0xffffffffu;
  std::unordered_map<std::uint32_t, ExactVec> exact_;
  std::vector<std::uint32_t> corners_;
  // By vertex: the call of classify that has dealt with it last.
  mutable std::vector<std::uint32_t> seen_;
  mutable std::uint32_t call_ = 0;
};

}  // namespace cigsim
