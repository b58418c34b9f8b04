// SPDX-License-Identifier: MIT
#include "models/frame_calculator/detail.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim::frame_calculator {
namespace {

// Radius against threshold: the sign of focal * radius - threshold * scale * u.
class ProjectedRadius {
 public:
  ProjectedRadius(const Sphere& sphere, const ViewTransform& view, double scale)
      : sphere_(sphere), view_(view), scale_(scale) {
    const Vec3 d = sphere.centre - view.eye;
    const Vec3& ahead = view.rotation.row[0];
    depth_ = dot(ahead, d);
    size_ = std::abs(ahead.x * d.x) + std::abs(ahead.y * d.y) + std::abs(ahead.z * d.z);
  }

  bool is_above(double threshold) const {
    if (scale_ == 0) return true;
    // Differences, products and sums are each off by half a unit in the last place at most.
    const double radius = view_.focal * sphere_.radius, factor = threshold * scale_;
    const double limit = factor * depth_;
    const double error = 0x1p-49 * (factor * size_ + radius);
    const double difference = radius - limit;
    const bool sure = factor > kTiny && size_ > kTiny && error > kTiny;
    if (sure && difference > error) return true;
    if (sure && difference < -error) return false;
    return exactly_above(threshold);
  }

 private:
  // Far above what products that underflow lose.
  static constexpr double kTiny = 0x1p-900;

  // What overflows compares as neither above nor below its error, and ends here too.
  bool exactly_above(double threshold) const {
    const Vec3& c = sphere_.centre;
    for (const double value : {view_.focal, sphere_.radius, c.x, c.y, c.z})
      if (!std::isfinite(value)) return true;
    const ExactVec d = convert<Exact>(sphere_.centre) - convert<Exact>(view_.eye);
    const Exact depth = dot(convert<Exact>(view_.rotation.row[0]), d);
    return Exact(view_.focal) * Exact(sphere_.radius) > Exact(threshold) * Exact(scale_) * depth;
  }

  const Sphere& sphere_;
  const ViewTransform& view_;
  const double scale_;
  double depth_, size_;
};

}  // namespace

std::uint32_t description_shown(const Sphere& sphere, std::span<const double> thresholds,
                                const ViewTransform& view, double scale) {
  const ProjectedRadius radius(sphere, view, scale);
  // A centre beside or behind the eyepoint makes every limit zero or less.
  const auto first =
      std::partition_point(thresholds.begin(), thresholds.end(),
                           [&](double threshold) { return radius.is_above(threshold); });
  return static_cast<std::uint32_t>(first - thresholds.begin());
}

void Choices::count(std::vector<std::uint32_t>& counts) const {
  for (const std::uint32_t description : made_) {
    if (description == kNone) continue;
    if (counts.size() <= description) counts.resize(description + 1, 0);
    ++counts[description];
  }
}

std::uint32_t Choices::make(std::uint32_t choice) const {
  const PreparedChoice& source = hierarchy_.choices[choice];
  Sphere sphere = source.sphere;
  if (place_ != nullptr) sphere.centre = (*place_)(sphere.centre);
  return description_shown(sphere, source.thresholds, view_, scale_);
}

std::vector<bool> items_shown(const PriorityHierarchy& hierarchy, std::size_t items,
                              Choices& choices) {
  std::vector<bool> shown(items, false);
  std::vector<std::uint32_t> open;
  if (!hierarchy.groups.empty()) open.push_back(0);
  while (!open.empty()) {
    const Group& group = hierarchy.groups[open.back()];
    open.pop_back();
    const bool choice = group.choice != kNone;
    const std::uint32_t first = choice ? choices.member(group) : 0;
    const std::uint32_t end = choice ? first + 1 : group.member_count;
    for (std::uint32_t m = first; m < end; ++m) {
      const Member& member = hierarchy.members[group.first_member + m];
      if (member.is_group)
        open.push_back(member.index);
      else if (!member.placeholder)
        shown[member.index] = true;
    }
  }
  return shown;
}

}  // namespace cigsim::frame_calculator
