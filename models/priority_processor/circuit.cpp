// SPDX-License-Identifier: MIT
#include "models/priority_processor/circuit.hpp"

#include <algorithm>
#include <array>

#include "models/database/separation_pairs.hpp"

namespace cigsim::priority_processor {
namespace {

// A bit a member that the member of the place precedes.
using Precedes = std::array<std::uint64_t, kGroupCapacity>;

Precedes precedes_at(const PriorityHierarchy& hierarchy, const Group& group, std::uint64_t active,
                     std::uint64_t eye_true) {
  Precedes precedes{};
  const auto add = [&](std::uint32_t near, std::uint32_t far) {
    if ((active >> near & 1) && (active >> far & 1)) precedes[near] |= std::uint64_t{1} << far;
  };
  for (std::uint32_t n = 0; n < group.node_count; ++n) {
    const SeparationNode& node = hierarchy.nodes[group.first_node + n];
    const bool eye = (eye_true >> n) & 1;
    for_each_pair(hierarchy, node,
                  [&](std::uint32_t t, std::uint32_t f) { eye ? add(t, f) : add(f, t); });
  }
  return precedes;
}

// The shortest way from a member back to itself, without its end; empty when there is none.
std::vector<std::uint32_t> way_round(const Precedes& precedes, std::uint32_t start) {
  std::array<std::uint32_t, kGroupCapacity> from{};
  std::vector<std::uint32_t> open{start};
  std::uint64_t met = 0;
  for (std::size_t at = 0; at < open.size(); ++at) {
    const std::uint32_t member = open[at];
    if (precedes[member] >> start & 1) {
      std::vector<std::uint32_t> way;
      for (std::uint32_t m = member; m != start; m = from[m]) way.push_back(m);
      way.push_back(start);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for_each_member(precedes[member] & ~met, [&](std::uint32_t next) {
      from[next] = member;
      open.push_back(next);
    });
    met |= precedes[member];
  }
  return {};
}

std::vector<std::uint32_t> shortest_circuit(const Precedes& precedes, std::uint64_t active) {
  std::vector<std::uint32_t> best;
  for_each_member(active, [&](std::uint32_t start) {
    std::vector<std::uint32_t> way = way_round(precedes, start);
    if (!way.empty() && (best.empty() || way.size() < best.size())) best = std::move(way);
  });
  return best;
}

std::uint32_t object_of(const PriorityHierarchy& hierarchy, const FaceSet& objects,
                        const Member& member) {
  const Member* m = &member;
  while (m->is_group) {
    m = &hierarchy.members[hierarchy.groups[m->index].first_member];
    while (m->placeholder) ++m;
  }
  return objects.faces[objects.items[m->index].first_face].object;
}

}  // namespace

ListabilityFault listability_fault(const PriorityHierarchy& hierarchy, const FaceSet& objects,
                                   std::uint32_t group, std::uint64_t active,
                                   std::uint64_t eye_true) {
  const Group& g = hierarchy.groups[group];
  const Precedes precedes = precedes_at(hierarchy, g, active, eye_true);
  const auto number = [&](std::uint32_t m) {
    return object_of(hierarchy, objects, hierarchy.members[g.first_member + m]);
  };
  ListabilityFault fault;
  fault.group = group;
  for_each_member(active, [&](std::uint32_t m) { fault.members.push_back(number(m)); });
  for (const std::uint32_t m : shortest_circuit(precedes, active))
    fault.circuit.push_back(number(m));
  for_each_member(active, [&](std::uint32_t a) {
    for_each_member(active, [&](std::uint32_t b) {
      if (a < b && !(precedes[a] >> b & 1) && !(precedes[b] >> a & 1))
        fault.unresolved.push_back({number(a), number(b)});
    });
  });
  return fault;
}

}  // namespace cigsim::priority_processor
