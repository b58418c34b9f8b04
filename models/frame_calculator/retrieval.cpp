// SPDX-License-Identifier: MIT
#include "models/frame_calculator/retrieval.hpp"

#include <array>
#include <cmath>

namespace cigsim::frame_calculator {
namespace {

// The side planes of the pyramid and the plane through the eyepoint across the line of sight, with
// unit normals that point inwards.
class Pyramid {
 public:
  explicit Pyramid(const ViewTransform& view) : eye_(view.eye) {
    const double f = view.focal, w = view.raster.width / 2.0, h = view.raster.height / 2.0;
    const std::array<Vec3, 5> inward{Vec3{w, f, 0}, {w, -f, 0}, {h, 0, f}, {h, 0, -f}, {1, 0, 0}};
    for (std::size_t i = 0; i < inward.size(); ++i) {
      const Vec3 n = view.rotation.row[0] * inward[i].x + view.rotation.row[1] * inward[i].y +
                     view.rotation.row[2] * inward[i].z;
      normals_[i] = n * (1 / std::hypot(n.x, n.y, n.z));
    }
  }

  enum class Place { kOutside, kAcross, kInside };

  // Levine's test: outside when D + R < 0 for a plane, inside when D - R >= 0 for all.
  Place place(const Sphere& sphere) const {
    const Vec3 d = sphere.centre - eye_;
    const double slack = 0x1p-48 * (std::abs(sphere.centre.x) + std::abs(sphere.centre.y) +
                                    std::abs(sphere.centre.z) + std::abs(eye_.x) +
                                    std::abs(eye_.y) + std::abs(eye_.z));
    const double reach = sphere.radius + slack;
    bool inside = true;
    for (const Vec3& n : normals_) {
      const double distance = dot(n, d);
      if (distance < -reach) return Place::kOutside;
      inside = inside && distance >= reach;
    }
    return inside ? Place::kInside : Place::kAcross;
  }

 private:
  Vec3 eye_;
  std::array<Vec3, 5> normals_;
};

std::uint64_t all_members(std::uint32_t count) {
  return count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

}  // namespace

void retrieve(const PriorityHierarchy& hierarchy, const ViewTransform& view,
              const ForcedMembers& forced, std::vector<ActiveGroup>& out) {
  out.clear();
  if (hierarchy.groups.empty()) return;
  const Pyramid pyramid(view);
  std::vector<bool> inside{false};
  out.push_back({0, 0, 0});
  for (std::size_t at = 0; at < out.size(); ++at) {
    const Group& group = hierarchy.groups[out[at].group];
    const auto force = forced.find(out[at].group);
    std::uint64_t active = inside[at] ? all_members(group.member_count) : 0;
    if (force != forced.end()) active |= force->second;
    std::uint64_t within = inside[at] ? active : 0;
    if (!inside[at]) {
      for (std::uint32_t m = 0; m < group.member_count; ++m) {
        const auto place = pyramid.place(hierarchy.members[group.first_member + m].sphere);
        const std::uint64_t bit = std::uint64_t{1} << m;
        if (place != Pyramid::Place::kOutside) active |= bit;
        if (place == Pyramid::Place::kInside) within |= bit;
      }
    }
    out[at].active = active;
    out[at].first_child = static_cast<std::uint32_t>(out.size());
    for (std::uint32_t m = 0; m < group.member_count; ++m) {
      const std::uint64_t bit = std::uint64_t{1} << m;
      const Member& member = hierarchy.members[group.first_member + m];
      if (!(active & bit) || !member.is_group) continue;
      out.push_back({member.index, 0, 0});
      inside.push_back((within & bit) != 0);
    }
  }
}

}  // namespace cigsim::frame_calculator
