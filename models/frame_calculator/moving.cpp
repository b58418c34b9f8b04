// SPDX-License-Identifier: MIT
#include "models/frame_calculator/moving.hpp"

#include <algorithm>
#include <cmath>

#include "models/database/face_set_builder.hpp"
#include "models/database/hierarchy.hpp"
#include "models/database/traversal.hpp"
#include "models/environment/placement.hpp"
#include "models/frame_calculator/functional.hpp"

namespace cigsim::frame_calculator {
namespace {

// A piece on its way down the static tree.
struct Piece {
  std::uint32_t work_item;
  std::uint64_t order;
};

// True when both planes are the same but for direction, judged by the points that define one.
bool coplanar(const Plane& a, const Plane& b) {
  return side(a, b.exact.p) == 0 && side(a, b.exact.u1) == 0 && side(a, b.exact.v1) == 0;
}

bool meet(const Sphere& a, const Sphere& b) {
  const Vec3 d = a.centre - b.centre;
  return std::hypot(d.x, d.y, d.z) <= a.radius + b.radius;
}

double power(const Sphere& s, const Vec3& eye) {
  const Vec3 d = s.centre - eye;
  return dot(d, d) - s.radius * s.radius;
}

class MovingModels {
 public:
  MovingModels(const Database& database, double detail, Choices& choices, ActiveEnvironment& out,
               FaceSet& set, ForcedMembers& forced)
      : database_(database),
        hierarchy_(database.systems[0].hierarchy),
        static_set_(database.systems[0].set),
        detail_(detail),
        choices_(choices),
        out_(out),
        eye_(out.view.eye),
        builder_(work_, set),
        forced_(forced) {}

  void run(double frame) {
    struct Placed {
      std::size_t system;
      Sphere sphere;
      std::vector<Piece> items;
    };
    std::vector<Placed> placed;
    for (std::size_t s = 1; s < database_.systems.size(); ++s) {
      const PreparedSystem& system = database_.systems[s];
      if (system.set.items.empty()) continue;
      const Placing place(placement_at(system, frame));
      Sphere sphere = system.sphere;
      sphere.centre = place(sphere.centre);
      sphere.radius *= 1 + 0x1p-40;
      placed.push_back({s, sphere, add_system(system, place)});
    }
    bool apart = true;
    for (std::size_t i = 0; i < placed.size(); ++i)
      for (std::size_t j = i + 1; j < placed.size(); ++j)
        apart = apart && !meet(placed[i].sphere, placed[j].sphere);
    std::vector<Piece> all;
    if (apart) {
      std::stable_sort(placed.begin(), placed.end(), [&](const Placed& a, const Placed& b) {
        return power(a.sphere, eye_) < power(b.sphere, eye_);
      });
      std::uint64_t base = 0;
      for (const Placed& p : placed) {
        for (const Piece& piece : p.items) all.push_back({piece.work_item, base + piece.order});
        base += database_.systems[p.system].set.items.size();
      }
    } else {
      all = partition_afresh();
    }
    for (const Piece& piece : all) descend(piece);
  }

 private:
  // Adds the placed items of a system to the working set; their order is the model's own.
  std::vector<Piece> add_system(const PreparedSystem& system, const Placing& place) {
    const std::vector<std::uint32_t> ranks =
        ranks_from(system.hierarchy, system.set.items.size(), place.inverse(eye_));
    Choices choices(system.hierarchy, out_.view, detail_, &place);
    const std::vector<bool> shown = items_shown(system.hierarchy, system.set.items.size(), choices);
    choices.count(out_.detail);
    std::vector<Piece> items;
    for (std::size_t i = 0; i < system.set.items.size(); ++i) {
      if (!shown[i]) continue;
      const Item& item = system.set.items[i];
      const auto base = static_cast<std::uint32_t>(work_.vertex_count());
      for (std::uint32_t v = 0; v < item.vertex_count; ++v)
        work_.add_vertex(place(system.set.vertices[item.first_vertex + v]));
      for (std::uint32_t f = 0; f < item.face_count; ++f)
        add_face(system.set, system.set.faces[item.first_face + f], base, place);
      items.push_back({work_.add_item(item.face_count), ranks[i]});
    }
    return items;
  }

  void add_face(const FaceSet& set, const PreparedFace& face, std::uint32_t base,
                const Placing& place) {
    std::vector<std::uint32_t> corners(set.corners.begin() + face.first_corner,
                                       set.corners.begin() + face.first_corner + face.corner_count);
    for (std::uint32_t& c : corners) c += base;
    // A face's plane is defined by three points: p = u0 = v0, u1 and v1.
    const PlaneDefinition& d = set.planes[face.plane].exact;
    const Plane plane = plane_through(place(d.p), place(d.u1), place(d.v1));
    work_.add_polygon(corners, work_.add_plane(plane),
                      {face.object, static_cast<std::uint32_t>(work_.polygons.size()), face.colour,
                       face.two_sided});
  }

