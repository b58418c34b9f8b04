// SPDX-License-Identifier: MIT
#include "models/survey/clipping/scene_clip.hpp"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include "models/frame_calculator/detail.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/survey/clipping/cluster_clip.hpp"
#include "models/survey/clipping/edge_clip.hpp"

namespace cigsim::survey {
namespace {

class SceneClip {
 public:
  SceneClip(const Database& database, const ViewTransform& view, double view_plane)
      : hierarchy_(database.systems[0].hierarchy),
        set_(database.systems[0].set),
        view_(view),
        choices_(hierarchy_, view, 1) {
    const Exact d(view_plane), scale(d / Exact(view.focal));
    box_ = {d, Exact(scale * Exact(view.raster.width) / 2),
            Exact(scale * Exact(view.raster.height) / 2)};
    rounded_ = {view_plane, box_.half_width.get_d(), box_.half_height.get_d()};
    smallest_ = view_plane / view.focal;
    eye_ = convert<Exact>(view.eye);
    rotation_ = convert<Exact>(view.rotation);
  }

  ClipCounts run(const FaceSet& moving, const FaceSet& ground) {
    if (!hierarchy_.groups.empty()) group(0);
    for (const FaceSet* set : {&moving, &ground})
      for (const Item& each : set->items) item(*set, each);
    return counts_;
  }

 private:
  ClusterView test(const Sphere& sphere, ClipCounts::Clusters& clusters) {
    const Vec3 p = view_.rotation * (sphere.centre - view_.eye);
    const ClusterView found = clip_cluster({p.y, p.z, p.x}, sphere.radius, rounded_, smallest_);
    ++clusters.tested;
    clusters.outside += found == ClusterView::kOutside;
    clusters.too_small += found == ClusterView::kTooSmall;
    clusters.inside += found == ClusterView::kInside;
    clusters.cut += found == ClusterView::kCut;
    return found;
  }

  // All below the group's members, each tested as long as the way down was cut.
  void group(std::uint32_t root) {
    std::vector<std::uint32_t> waiting{root};
    while (!waiting.empty()) {
      const std::span<const Member> members = members_of(hierarchy_.groups[waiting.back()]);
      waiting.pop_back();
      for (const Member& member : members) {
        if (member.placeholder) continue;
        if (!member.is_group) {
          item(set_, set_.items[member.index]);
          continue;
        }
        const ClusterView found = test(member.sphere, counts_.groups);
        if (found == ClusterView::kCut)
          waiting.push_back(member.index);
        else
          (found == ClusterView::kInside ? counts_.items_inside_groups
                                         : counts_.items_dropped_with_groups) +=
              items_below(member.index);
      }
    }
  }

  // Of a thing with several descriptions, the one that is shown.
  std::span<const Member> members_of(const Group& group) {
    const std::span<const Member> all(hierarchy_.members.data() + group.first_member,
                                      group.member_count);
    return group.choice == kNone ? all : all.subspan(choices_.member(group), 1);
  }

  std::uint64_t items_below(std::uint32_t root) {
    std::uint64_t count = 0;
    std::vector<std::uint32_t> waiting{root};
    while (!waiting.empty()) {
      const std::span<const Member> members = members_of(hierarchy_.groups[waiting.back()]);
      waiting.pop_back();
      for (const Member& member : members)
        if (member.is_group)
          waiting.push_back(member.index);
        else if (!member.placeholder)
          ++count;
    }
    return count;
  }

  void item(const FaceSet& set, const Item& item) {
    if (test(item.sphere, counts_.items) != ClusterView::kCut) return;
    std::vector<ExactVec> points(item.vertex_count);
    for (std::uint32_t v = 0; v < item.vertex_count; ++v) {
      const ExactVec p = rotation_ * (convert<Exact>(set.vertices[item.first_vertex + v]) - eye_);
      points[v] = {p.y, p.z, p.x};
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::uint32_t f = item.first_face; f < item.first_face + item.face_count; ++f) {
      const PreparedFace& face = set.faces[f];
      const int front = side(set.planes[face.plane], view_.eye);
      if (front == 0 || (front < 0 && !face.two_sided)) {
        ++counts_.back_faces;
        continue;
      }
      std::vector<ExactVec> ring;
      for (std::uint32_t c = 0; c < face.corner_count; ++c) {
        const std::uint32_t a = set.corners[face.first_corner + c],
                            b = set.corners[face.first_corner + (c + 1) % face.corner_count];
        ring.push_back(points[a]);
        edges.insert(std::minmax(a, b));
      }
      polygon(std::move(ring));
    }
    for (const auto& [a, b] : edges) edge(points[a], points[b]);
  }

  void edge(const ExactVec& a, const ExactVec& b) {
    const std::uint8_t outside = region(a, box_) | region(b, box_);
    tell(counts_.edges, outside == 0, outside != 0 && clip_edge(a, b, box_).has_value());
  }

  void polygon(std::vector<ExactVec> ring) {
    std::uint8_t outside = 0;
    for (const ExactVec& p : ring) outside |= region(p, box_);
    tell(counts_.polygons, outside == 0,
         !clip_polygon(std::move(ring), box_, counts_.work).empty() && outside != 0);
  }

  static void tell(ClipCounts::Parts& parts, bool inside, bool cut) {
    ++parts.tested;
    ++(inside ? parts.inside : cut ? parts.cut : parts.outside);
  }

  const PriorityHierarchy& hierarchy_;
  const FaceSet& set_;
  const ViewTransform& view_;
  frame_calculator::Choices choices_;
  ViewBox<Exact> box_;
  ViewBox<double> rounded_;
  double smallest_ = 0;
  ExactVec eye_;
  Mat3T<Exact> rotation_;
  ClipCounts counts_;
};

}  // namespace

ClipCounts clip_scene(const Database& database, const Viewpoint& viewpoint, const Raster& raster,
                      double frame, double view_plane) {
  ActiveEnvironment active;
  FaceSet moving;
  frame_calculator::Functional(database).compute(viewpoint, raster, frame, active, moving);
  return SceneClip(database, active.view, view_plane).run(moving, database.ground);
}

}  // namespace cigsim::survey
