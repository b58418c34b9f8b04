// SPDX-License-Identifier: MIT
// Instances are made in doubles, and what comes out is taken as exact: a thing in its own units,
// then placed by the extremes, then one of its points moved to where a decision changes.
#pragma once

#include "models/numeric/number.hpp"
#include "sim/stability/decision.hpp"
#include "sim/stability/directions.hpp"

namespace cigsim::stability {

/// Where an instance stands: scaled, then moved away from the origin in a direction at random.
class Place {
 public:
  Place(const Extremes& extremes, Random& random);
  Vec3 operator()(const Vec3& p) const { return p * scale_ + shift_; }
  Triangle operator()(const Triangle& t) const;
  /// A plane given by points moves with them; one given by a point and directions keeps these.
  PlaneDefinition operator()(const PlaneDefinition& plane) const;
  double scale() const { return scale_; }

 private:
  double scale_;
  Vec3 shift_;
};

/// A triangle of the material, squeezed to the aspect; not placed.
Triangle triangle_of(const Material& material, const Extremes& extremes, Random& random);
double size_of(const Triangle& t);
Vec3 centre_of(const Triangle& t);
/// The plane through its corners, as a face's.
PlaneDefinition plane_of(const Triangle& t);

/// A plane of the material, which passes near the origin of things at random; not placed.
PlaneDefinition plane_of(const Material& material, const Extremes& extremes, Random& random);

/// An eyepoint that sees the triangle from its front: at the extremes' distance and grazing angle,
/// or, every second time where nothing says otherwise, an eyepoint of the material. Not placed.
Vec3 eyepoint_for(const Material& material, const Triangle& t, const Extremes& extremes,
                  Random& random);

/// The machine's view from `eye` towards `target`, rolled at random.
ViewTransform view_towards(const Vec3& eye, const Vec3& target, const Extremes& extremes,
                           Random& random);
/// A point of the triangle, every second time on its border.
Vec3 point_of(const Triangle& t, Random& random);

/// A triangle, and an eyepoint that looks at a point of it: points[0..2] and the view.
Instance pose_face(const Material& material, const Extremes& extremes, Random& random);
void add_corners(Instance& instance, const Triangle& t);
/// Those of an instance's first triangle.
Triangle corners(const Instance& instance);

/// The plane normal · (x - through) = 0, which no double need hold.
struct Border {
  ExactVec normal, through;
};
Border border_of(const PlaneDefinition& plane);
/// `point` moved along the axis in which the border lies across it most: to the border, rounded to
/// nearest, then `ulps` ulps of its largest coordinate to either side. Unmoved where that is no
/// number (a border without a normal).
Vec3 near_border(const Vec3& point, const Border& border, double ulps, Random& random);

}  // namespace cigsim::stability
