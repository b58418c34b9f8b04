// SPDX-License-Identifier: MIT
#include "sim/rtl/variant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace cigsim {
namespace {

constexpr std::uint64_t kMovingAllowance = 4;  // times the faces of a moving model
constexpr std::uint64_t kClippedCorners = 5;   // four sides of the picture and the hither plane
// Memories cost a simulation nothing, so that their sizes are coarse, and few are built.
constexpr std::uint64_t kLeastEdges = 4096, kLeastLines = 1024;
// Comparing cells of a machine without a capacity; a line with more ends the run with a message.
constexpr std::uint64_t kMostCells = 512;

constexpr std::uint32_t kMostEngine = 256;  // objects, and planes, of the SO engine

std::uint32_t depth(const PriorityHierarchy& hierarchy) {
  if (hierarchy.groups.empty()) return 0;
  std::vector<std::uint32_t> level{0};
  std::uint32_t levels = 0;
  for (; !level.empty(); ++levels) {
    std::vector<std::uint32_t> below;
    for (const std::uint32_t g : level) {
      const Group& group = hierarchy.groups[g];
      for (std::uint32_t m = 0; m < group.member_count; ++m) {
        const Member& member = hierarchy.members[group.first_member + m];
        if (member.is_group) below.push_back(member.index);
      }
    }
    level.swap(below);
  }
  return levels;
}

std::uint32_t power(std::uint64_t least, std::uint64_t value) {
  return static_cast<std::uint32_t>(std::bit_ceil(std::max(least, value)));
}

// A capacity of 0 is none.
std::uint64_t capped(std::uint64_t value, std::uint64_t capacity) {
  return capacity == 0 ? value : std::min(value, capacity);
}

}  // namespace

std::string RtlVariant::name() const {
  std::string text = module;
  for (const Parameter& p : parameters) text += fmt::format("-{}={}", p.name, p.value);
  return text;
}

bool RtlVariant::covers(const RtlVariant& other) const {
  return module == other.module &&
         std::equal(
             parameters.begin(), parameters.end(), other.parameters.begin(), other.parameters.end(),
             [](const auto& a, const auto& b) { return a.name == b.name && a.value >= b.value; });
}

RtlNeeds RtlNeeds::of(const Database& database) {
  RtlNeeds needs;
  const auto add = [&needs](const FaceSet& set, std::uint64_t times) {
    needs.faces += times * set.faces.size();
    for (const PreparedFace& face : set.faces)
      needs.edges += times * (face.corner_count + kClippedCorners);
  };
  for (const PreparedSystem& system : database.systems) {
    add(system.set, &system == &database.systems.front() ? 1 : kMovingAllowance);
    for (const Group& group : system.hierarchy.groups) {
      needs.members = std::max(needs.members, group.member_count);
      needs.planes = std::max(needs.planes, group.node_count);
    }
    needs.levels = std::max(needs.levels, depth(system.hierarchy));
  }
  add(database.ground, 1);
  return needs;
}

RtlNeeds RtlNeeds::with(const RtlNeeds& other) const {
  return {std::max(members, other.members), std::max(planes, other.planes),
          std::max(levels, other.levels), std::max(faces, other.faces),
          std::max(edges, other.edges)};
}

RtlVariant rtl_variant(Stage stage, const RtlNeeds& needs, const MachineDescription& machine) {
  const std::string name(name_of(stage));
  const std::uint64_t edges = capped(needs.edges, machine.edge_capacity);
  // Every face has a left edge and a right one at least.
  const std::uint64_t faces = std::min(capped(needs.faces, machine.face_capacity), edges / 2 + 1);
  switch (stage) {
    case Stage::kPriorityProcessor:
      return {
          name, name, {{"Members", power(8, needs.members)}, {"Levels", power(4, needs.levels)}}};
    case Stage::kEdgeOrderer:
      return {name,
              name,
              {{"Edges", power(kLeastEdges, edges)},
               {"Lines", power(kLeastLines, static_cast<std::uint64_t>(machine.raster.height))},
               {"Crossings",
                power(16, machine.crossing_capacity > 0 ? capped(edges, machine.crossing_capacity)
                                                        : std::min(edges, kMostCells))}}};
    case Stage::kPriorityResolver:
      return {name, name, {{"Faces", power(64, faces)}}};
    default:
      throw std::logic_error(name + " has no RTL");
  }
}

RtlVariant so_engine_variant(std::uint32_t objects, std::uint32_t planes) {
  return {"priority_processor", "so_engine", {{"Objects", objects}, {"Planes", planes}}};
}

RtlVariant so_engine_variant(const RtlNeeds& needs) {
  return so_engine_variant(std::min(power(4, needs.members), kMostEngine),
                           std::min(power(4, needs.planes), kMostEngine));
}

}  // namespace cigsim
