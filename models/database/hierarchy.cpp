// SPDX-License-Identifier: MIT
#include "models/database/hierarchy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cigsim {
namespace {

constexpr double kGrow = 1 + 0x1p-48;

double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

struct Box {
  Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
  Vec3 high = low * -1.0;

  void add(const Vec3& p, double r) {
    low = {std::min(low.x, p.x - r), std::min(low.y, p.y - r), std::min(low.z, p.z - r)};
    high = {std::max(high.x, p.x + r), std::max(high.y, p.y + r), std::max(high.z, p.z + r)};
  }
  Vec3 centre() const { return low * 0.5 + high * 0.5; }
};

double distance(const Vec3& a, const Vec3& b) {
  const Vec3 d = a - b;
  return std::hypot(d.x, d.y, d.z);
}

// Covers what rounding the centre and the distances can take away.
double grown(double radius, const Vec3& centre) {
  return radius * kGrow + largest(centre) * 0x1p-50;
}

class Builder {
 public:
  Builder(const Partition& partition, const FaceSet& set)
      : tree_(partition), set_(set), items_(items_of_leaves(partition)) {
    next_placeholder_ = static_cast<std::uint32_t>(tree_.leaves.size() - tree_.choices.size());
  }

  PriorityHierarchy run() {
    if (tree_.leaves.empty()) return {};
    mark_groups();
    std::vector<std::int32_t> roots{tree_.root};
    // Breadth first: a group's subgroups get the next free numbers, in member order.
    for (std::size_t at = 0; at < roots.size(); ++at)
      if (const ChoiceLeaf* choice = choice_at(roots[at]))
        make_choice(*choice, roots);
      else
        make_group(roots[at], roots);
    out_.planes = tree_.planes;
    place_spheres();
    return std::move(out_);
  }

 private:
  // From the leaves up: where two subtrees have more than a group's members together, the larger
  // one becomes a group and counts as one member from there on. Groups are at least half full so.
  void mark_groups() {
    is_group_.assign(tree_.nodes.size(), false);
    for (const ChoiceLeaf& choice : tree_.choices)
      for (const std::optional<std::int32_t>& root : choice.roots)
        if (root && *root >= 0) is_group_[static_cast<std::size_t>(*root)] = true;
    std::vector<std::uint32_t> members(tree_.nodes.size(), 0);
    const auto weight = [&](std::int32_t child) {
      return child < 0 || is_group_[static_cast<std::size_t>(child)]
                 ? 1
                 : members[static_cast<std::size_t>(child)];
    };
    // Children come after their parents, so one pass from the end suffices.
    for (std::size_t n = tree_.nodes.size(); n-- > 0;) {
      const PartitionNode& node = tree_.nodes[n];
      while (weight(node.true_child) + weight(node.false_child) > kGroupCapacity) {
        const bool larger_true = weight(node.true_child) >= weight(node.false_child);
        is_group_[static_cast<std::size_t>(larger_true ? node.true_child : node.false_child)] =
            true;
      }
      members[n] = weight(node.true_child) + weight(node.false_child);
    }
  }
  bool is_member(std::int32_t child) const {
    return child < 0 || is_group_[static_cast<std::size_t>(child)];
  }

  // A subtree, and where in the group it hangs.
  struct Open {
    std::int32_t child;
    std::int32_t parent;  // node within the group
    bool true_side;
  };

  void make_group(std::int32_t root, std::vector<std::int32_t>& roots) {
    Group group;
    group.first_member = static_cast<std::uint32_t>(out_.members.size());
    group.first_node = static_cast<std::uint32_t>(out_.nodes.size());
    std::vector<Open> open{{root, -1, false}};
    for (std::size_t at = 0; at < open.size(); ++at) {
      const Open subtree = open[at];
      if (subtree.child < 0 || (at > 0 && is_member(subtree.child))) {
        add_member(group, subtree, roots);
        continue;
      }
      const PartitionNode& source = tree_.nodes[static_cast<std::size_t>(subtree.child)];
      const auto node = static_cast<std::int32_t>(group.node_count++);
      out_.nodes.push_back({source.plane, 0, 0, 0, 0});
      attach(group, subtree, node);
      open.push_back({source.true_child, node, true});
      open.push_back({source.false_child, node, false});
    }
    fill_masks(group);
    out_.groups.push_back(group);
  }

  void add_member(Group& group, const Open& at, std::vector<std::int32_t>& roots) {
    attach(group, at, ~static_cast<std::int32_t>(group.member_count++));
    out_.members.push_back(member(at.child, roots));
  }

  Member member(std::int32_t child, std::vector<std::int32_t>& roots) const {
    Member member;
    member.is_group = child >= 0 || choice_at(child) != nullptr;
    if (member.is_group) {
      member.index = static_cast<std::uint32_t>(roots.size());
      roots.push_back(child);
    } else {
      member.index = items_[static_cast<std::size_t>(~child)];
    }
    return member;
  }

  // A choice has its descriptions as members, and no planes.
  void make_choice(const ChoiceLeaf& choice, std::vector<std::int32_t>& roots) {
    Group group;
    group.first_member = static_cast<std::uint32_t>(out_.members.size());
    group.member_count = static_cast<std::uint32_t>(choice.roots.size());
    group.first_node = static_cast<std::uint32_t>(out_.nodes.size());
    group.choice = choice.choice;
    for (const std::optional<std::int32_t>& root : choice.roots)
      out_.members.push_back(root ? member(*root, roots)
                                  : Member{false, next_placeholder_++, Sphere(), true});
    out_.groups.push_back(group);
  }

