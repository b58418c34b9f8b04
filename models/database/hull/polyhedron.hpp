// SPDX-License-Identifier: MIT
// A convex polyhedron of triangles that grows by convex caps (Levine 1975, ch. IV, step 4).
//
// A face is seen from a point that lies strictly on its outer side; a point in its plane does not
// see it. With that, and exact sides, the faces seen from a point always form one patch whose rim
// is a simple cycle, and no triangle of a cap is degenerate, however many points are coplanar. What
// remains is only that corners may lie inside facets or edges of the finished hull.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "models/database/hull/exact_points.hpp"
#include "models/database/hull/hull.hpp"

namespace cigsim {

class Polyhedron {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  struct Face {
    FilterPlane plane;
    /// Anticlockwise from outside; corner[2] is the apex of the cap that made it.
    HullTriangle corner;
    /// Across the edge from corner[i] to corner[(i + 1) % 3].
    std::array<std::uint32_t, 3> neighbour;
    bool alive = false;
    std::uint32_t visit = 0;  // the cap that looked at it last
  };

  explicit Polyhedron(const ExactPoints& points)
      : points_(points), edge_face_(points.size(), kNone) {}

  /// The tetrahedron; d must see a, b, c run clockwise, strictly (side −1 of their plane).
  void start(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);

  /// Adds `apex`, which must see the face `seen`: the faces that it sees give way to a cap. They
  /// stay readable in removed() until the next call; added() are the faces of the cap.
  /// `sees(face)` decides; it is asked once for each face met.
  template <class Sees>
  void add_cap(std::uint32_t apex, std::uint32_t seen, const Sees& sees);

  std::span<const std::uint32_t> removed() const { return removed_; }
  std::span<const std::uint32_t> added() const { return added_; }

  const Face& face(std::uint32_t i) const { return faces_[i]; }
  /// Places of faces in use or used before.
  std::size_t face_places() const { return faces_.size(); }

  /// True when `point` lies strictly outside the plane of the face, exactly.
  bool sees(std::uint32_t face, std::uint32_t point) {
    const FilterPlane& plane = faces_[face].plane;
    const double value = plane.value(points_.scaled(point));
    if (value > plane.bound) return true;
    if (value < -plane.bound) return false;
    return sees_in_doubt(face, point);
  }
  /// The same for a point that the face's filter could not decide.
  bool sees_in_doubt(std::uint32_t face, std::uint32_t point) {
    const HullTriangle& t = faces_[face].corner;
    return points_.side(t[2], t[0], t[1], point, exact_) > 0;
  }

  const ExactPoints& points() const { return points_; }
  std::uint64_t exact() const { return exact_; }

 private:
  struct RimEdge {
    std::uint32_t from, to, beyond;  // `beyond`: the unseen face across it
  };

  std::uint32_t new_face(const HullTriangle& corner);
  void set_neighbour(std::uint32_t face, std::uint32_t from, std::uint32_t neighbour);
  void build_cap(std::uint32_t apex);

  const ExactPoints& points_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> free_, removed_, added_;
  std::vector<RimEdge> rim_;
  std::vector<std::uint32_t> edge_face_;  // by corner: the new face whose rim edge starts there
  std::uint32_t visit_ = 0;
  std::uint64_t exact_ = 0;
};

template <class Sees>
void Polyhedron::add_cap(std::uint32_t apex, std::uint32_t seen, const Sees& sees) {
  free_.insert(free_.end(), removed_.begin(), removed_.end());
  removed_.clear();
  rim_.clear();
  // Marks of this cap: visit_ for a face seen, visit_ + 1 for one not seen.
  visit_ += 2;
  removed_.push_back(seen);
  faces_[seen].visit = visit_;
  for (std::size_t next = 0; next < removed_.size(); ++next) {
    const Face& face = faces_[removed_[next]];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t across = face.neighbour[i];
      Face& other = faces_[across];
      if (other.visit < visit_) {
        other.visit = sees(across) ? visit_ : visit_ + 1;
        if (other.visit == visit_) removed_.push_back(across);
      }
      if (other.visit != visit_) rim_.push_back({face.corner[i], face.corner[(i + 1) % 3], across});
    }
  }
  build_cap(apex);
}

}  // namespace cigsim
