// SPDX-License-Identifier: MIT
#include "sim/listability_proof.hpp"

#include <algorithm>

#include "models/priority_processor/functional.hpp"
#include "sim/host_time.hpp"

namespace cigsim {
namespace {

constexpr std::size_t kMostFaults = 8;

std::uint64_t all_members(const Group& group) {
  return group.member_count == 64 ? ~std::uint64_t{0}
                                  : (std::uint64_t{1} << group.member_count) - 1;
}

std::uint64_t machine_sides(const PriorityHierarchy& hierarchy, const Group& group,
                            const Vec3& eye) {
  std::uint64_t eye_true = 0;
  for (std::uint32_t n = 0; n < group.node_count; ++n) {
    const Plane& plane = hierarchy.planes[hierarchy.nodes[group.first_node + n].plane];
    if (priority_processor::eye_on_true_side<double>(plane, eye)) eye_true |= std::uint64_t{1} << n;
  }
  return eye_true;
}

std::uint32_t object_of(const PriorityHierarchy& hierarchy, const FaceSet& set, Member member) {
  while (member.is_group) member = hierarchy.members[hierarchy.groups[member.index].first_member];
  const Item& item = set.items[member.index];
  return item.face_count == 0 ? 0 : set.faces[item.first_face].object;
}

class SceneProver {
 public:
  SceneProver(const Database& database, double contact_tolerance)
      : database_(database), tolerance_(contact_tolerance) {}

  SceneProof run() {
    for (std::uint32_t s = 0; s < database_.systems.size(); ++s) {
      const PreparedSystem& system = database_.systems[s];
      out_.by_hand = out_.by_hand || !system.hierarchy.pairs.empty();
      for (std::uint32_t g = 0; g < system.hierarchy.groups.size(); ++g) prove_group(s, g);
      HostTime time;
      out_.sides.push_back({s, listability::check_sides(system.hierarchy, system.set, tolerance_)});
      out_.side_milliseconds += time.lap();
    }
    return std::move(out_);
  }

 private:
  void prove_group(std::uint32_t s, std::uint32_t g) {
    const PriorityHierarchy& hierarchy = database_.systems[s].hierarchy;
    const Group& group = hierarchy.groups[g];
    // Several members without a plane are descriptions of one thing, shown one at a time.
    if (group.member_count > 1 && group.node_count == 0) return;
    HostTime time;
    listability::PriorityTable table = listability::table_of_group(hierarchy, g);
    listability::Proof proof = listability::prove(table);
    out_.milliseconds += time.lap();
    ++out_.groups;
    out_.largest_group = std::max<std::uint64_t>(out_.largest_group, table.members);
    out_.members += table.members;
    out_.planes += table.planes.size();
    out_.pairs += table.pairs.size();
    out_.triples += proof.triples;
    out_.cells += proof.cells;
    if (proof.listable) return;
    if (out_.fault_count++ < kMostFaults) add_fault(s, g, std::move(table), std::move(proof));
  }

  void add_fault(std::uint32_t s, std::uint32_t g, listability::PriorityTable table,
                 listability::Proof proof) {
    const PreparedSystem& system = database_.systems[s];
    const Group& group = system.hierarchy.groups[g];
    GroupFault fault{s, g, std::move(table), std::move(proof), {}, std::nullopt};
    for (std::uint32_t m = 0; m < group.member_count; ++m)
      fault.objects.push_back(object_of(system.hierarchy, system.set,
                                        system.hierarchy.members[group.first_member + m]));
    if (fault.proof.witness && fault.proof.witness->eye.rounded) {
      const Vec3& eye = *fault.proof.witness->eye.rounded;
      fault.machine =
          priority_processor::listability_fault(system.hierarchy, system.set, g, all_members(group),
                                                machine_sides(system.hierarchy, group, eye));
    }
    out_.faults.push_back(std::move(fault));
  }

  const Database& database_;
  double tolerance_;
  SceneProof out_;
};

}  // namespace

std::uint64_t SceneProof::side_faults() const {
  std::uint64_t n = 0;
  for (const SystemSides& system : sides) n += system.check.fault_count;
  return n;
}

SceneProof prove_scene(const Database& database, double contact_tolerance) {
  return SceneProver(database, contact_tolerance).run();
}

EyeReport look_from(const Database& database, const Vec3& eye) {
  const PriorityHierarchy& hierarchy = database.systems[0].hierarchy;
  EyeReport out;
  if (hierarchy.groups.empty()) return out;
  const Group& group = hierarchy.groups[0];
  const std::uint64_t eye_true = machine_sides(hierarchy, group, eye);
  for (std::uint32_t n = 0; n < group.node_count; ++n)
    out.eye_true.push_back((eye_true >> n & 1) != 0);
  const auto counts = priority_processor::counters(
      std::span(hierarchy.nodes.data() + group.first_node, group.node_count), eye_true,
      all_members(group), hierarchy.pairs);
  out.counts.assign(counts.begin(), counts.begin() + group.member_count);
  out.unique = listability::is_permutation(out.counts);
  return out;
}

}  // namespace cigsim