  const ChoiceLeaf* choice_at(std::int32_t child) const {
    if (child >= 0 || tree_.choices.empty()) return nullptr;
    const auto leaf = static_cast<std::uint32_t>(~child);
    const auto at =
        std::lower_bound(tree_.choices.begin(), tree_.choices.end(), leaf,
                         [](const ChoiceLeaf& c, std::uint32_t l) { return c.leaf < l; });
    return at != tree_.choices.end() && at->leaf == leaf ? &*at : nullptr;
  }

  void attach(const Group& group, const Open& at, std::int32_t child) {
    if (at.parent < 0) return;
    SeparationNode& node = out_.nodes[group.first_node + static_cast<std::uint32_t>(at.parent)];
    (at.true_side ? node.true_child : node.false_child) = child;
  }

  void fill_masks(const Group& group) {
    const auto mask = [&](std::int32_t child) {
      if (child < 0) return std::uint64_t{1} << ~child;
      const SeparationNode& node = out_.nodes[group.first_node + static_cast<std::uint32_t>(child)];
      return node.true_members | node.false_members;
    };
    for (std::uint32_t n = group.node_count; n-- > 0;) {
      SeparationNode& node = out_.nodes[group.first_node + n];
      node.true_members = mask(node.true_child);
      node.false_members = mask(node.false_child);
    }
  }

  // A group's sphere is taken around the spheres of all items below it, which is tighter than one
  // around those of its members.
  void place_spheres() {
    // Subgroups come after their groups, so going backwards finds their spheres ready.
    std::vector<Sphere> of_group(out_.groups.size());
    std::vector<std::vector<Sphere>> below(out_.groups.size());
    for (std::size_t g = out_.groups.size(); g-- > 0;) {
      const Group& group = out_.groups[g];
      for (std::uint32_t m = 0; m < group.member_count; ++m) {
        Member& member = out_.members[group.first_member + m];
        if (member.is_group) {
          member.sphere = of_group[member.index];
          std::vector<Sphere>& items = below[member.index];
          below[g].insert(below[g].end(), items.begin(), items.end());
          items = {};
        } else if (member.placeholder) {
          member.sphere = {};
        } else {
          member.sphere = set_.items[member.index].sphere;
          below[g].push_back(member.sphere);
        }
      }
      of_group[g] = enclosing(below[g]);
    }
  }

  const Partition& tree_;
  const FaceSet& set_;
  const std::vector<std::uint32_t> items_;  // by leaf
  std::uint32_t next_placeholder_;
  std::vector<bool> is_group_;  // by node of the tree
  PriorityHierarchy out_;
};

}  // namespace

std::vector<std::uint32_t> items_of_leaves(const Partition& partition) {
  std::vector<std::uint32_t> items;
  std::uint32_t next = 0;
  auto choice = partition.choices.begin();
  for (std::uint32_t leaf = 0; leaf < partition.leaves.size(); ++leaf) {
    const bool is_choice = choice != partition.choices.end() && choice->leaf == leaf;
    items.push_back(is_choice ? kNone : next++);
    if (is_choice) ++choice;
  }
  return items;
}

PriorityHierarchy build_hierarchy(const Partition& partition, const FaceSet& set) {
  return Builder(partition, set).run();
}

Sphere enclosing(const std::vector<Sphere>& spheres) {
  Box box;
  for (const Sphere& s : spheres) box.add(s.centre, s.radius);
  Sphere out{box.centre(), 0};
  for (const Sphere& s : spheres)
    out.radius = std::max(out.radius, distance(s.centre, out.centre) + s.radius);
  out.radius = grown(out.radius, out.centre);
  return out;
}

Sphere enclosing(std::span<const Vec3> points) {
  Box box;
  for (const Vec3& p : points) box.add(p, 0);
  Sphere out{box.centre(), 0};
  for (const Vec3& p : points) out.radius = std::max(out.radius, distance(p, out.centre));
  out.radius = grown(out.radius, out.centre);
  return out;
}

std::uint64_t pair_count(const PriorityHierarchy& hierarchy) {
  if (!hierarchy.pairs.empty()) return hierarchy.pairs.size();
  std::uint64_t pairs = 0;
  for (const Group& group : hierarchy.groups)
    if (group.choice == kNone)
      pairs += std::uint64_t{group.member_count} * (group.member_count - 1) / 2;
  return pairs;
}

std::uint64_t depth(const PriorityHierarchy& hierarchy) {
  if (!hierarchy.pairs.empty()) return hierarchy.nodes.size();
  std::vector<std::uint64_t> group_depth(hierarchy.groups.size(), 0);
  std::uint64_t deepest = 0;
  std::vector<std::uint64_t> node_depth;
  for (std::size_t g = 0; g < hierarchy.groups.size(); ++g) {
    const Group& group = hierarchy.groups[g];
    if (group.node_count == 0)
      for (std::uint32_t m = 0; m < group.member_count; ++m)
        if (const Member& member = hierarchy.members[group.first_member + m]; member.is_group)
          group_depth[member.index] = group_depth[g];
    node_depth.assign(group.node_count, group_depth[g] + 1);
    for (std::uint32_t n = 0; n < group.node_count; ++n) {
      const SeparationNode& node = hierarchy.nodes[group.first_node + n];
      deepest = std::max(deepest, node_depth[n]);
      for (const std::int32_t child : {node.true_child, node.false_child}) {
        if (child >= 0) {
          node_depth[static_cast<std::size_t>(child)] = node_depth[n] + 1;
          continue;
        }
        const Member& member =
            hierarchy.members[group.first_member + static_cast<std::uint32_t>(~child)];
        if (member.is_group) group_depth[member.index] = node_depth[n];
      }
    }
  }
  return deepest;
}

}  // namespace cigsim
