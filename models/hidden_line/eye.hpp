// SPDX-License-Identifier: MIT
// Points as the eye sees them, and exact answers about their projections.
//
// Three points turn left on the raster when the eye sees them anticlockwise: the sign of a
// determinant of their differences from the eye. So no projected coordinate has to be rounded or
// divided. The determinant is worked out in doubles first, and in whole numbers when its sign lies
// within the error bound. The window of a point (x, y, margin) is rounded; it only prunes.
#pragma once

#include <cstdint>

#include "models/boundary/transactions.hpp"
#include "models/numeric/number.hpp"
#include "models/numeric/plane.hpp"

namespace cigsim::hidden_line {

struct SeenPoint {
  Vec3 position;
  Vec3 d;                      ///< position - eye, rounded
  double size = 0;             ///< |d.x| + |d.y| + |d.z|
  double u = 0, v = 0, w = 0;  ///< viewpoint system, rounded
  double x = 0, y = 0;         ///< v/u and w/u, when ahead
  double margin = 0;           ///< what x and y may be off
  bool ahead = false;          ///< certainly in front of the eye, and less than 89.9999 degrees off
};

class Eye {
 public:
  Eye() = default;
  explicit Eye(const ViewTransform& view) : view_(view) {}

  const ViewTransform& view() const { return view_; }
  SeenPoint see(const Vec3& position) const;

  /// +1 when a, b, c run anticlockwise as seen from the eye, -1 clockwise, 0 when they and the eye
  /// lie in one plane.
  int turn(const SeenPoint& a, const SeenPoint& b, const SeenPoint& c) const;

  /// +1 when `c` is seen above the line that runs through `a` to the right on the raster, -1 below.
  int above(const SeenPoint& a, const SeenPoint& c) const;

  /// Where a + t (b - a) meets the plane through the eye, p and q, exactly. They must meet in one
  /// point.
  Exact crossing(const SeenPoint& p, const SeenPoint& q, const SeenPoint& a,
                 const SeenPoint& b) const;
  /// The same for a plane of a face.
  static Exact crossing(const Plane& plane, const SeenPoint& a, const SeenPoint& b);

 private:
  ViewTransform view_;
};

/// The edge p q as a plane through the eye, prepared for many questions.
struct SightPlane {
  const SeenPoint* p = nullptr;
  const SeenPoint* q = nullptr;
  Vec3 normal;       ///< of the plane, rounded
  double bound = 0;  ///< times the size of a point: bound on the error of the value

  SightPlane() = default;
  SightPlane(const SeenPoint& from, const SeenPoint& to)
      : p(&from), q(&to), normal(cross(from.d, to.d)), bound(0x1p-49 * from.size * to.size) {}

  /// Positive where p, q and the point run anticlockwise.
  double value(const SeenPoint& c) const { return -dot(normal, c.d); }
  double error(const SeenPoint& c) const { return bound * c.size + 0x1p-900; }
  int side(const Eye& eye, const SeenPoint& c) const {
    const double s = value(c), e = error(c);
    return s > e ? 1 : s < -e ? -1 : eye.turn(*p, *q, c);
  }
};

/// How often a question about projections on this thread needed whole numbers.
std::uint64_t exact_turns();

}  // namespace cigsim::hidden_line
