// SPDX-License-Identifier: MIT
#include "sim/stability/listing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "models/boundary/certified_edges.hpp"
#include "models/machine/scale.hpp"
#include "models/numeric/unit_normal.hpp"
#include "models/priority_processor/functional.hpp"
#include "models/priority_processor/functional_words.hpp"
#include "sim/stability/posing.hpp"
#include "sim/stability/sight.hpp"

namespace cigsim::stability {
namespace {

// One group of items, its table as one made by hand. The vertices are those that the planes are
// defined by: the words are scaled for them.
Database database_of(const Table& table) {
  Database database;
  PreparedSystem& system = database.systems.emplace_back();
  PriorityHierarchy& hierarchy = system.hierarchy;
  for (std::uint32_t i = 0; i < table.planes.size(); ++i) {
    const PlaneDefinition& d = table.planes[i];
    hierarchy.planes.push_back(make_plane(d));
    SeparationNode node;
    node.plane = node.first_pair = i;
    node.pair_count = 1;
    node.true_members = std::uint64_t{1} << table.pairs[i].true_member;
    node.false_members = std::uint64_t{1} << table.pairs[i].false_member;
    hierarchy.nodes.push_back(node);
    system.set.vertices.push_back(d.p);
    if (d.u0 != Vec3{} || d.v0 != Vec3{})
      system.set.vertices.insert(system.set.vertices.end(), {d.u0, d.u1, d.v0, d.v1});
  }
  hierarchy.pairs = table.pairs;
  for (std::uint32_t m = 0; m < table.members; ++m) {
    Item item;
    item.face_count = 1;
    system.set.items.push_back(item);
    hierarchy.members.push_back({false, m, {}, false});
  }
  system.set.faces.resize(1);
  Group group;
  group.member_count = table.members;
  group.node_count = static_cast<std::uint32_t>(hierarchy.nodes.size());
  hierarchy.groups.push_back(group);
  return database;
}

ActiveEnvironment all_in_view(const Table& table, const ViewTransform& view) {
  ActiveEnvironment active;
  active.view = view;
  active.groups.push_back({0, (std::uint64_t{1} << table.members) - 1, 0});
  return active;
}

template <class N>
Listing list_as(const Database& database, const ActiveEnvironment& active) {
  const PreparedSystem& system = database.systems[0];
  PriorityList out;
  priority_processor::Functional<N>(priority_processor::Method::kCounters)
      .compute(system.hierarchy, system.set, active, {}, out);
  Listing listing;
  for (const ItemRef& item : out.items) listing.members.push_back(item.item);
  listing.fault = !out.faults.empty();
  return listing;
}

int scale_of(const Database& database, const ViewTransform& view, const Format& format) {
  return coordinate_scale(database, format.machine.formats, largest_coordinate(view.eye));
}

Listing list_in_words(const Database& database, const ActiveEnvironment& active,
                      const Format& format) {
  const PreparedSystem& system = database.systems[0];
  const int scale = scale_of(database, active.view, format);
  const priority_processor::PriorityMemory memory(system.hierarchy, system.set.items.size(), scale,
                                                  format.machine);
  std::uint64_t overflows = 0;
  priority_processor::PriorityBank bank(memory);
  bank.fill(active, view_words(active.view, scale, format.machine.formats, overflows), 0);
  std::vector<ItemWord> items;
  priority_processor::Figures figures;
  priority_processor::FunctionalWords(0).compute(bank, items, figures);
  Listing listing;
  for (const ItemWord& item : items)
    if (!item.end) listing.members.push_back(item.item);
  listing.fault = !figures.faults.empty();
  return listing;
}

}  // namespace

Listing list(const Table& table, const ViewTransform& view, const Format& format) {
  const Database database = database_of(table);
  const ActiveEnvironment active = all_in_view(table, view);
  switch (format.arithmetic) {
    case Arithmetic::kFloat:
      return list_as<float>(database, active);
    case Arithmetic::kMachine:
      return list_in_words(database, active, format);
    case Arithmetic::kExact:
      return list_as<Exact>(database, active);
    case Arithmetic::kCertified:
      return list_as<Certified>(database, active);
    case Arithmetic::kDouble:
      break;
  }
  return list_as<double>(database, active);
}

Listing exact_list(const Table& table, const Vec3& eye) {
  std::vector<std::uint32_t> counts(table.members, 0);
  for (std::size_t i = 0; i < table.planes.size(); ++i) {
    const bool eye_true = exact_side(table.planes[i], eye) >= 0;
    ++counts[eye_true ? table.pairs[i].false_member : table.pairs[i].true_member];
  }
  Listing listing;
  listing.members.resize(table.members);
  std::iota(listing.members.begin(), listing.members.end(), 0u);
  std::stable_sort(listing.members.begin(), listing.members.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return counts[a] < counts[b]; });
  for (std::uint32_t place = 0; place < table.members; ++place)
    listing.fault |= counts[listing.members[place]] != place;
  return listing;
}

double plane_bound_in_words(const PlaneDefinition& plane, const ViewTransform& view,
                            const Format& format) {
  const Table table{2, {plane}, {{0, 1}}};
  const int scale = scale_of(database_of(table), view, format);
  const Vec3 n = unit_normal(make_plane(plane)), d = view.eye - plane.p;
  const double half_direction = std::ldexp(1, -format.machine.formats.direction_fraction - 1);
  const double words = (std::abs(n.x) + std::abs(n.y) + std::abs(n.z)) / 2 + 0x1p-31;
  return std::ldexp(words, -scale) +
         half_direction * (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
}

}  // namespace cigsim::stability