  std::vector<Piece> partition_afresh() {
    const Partition tree = partition(work_, {});
    std::vector<Piece> pieces;
    for (const std::uint32_t leaf : leaves_from(tree, eye_))
      for (const std::uint32_t item : tree.leaves[leaf]) pieces.push_back({item, pieces.size()});
    return pieces;
  }

  // A piece at a place of the static tree.
  struct Place {
    std::uint32_t work_item;
    std::uint32_t group;
    std::int32_t child;
  };

  void descend(const Piece& piece) {
    if (hierarchy_.groups.empty()) {
      emit(piece.work_item, kNone, true, piece.order);
      return;
    }
    const auto root = [&](std::uint32_t group) {
      const Group& g = hierarchy_.groups[group];
      if (g.choice != kNone) return ~static_cast<std::int32_t>(choices_.member(g));
      return g.node_count > 0 ? 0 : -1;
    };
    std::vector<Place> stack{{piece.work_item, 0, root(0)}};
    while (!stack.empty()) {
      const Place at = stack.back();
      stack.pop_back();
      const Group& group = hierarchy_.groups[at.group];
      if (at.child < 0) {
        const auto m = static_cast<std::uint32_t>(~at.child);
        forced_[at.group] |= std::uint64_t{1} << m;
        const Member& member = hierarchy_.members[group.first_member + m];
        if (member.is_group)
          stack.push_back({at.work_item, member.index, root(member.index)});
        else
          order_against(at.work_item, member.index, piece.order);
        continue;
      }
      const SeparationNode& node =
          hierarchy_.nodes[group.first_node + static_cast<std::uint32_t>(at.child)];
      const Plane& plane = hierarchy_.planes[node.plane];
      switch (work_.classify(plane, work_.items[at.work_item])) {
        case 1:
          stack.push_back({at.work_item, at.group, node.true_child});
          break;
        case 0:
        case -1:
          stack.push_back({at.work_item, at.group, node.false_child});
          break;
        default: {
          const auto [positive, negative] = work_.cut(plane, at.work_item);
          stack.push_back({positive, at.group, node.true_child});
          stack.push_back({negative, at.group, node.false_child});
        }
      }
    }
  }

  // In front of a static item's face plane and behind it: what part of the piece comes first.
  void order_against(std::uint32_t work_item, std::uint32_t static_item, std::uint64_t order) {
    const Item& item = static_set_.items[static_item];
    bool flat = true;
    for (std::uint32_t f = 1; f < item.face_count && flat; ++f)
      flat = coplanar(static_set_.planes[static_set_.faces[item.first_face].plane],
                      static_set_.planes[static_set_.faces[item.first_face + f].plane]);
    for (std::uint32_t f = 0; f < item.face_count; ++f) {
      const Plane& plane = static_set_.planes[static_set_.faces[item.first_face + f].plane];
      const bool eye_outside = side(plane, eye_) > 0;
      const int where = work_.classify(plane, work_.items[work_item]);
      if (where == 1 || where == 0) {
        emit(work_item, static_item, eye_outside, order);
        return;
      }
      if (where == 2) {
        const auto [outer, inner] = work_.cut(plane, work_item);
        emit(outer, static_item, eye_outside, order);
        work_item = inner;
      }
      if (flat) {
        emit(work_item, static_item, !eye_outside, order);
        return;
      }
    }
    // Within the body: behind its front faces, and in front of none.
    emit(work_item, static_item, false, order);
  }

  void emit(std::uint32_t work_item, std::uint32_t neighbour, bool before, std::uint64_t order) {
    const bool instead = neighbour != kNone && static_set_.items[neighbour].face_count == 0;
    out_.moving.push_back({builder_.add({work_item}), neighbour, before, order, instead});
  }

  const Database& database_;
  const PriorityHierarchy& hierarchy_;
  const FaceSet& static_set_;
  const double detail_;
  Choices& choices_;
  ActiveEnvironment& out_;
  const Vec3 eye_;
  WorkSet work_;
  FaceSetBuilder builder_;
  ForcedMembers& forced_;
};

}  // namespace

void place_moving_models(const Database& database, double frame, double detail, Choices& choices,
                         ActiveEnvironment& out, FaceSet& set, ForcedMembers& forced) {
  out.moving.clear();
  set.clear();
  if (database.systems.size() < 2) return;
  MovingModels(database, detail, choices, out, set, forced).run(frame);
  std::stable_sort(out.moving.begin(), out.moving.end(), [](const auto& a, const auto& b) {
    if (a.neighbour != b.neighbour) return a.neighbour < b.neighbour;
    if (a.before != b.before) return a.before;
    return a.order < b.order;
  });
}

}  // namespace cigsim::frame_calculator
