// SPDX-License-Identifier: MIT
// Cluster clipping (Sandor 1979, sec. 4.1): a cluster is clipped by its bounding sphere, whose
// image is bounded by a rectangle in the view plane.
#pragma once

#include <optional>

#include "models/survey/clipping/observer.hpp"

namespace cigsim::survey {

/// The rectangle about the image of a sphere: x from `left` to `right`, y from `bottom` to `top`
/// (his a'', b'', e'', f''), in the view plane.
struct ClusterImage {
  double left = 0, right = 0, bottom = 0, top = 0;
};

/// In each plane the sphere's centre lies at an angle, and the sphere reaches
/// asin(r / distance in that plane) to both sides of it. None: the sphere is not wholly ahead of
/// the eye in both planes, and its image has no such bounds.
std::optional<ClusterImage> cluster_image(const Vec3& centre, double radius, double d);

/// His rule as published, for a square screen of half side b: true when the cluster is not visible.
/// Angles come from quotients alone, and a sphere that holds the eye in one of the planes has none;
/// then the conditions fail and it stays.
bool published_rule_rejects(const Vec3& centre, double radius, double d, double b);

enum class ClusterView {
  kOutside,   ///< wholly outside one side of the view box
  kTooSmall,  ///< its image is smaller than the display can show
  kInside,    ///< wholly inside: nothing in it needs to be clipped
  kCut
};

/// The rule with signed distances instead of angles, which are defined for every sphere, so that
/// one around or behind the eye is told too; conservative beyond rounding. `smallest`: image size
/// in the view plane below which a cluster is dropped, if both sides of its rectangle are; 0 drops
/// none. The centre is in the observer's frame; the radius is not negative.
ClusterView clip_cluster(const Vec3& centre, double radius, const ViewBox<double>& box,
                         double smallest);

}  // namespace cigsim::survey
