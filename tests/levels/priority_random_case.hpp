// SPDX-License-Identifier: MIT
// Hierarchies and frames for the priority processor made at random, and their list by the
// definition.
#pragma once

#include <algorithm>
#include <vector>

#include "tests/levels/priority_table_case.hpp"

namespace cigsim::test {

/// What a hierarchy keeps to.
struct PriorityLimits {
  std::uint32_t members = 64;  ///< of a group
  std::uint32_t levels = 4;    ///< of groups
};

/// A tree of groups, in places more than the counters hold, in places not listable.
inline PriorityHierarchy random_hierarchy(Random& random, std::uint32_t& items,
                                          const PriorityLimits& limits) {
  PriorityHierarchy h;
  items = 0;
  struct Open {
    std::uint32_t group, depth;
  };
  h.groups.emplace_back();
  for (std::vector<Open> open{{0, 1}}; !open.empty();) {
    const Open at = open.front();
    open.erase(open.begin());
    Group group;
    group.first_member = static_cast<std::uint32_t>(h.members.size());
    group.member_count =
        1 + random.below(random.below(8) == 0 ? limits.members : std::min(limits.members, 6u));
    for (std::uint32_t m = 0; m < group.member_count; ++m) {
      Member member;
      member.is_group = at.depth < limits.levels && random.below(3) == 0 && h.groups.size() < 20;
      member.index = member.is_group ? static_cast<std::uint32_t>(h.groups.size()) : items++;
      if (member.is_group) {
        open.push_back({member.index, at.depth + 1});
        h.groups.emplace_back();
      }
      h.members.push_back(member);
    }
    group.first_node = static_cast<std::uint32_t>(h.nodes.size());
    const bool listable = random.below(3) != 0;
    for (std::uint32_t m = 0; m + 1 < group.member_count; ++m) {
      SeparationNode node;
      node.plane = static_cast<std::uint32_t>(h.planes.size());
      h.planes.push_back(
          plane_with_normal({random.between(-8, 8), random.between(-8, 8), random.between(-8, 8)},
                            {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}));
      if (listable) {  // a chain: member m before all later ones or behind
        node.true_members = std::uint64_t{1} << m;
        for (std::uint32_t f = m + 1; f < group.member_count; ++f)
          node.false_members |= std::uint64_t{1} << f;
      } else {
        node.first_pair = static_cast<std::uint32_t>(h.pairs.size());
        node.pair_count = 1 + random.below(random.below(10) == 0 ? 400 : 10);
        for (std::uint32_t p = 0; p < node.pair_count; ++p) {
          const std::uint32_t t = random.below(group.member_count);
          const std::uint32_t f =
              (t + 1 + random.below(group.member_count - 1)) % group.member_count;
          h.pairs.push_back({static_cast<std::uint8_t>(t), static_cast<std::uint8_t>(f)});
        }
      }
      h.nodes.push_back(node);
    }
    group.node_count = static_cast<std::uint32_t>(h.nodes.size()) - group.first_node;
    h.groups[at.group] = group;
  }
  return h;
}

inline ActiveEnvironment random_frame(const PriorityHierarchy& h, std::uint32_t items,
                                      Random& random) {
  ActiveEnvironment active;
  active.view.eye = {random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
  if (random.below(8) != 0) active.groups.push_back({0, 0, 0});
  for (std::size_t g = 0; g < active.groups.size(); ++g) {
    const Group group = h.groups[active.groups[g].group];
    std::uint64_t mask = 0;
    for (std::uint32_t m = 0; m < group.member_count; ++m)
      if (random.below(4) != 0) mask |= std::uint64_t{1} << m;
    active.groups[g].active = mask;
    active.groups[g].first_child = static_cast<std::uint32_t>(active.groups.size());
    for (std::uint32_t m = 0; m < group.member_count; ++m) {
      const Member& member = h.members[group.first_member + m];
      if ((mask >> m & 1) && member.is_group) active.groups.push_back({member.index, 0, 0});
    }
  }
  std::uint32_t piece = 0;
  for (std::uint32_t item = 0; item < items; ++item) {
    if (random.below(6) != 0) continue;
    const std::uint32_t before = random.below(3), behind = random.below(3);
    for (std::uint32_t i = 0; i < before + behind; ++i)
      active.moving.push_back({piece++, active.groups.empty() ? kNone : item, i < before, i});
  }
  return active;
}

struct ExpectedItems {
  std::vector<ItemWord> items;
  std::vector<std::uint32_t> faults;
};

/// By the definition: members sorted by count, then number.
class ListByDefinition {
 public:
  ListByDefinition(const PriorityHierarchy& h, const ActiveEnvironment& a, const ViewWords& view,
                   int scale, const WordFormats& formats)
      : h_(h), a_(a), view_(view), scale_(scale), formats_(formats) {}

  ExpectedItems list(std::uint32_t ground) {
    if (a_.groups.empty())
      for (const auto& piece : a_.moving) put(SetId::kMoving, piece.item);
    else
      group(0);
    for (std::uint32_t i = 0; i < ground; ++i) put(SetId::kGround, i);
    out_.items.push_back({SetId::kStatic, 0, true});
    return out_;
  }

 private:
  void put(SetId set, std::uint32_t item) { out_.items.push_back({set, item, false}); }

  bool eye_true(const Plane& plane) const {
    const priority_processor::PlaneWords words =
        priority_processor::plane_words(plane, scale_, formats_);
    __extension__ using Wide = __int128;
    Wide sum = 0;
    for (int i = 0; i < 3; ++i) sum += Wide{words.normal[i]} * view_.eye[i];
    return sum >= Wide{words.distance};
  }

  void group(std::uint32_t active_index) {
    const ActiveGroup& active = a_.groups[active_index];
    const Group& group_ = h_.groups[active.group];
    const auto is_active = [&](std::uint32_t m) { return (active.active >> m & 1) != 0; };
    std::vector<int> counts(kGroupCapacity);
    std::vector<std::uint32_t> members;
    for (std::uint32_t m = 0; m < group_.member_count; ++m)
      if (is_active(m)) members.push_back(m);
    for (std::uint32_t n = 0; n < group_.node_count; ++n) {
      const SeparationNode& node = h_.nodes[group_.first_node + n];
      const bool eye = eye_true(h_.planes[node.plane]);
      const auto pair = [&](std::uint32_t t, std::uint32_t f) {
        if (is_active(t) && is_active(f)) ++counts[eye ? f : t];
      };
      for (std::uint32_t p = 0; p < node.pair_count; ++p)
        pair(h_.pairs[node.first_pair + p].true_member, h_.pairs[node.first_pair + p].false_member);
      if (node.pair_count == 0)
        for (std::uint32_t t = 0; t < 64; ++t)
          for (std::uint32_t f = 0; f < 64; ++f)
            if ((node.true_members >> t & 1) && (node.false_members >> f & 1)) pair(t, f);
    }
    for (int& c : counts) c = std::min(c, 63);
    std::stable_sort(members.begin(), members.end(),
                     [&](auto a, auto b) { return counts[a] < counts[b]; });
    for (std::size_t i = 0; i < members.size(); ++i)
      if (counts[members[i]] != static_cast<int>(i)) {
        out_.faults.push_back(active_index);
        break;
      }
    for (const std::uint32_t m : members) {
      const Member& member = h_.members[group_.first_member + m];
      if (!member.is_group) {
        item(member.index);
        continue;
      }
      std::uint32_t child = active.first_child;
      for (std::uint32_t b = 0; b < m; ++b)
        child += is_active(b) && h_.members[group_.first_member + b].is_group;
      group(child);
    }
  }

  void item(std::uint32_t index) {
    for (const auto& piece : a_.moving)
      if (piece.neighbour == index && piece.before) put(SetId::kMoving, piece.item);
    put(SetId::kStatic, index);
    for (const auto& piece : a_.moving)
      if (piece.neighbour == index && !piece.before) put(SetId::kMoving, piece.item);
  }

  const PriorityHierarchy& h_;
  const ActiveEnvironment& a_;
  const ViewWords& view_;
  int scale_;
  const WordFormats& formats_;
  ExpectedItems out_;
};

/// A case of two random frames with what is expected of them.
struct PriorityRandomCase {
  PriorityCase bench;
  ExpectedItems expected[2];

  explicit PriorityRandomCase(std::uint64_t seed, const PriorityLimits& limits = {}) {
    Random random(seed);
    constexpr int kScale = 24;
    bench.machine.formats.direction_fraction = random.below(2) ? 30 : 14;
    bench.machine.links.items = 1 + random.below(5);
    bench.machine.object_capacity = random.below(3) == 0 ? 1 + random.below(20) : 0;
    for (ExpectedItems& e : expected) {
      std::uint32_t items = 0;  // each frame is of a database of its own
      const PriorityHierarchy h = random_hierarchy(random, items, limits);
      bench.memories.push_back(
          std::make_unique<priority_processor::PriorityMemory>(h, items, kScale, bench.machine));
      bench.filled.emplace_back(*bench.memories.back());
      if (random.below(2))  // what a frame before has left must not matter
        bench.filled.back().fill(random_frame(h, items, random), {}, random.below(3));
      const ActiveEnvironment active = random_frame(h, items, random);
      const ViewWords view = eye_words(active.view.eye, kScale, bench.machine.formats);
      const std::uint32_t ground = random.below(3);
      bench.filled.back().fill(active, view, ground);
      e = ListByDefinition(h, active, view, kScale, bench.machine.formats).list(ground);
      const std::uint32_t capacity = bench.machine.object_capacity;
      if (capacity != 0 && e.items.size() - 1 > capacity)
        e.items.erase(e.items.begin() + capacity, e.items.end() - 1);
    }
    bench.frames = 4;
    bench.start_gap = random.below(2) ? 0 : random.below(3000);
    bench.pauses = random.below(3) == 0 ? 0 : random.bits();
  }
};

}  // namespace cigsim::test
