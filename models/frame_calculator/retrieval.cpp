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
    // The first term is for what underflows.
    const double slack =
        0x1p-1060 + 0x1p-48 * (std::abs(sphere.centre.x) + std::abs(sphere.centre.y) +
                               std::abs(sphere.centre.z) + std::abs(eye_.x) + std::abs(eye_.y) +
                               std::abs(eye_.z));
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

// Walks the groups breadth first.
class Retrieval {
 public:
  Retrieval(const PriorityHierarchy& hierarchy, const ViewTransform& view,
            const ForcedMembers& forced, bool spheres, Choices& choices,
            std::vector<ActiveGroup>& out)
      : hierarchy_(hierarchy),
        pyramid_(view),
        forced_(forced),
        choices_(choices),
        out_(out),
        planes_{static_cast<unsigned char>(spheres ? Pyramid::kAllPlanes : 0)} {}

  void run() {
    out_.push_back({0, 0, 0});
    for (std::size_t at = 0; at < out_.size(); ++at) {
      const Group& group = hierarchy_.groups[out_[at].group];
      const auto force = forced_.find(out_[at].group);
      const std::uint64_t forced = force == forced_.end() ? 0 : force->second;
      out_[at].first_child = static_cast<std::uint32_t>(out_.size());
      if (group.choice == kNone) {
        for (std::uint32_t m = 0; m < group.member_count; ++m) look_at(at, group, m, forced);
      } else {
        look_at(at, group, choices_.member(group), forced);
      }
    }
  }

 private:
  void look_at(std::size_t at, const Group& group, std::uint32_t m, std::uint64_t forced) {
    const std::uint64_t bit = std::uint64_t{1} << m;
    const Member& member = hierarchy_.members[group.first_member + m];
    unsigned rest = planes_[at];
    if (rest != 0) rest = pyramid_.remaining(member.sphere, rest);
    if ((rest == Pyramid::kOutside || member.placeholder) && !(forced & bit)) return;
    out_[at].active |= bit;
    if (!member.is_group) return;
    out_.push_back({member.index, 0, 0});
    planes_.push_back(
        static_cast<unsigned char>(rest == Pyramid::kOutside ? Pyramid::kAllPlanes : rest));
  }

  const PriorityHierarchy& hierarchy_;
  const Pyramid pyramid_;
  const ForcedMembers& forced_;
  Choices& choices_;
  std::vector<ActiveGroup>& out_;
  // By active group: the planes that its members must be tested against.
  std::vector<unsigned char> planes_;
};

}  // namespace

void retrieve(const PriorityHierarchy& hierarchy, const ViewTransform& view,
              const ForcedMembers& forced, bool spheres, Choices& choices,
              std::vector<ActiveGroup>& out) {
  out.clear();
  if (!hierarchy.groups.empty()) Retrieval(hierarchy, view, forced, spheres, choices, out).run();
}

}  // namespace cigsim::frame_calculator
