// SPDX-License-Identifier: MIT
#include "models/survey/clipping/cluster_clip.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim::survey {
namespace {

// Half angle of the sphere as seen along a coordinate plane; NaN when the eye is within it there.
double half_angle(double across, double ahead, double radius) {
  return std::atan(radius / std::sqrt(across * across + ahead * ahead - radius * radius));
}

}  // namespace

std::optional<ClusterImage> cluster_image(const Vec3& c, double radius, double d) {
  if (!(c.z - radius > 0)) return std::nullopt;
  const double x = std::atan2(c.x, c.z), y = std::atan2(c.y, c.z);
  const double dx = half_angle(c.x, c.z, radius), dy = half_angle(c.y, c.z, radius);
  return ClusterImage{d * std::tan(x - dx), d * std::tan(x + dx), d * std::tan(y - dy),
                      d * std::tan(y + dy)};
}

bool published_rule_rejects(const Vec3& c, double radius, double d, double b) {
  const double alpha1 = std::atan(c.x / c.z), alpha2 = half_angle(c.x, c.z, radius);
  const double beta1 = std::atan(c.y / c.z), beta2 = half_angle(c.y, c.z, radius);
  const double gamma = d * c.x / c.z, delta = d * c.y / c.z;
  return (gamma > 0 && d * std::tan(alpha1 - alpha2) > b) ||
         (gamma < 0 && d * std::tan(alpha1 + alpha2) < -b) ||
         (delta > 0 && d * std::tan(beta1 - beta2) > b) ||
         (delta < 0 && d * std::tan(beta1 + beta2) < -b) || c.z + radius < d;
}

ClusterView clip_cluster(const Vec3& c, double radius, const ViewBox<double>& box,
                         double smallest) {
  const double slack = 0x1p-48 * (std::abs(c.x) + std::abs(c.y) + std::abs(c.z) + box.d);
  const double reach = radius + slack;
  const double wide = std::hypot(box.half_width, box.d), high = std::hypot(box.half_height, box.d);
  // Distances from the planes of the box, positive inside.
  const double least = std::min({c.z - box.d, (box.half_width * c.z - box.d * c.x) / wide,
                                 (box.half_width * c.z + box.d * c.x) / wide,
                                 (box.half_height * c.z - box.d * c.y) / high,
                                 (box.half_height * c.z + box.d * c.y) / high});
  if (least < -reach) return ClusterView::kOutside;
  if (c.z - reach > box.d) {
    const auto image = cluster_image(c, radius, box.d);
    if (image && image->right - image->left < smallest && image->top - image->bottom < smallest)
      return ClusterView::kTooSmall;
  }
  return least >= reach ? ClusterView::kInside : ClusterView::kCut;
}

}  // namespace cigsim::survey
