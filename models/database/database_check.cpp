// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "models/database/database_json.hpp"

namespace cigsim {
namespace {

void expect(bool holds, const std::string& place, const char* what) {
  if (!holds) throw DatabaseFault(place + ": " + what);
}

bool in_range(std::uint64_t first, std::uint64_t count, std::size_t size) {
  return first + count <= size;
}

// The filters of plane.hpp rely on a vertex being off by at most one ulp from the cut's exact
// place.
bool within_an_ulp(double rounded, const Exact& exact) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double below = std::nextafter(rounded, -infinity),
               above = std::nextafter(rounded, infinity);
  return std::isfinite(below) && std::isfinite(above) && Exact(below) <= exact &&
         exact <= Exact(above);
}

void check_cut_vertices(const FaceSet& set, const std::string& place) {
  const CutVertex* last = nullptr;
  for (const CutVertex& cut : set.cut_vertices) {
    expect(cut.vertex < set.vertices.size(), place, "a cut vertex names no vertex");
    expect(last == nullptr || last->vertex < cut.vertex, place, "cut vertices must ascend");
    const Vec3& v = set.vertices[cut.vertex];
    expect(within_an_ulp(v.x, cut.position.x) && within_an_ulp(v.y, cut.position.y) &&
               within_an_ulp(v.z, cut.position.z),
           place, "a cut vertex differs from its rounded place");
    last = &cut;
  }
}

void check_set(const FaceSet& set, std::uint64_t last_object, const std::string& place) {
  check_cut_vertices(set, place + ".cut_vertices");
  std::vector<bool> used(set.faces.size(), false);
  for (const Item& item : set.items) {
    const std::string at = place + ".items[" + std::to_string(&item - set.items.data()) + "]";
    expect(in_range(item.first_vertex, item.vertex_count, set.vertices.size()), at,
           "its vertices are out of range");
    expect(in_range(item.first_face, item.face_count, set.faces.size()), at,
           "its faces are out of range");
    for (std::uint32_t f = item.first_face; f < item.first_face + item.face_count; ++f) {
      expect(!used[f], at, "shares a face with another item");
      used[f] = true;
      const PreparedFace& face = set.faces[f];
      expect(face.corner_count >= 3 &&
                 in_range(face.first_corner, face.corner_count, set.corners.size()),
             at, "the corners of a face are out of range");
      for (std::uint32_t c = face.first_corner; c < face.first_corner + face.corner_count; ++c)
        expect(set.corners[c] < item.vertex_count, at, "a corner names no vertex");
      expect(face.plane < set.planes.size(), at, "a face names no plane");
      expect(face.object >= 1 && face.object <= last_object, at, "a face names no object");
    }
  }
  for (const bool face_used : used) expect(face_used, place, "a face belongs to no item");
}

// The members below a child of a plane tree; every node and every member may be met once.
class PlaneTree {
 public:
  PlaneTree(const PriorityHierarchy& hierarchy, const Group& group, const std::string& place)
      : hierarchy_(hierarchy), group_(group), place_(place) {}

  void check() {
    const std::uint64_t all = group_.member_count == 64
                                  ? ~std::uint64_t{0}
                                  : (std::uint64_t{1} << group_.member_count) - 1;
    const std::uint64_t met = group_.node_count == 0 ? all : members_below(0);
    expect(met == all && nodes_met_ == group_.node_count, place_,
           "its planes are not a tree over its members");
  }

 private:
  std::uint64_t members_below(std::int32_t child) {
    if (child < 0) {
      const auto member = static_cast<std::uint32_t>(~child);
      expect(member < group_.member_count, place_, "a plane names no member");
      return std::uint64_t{1} << member;
    }
    expect(static_cast<std::uint32_t>(child) < group_.node_count, place_, "a plane names no node");
    expect(++nodes_met_ <= group_.node_count, place_, "its planes form a circle");
    const SeparationNode& node =
        hierarchy_.nodes[group_.first_node + static_cast<std::uint32_t>(child)];
    expect(node.plane < hierarchy_.planes.size(), place_, "a node names no plane");
    const std::uint64_t on_true = members_below(node.true_child);
    const std::uint64_t on_false = members_below(node.false_child);
    expect((on_true & on_false) == 0, place_, "a member lies on both sides of a plane");
    expect(on_true == node.true_members && on_false == node.false_members, place_,
           "the masks of a plane differ from its members");
    return on_true | on_false;
  }

