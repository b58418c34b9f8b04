// SPDX-License-Identifier: MIT
#include "models/frame_calculator/retrieval.hpp"

#include <array>
#include <bit>
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

  static constexpr unsigned kAllPlanes = 0x1f;
  static constexpr unsigned kOutside = ~0u;

  /// Levine's test: outside when D + R < 0 for a plane; a plane with D - R >= 0 need not be tested
  /// for anything within the sphere. Takes the planes to test and returns those that remain (0:
  /// inside), or kOutside.
  unsigned remaining(const Sphere& sphere, unsigned planes) const {
    const Vec3 d = sphere.centre - eye_;
    const double slack = 0x1p-48 * (std::abs(sphere.centre.x) + std::abs(sphere.centre.y) +
                                    std::abs(sphere.centre.z) + std::abs(eye_.x) +
                                    std::abs(eye_.y) + std::abs(eye_.z));
    const double reach = sphere.radius + slack;
    for (unsigned rest = planes; rest != 0; rest &= rest - 1) {
      const double distance = dot(normals_[static_cast<std::size_t>(std::countr_zero(rest))], d);
      if (distance < -reach) return kOutside;
      if (distance >= reach) planes &= ~(rest & -rest);
    }
    return planes;
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
  // By active group: the planes that its members must be tested against.
  std::vector<unsigned char> planes{Pyramid::kAllPlanes};
  out.push_back({0, 0, 0});
  for (std::size_t at = 0; at < out.size(); ++at) {
    const Group& group = hierarchy.groups[out[at].group];
    const auto force = forced.find(out[at].group);
    const std::uint64_t forced_here = force == forced.end() ? 0 : force->second;
    out[at].active = planes[at] == 0 ? all_members(group.member_count) : 0;
    out[at].first_child = static_cast<std::uint32_t>(out.size());
    for (std::uint32_t m = 0; m < group.member_count; ++m) {
      const std::uint64_t bit = std::uint64_t{1} << m;
      const Member& member = hierarchy.members[group.first_member + m];
      unsigned rest = planes[at];
      if (rest != 0) rest = pyramid.remaining(member.sphere, rest);
      if (rest == Pyramid::kOutside && !(forced_here & bit)) continue;
      out[at].active |= bit;
      if (!member.is_group) continue;
      out.push_back({member.index, 0, 0});
      planes.push_back(
          static_cast<unsigned char>(rest == Pyramid::kOutside ? Pyramid::kAllPlanes : rest));
    }
  }
}

}  // namespace cigsim::frame_calculator