  const PriorityHierarchy& hierarchy_;
  const Group& group_;
  const std::string& place_;
  std::uint32_t nodes_met_ = 0;
};

// The descriptions of a choice, without planes.
void check_choice_group(const PriorityHierarchy& hierarchy, const Group& group,
                        const std::string& place) {
  expect(group.choice < hierarchy.choices.size(), place, "names no choice");
  expect(group.member_count == hierarchy.choices[group.choice].thresholds.size() + 1, place,
         "must have a member a description of its choice");
  expect(group.node_count == 0, place, "is a choice and must have no planes");
  bool shows = false;
  for (std::uint32_t m = 0; m < group.member_count; ++m)
    shows = shows || !hierarchy.members[group.first_member + m].placeholder;
  expect(shows, place, "is a choice of nothing");
}

void check_choices(const PriorityHierarchy& hierarchy, const std::string& place) {
  for (const PreparedChoice& choice : hierarchy.choices) {
    double last = 0;
    for (const double threshold : choice.thresholds) {
      expect(threshold > last, place + ".choices", "thresholds must ascend from above 0");
      last = threshold;
    }
  }
}

void check_group(const PriorityHierarchy& hierarchy, const Group& group, const std::string& place) {
  expect(group.member_count >= 1 && group.member_count <= kGroupCapacity, place,
         "must have 1 to 64 members");
  expect(group.choice != kNone || group.node_count == group.member_count - 1, place,
         "must have a plane less than members");
  expect(in_range(group.first_member, group.member_count, hierarchy.members.size()), place,
         "its members are out of range");
  expect(in_range(group.first_node, group.node_count, hierarchy.nodes.size()), place,
         "its nodes are out of range");
  if (group.choice == kNone)
    PlaneTree(hierarchy, group, place).check();
  else
    check_choice_group(hierarchy, group, place);
}

// A table made by hand: one group of items, every node with pairs that agree with its masks.
void check_table(const PriorityHierarchy& hierarchy, const std::string& place) {
  expect(hierarchy.groups.size() == 1, place, "has pairs but not one group");
  const Group& group = hierarchy.groups[0];
  expect(group.choice == kNone, place, "has pairs and a choice");
  expect(group.first_member == 0 && group.member_count <= kGroupCapacity &&
             group.member_count == hierarchy.members.size(),
         place, "must hold its members, at most 64, in its group");
  expect(group.first_node == 0 && group.node_count < kGroupCapacity &&
             group.node_count == hierarchy.nodes.size(),
         place, "must hold its nodes, at most 63, in its group");
  std::vector<std::uint64_t> met(group.member_count, 0);
  for (const SeparationNode& node : hierarchy.nodes) {
    expect(node.pair_count > 0, place, "a node has no pairs");
    expect(node.plane < hierarchy.planes.size(), place, "a node names no plane");
    std::uint64_t on_true = 0, on_false = 0;
    for (std::uint32_t p = node.first_pair; p < node.first_pair + node.pair_count; ++p) {
      const auto [t, f] = hierarchy.pairs[p];
      expect(t < group.member_count && f < group.member_count, place, "a pair names no member");
      const std::uint64_t true_bit = std::uint64_t{1} << t, false_bit = std::uint64_t{1} << f;
      expect(t != f && !(met[t] & false_bit), place, "a pair occurs twice or is one member");
      met[t] |= false_bit;
      met[f] |= true_bit;
      on_true |= true_bit;
      on_false |= false_bit;
    }
    expect((on_true & on_false) == 0, place, "a member lies on both sides of a plane");
    expect(on_true == node.true_members && on_false == node.false_members, place,
           "the masks of a plane differ from its pairs");
  }
}

// Only a placeholder has no faces, and it holds the place of a description.
void check_item(const Item& item, const Member& member, const Group& group,
                const std::string& place) {
  const bool empty = item.face_count == 0 && item.vertex_count == 0;
  expect(member.placeholder == empty, place,
         empty ? "holds an item without faces" : "has a placeholder with faces or vertices");
  expect(!member.placeholder || group.choice != kNone, place, "has a placeholder and is no choice");
}

// One tree from group 0 that meets every group and every item once.
void check_hierarchy(const PriorityHierarchy& hierarchy, const FaceSet& set,
                     const std::string& place) {
  const std::size_t items = set.items.size();
  check_choices(hierarchy, place);
  expect(hierarchy.groups.empty() == (items == 0), place,
         "has items but no groups, or the reverse");
  if (!hierarchy.pairs.empty()) check_table(hierarchy, place);
  if (items == 0) return;
  std::vector<bool> item_met(items, false), group_met(hierarchy.groups.size(), false);
  std::vector<std::uint32_t> open{0};
  group_met[0] = true;
  std::size_t groups_left = hierarchy.groups.size(), items_left = items;
  while (!open.empty()) {
    const Group& group = hierarchy.groups[open.back()];
    const std::string at = place + ".groups[" + std::to_string(open.back()) + "]";
    open.pop_back();
    --groups_left;
    if (hierarchy.pairs.empty()) check_group(hierarchy, group, at);
    for (std::uint32_t m = group.first_member; m < group.first_member + group.member_count; ++m) {
      const Member& member = hierarchy.members[m];
      std::vector<bool>& met = member.is_group ? group_met : item_met;
      expect(member.index < met.size(), at, "a member is out of range");
      expect(!met[member.index], at, "a member occurs twice");
      met[member.index] = true;
      if (!member.is_group) check_item(set.items[member.index], member, group, at);
      if (member.is_group)
        open.push_back(member.index);
      else
        --items_left;
    }
  }
  expect(groups_left == 0, place, "a group hangs from no other");
  expect(items_left == 0, place, "an item is in no group");
}

}  // namespace

void check_database(const Database& database) {
  expect(!database.systems.empty(), "systems", "must hold the environment's own");
  expect(database.object_names.size() == database.object_count, "object_names",
         "must hold a name an object");
  expect(database.view.fov > 0 && database.view.fov < 180, "view.fov",
         "must lie between 0 and 180");
  for (std::size_t i = 0; i < database.systems.size(); ++i) {
    const PreparedSystem& system = database.systems[i];
    const std::string place = "systems[" + std::to_string(i) + "]";
    for (std::size_t k = 1; k < system.motion.size(); ++k)
      expect(system.motion[k - 1].frame < system.motion[k].frame, place + ".motion",
             "frames must ascend");
    check_set(system.set, database.object_count, place + ".set");
    check_hierarchy(system.hierarchy, system.set, place + ".hierarchy");
    expect(system.hierarchy.pairs.empty() || database.systems.size() == 1, place,
           "a table made by hand cannot order moving systems");
  }
  expect(database.ground.items.size() <= 1, "ground", "must be one item");
  check_set(database.ground, std::uint64_t{database.object_count} + database.ground.faces.size(),
            "ground");
}

}  // namespace cigsim
