// SPDX-License-Identifier: MIT
#include "models/priority_processor/memory.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "models/database/separation_pairs.hpp"
#include "models/machine/scale.hpp"
#include "models/numeric/unit_normal.hpp"

namespace cigsim::priority_processor {
namespace {

using Words = std::vector<std::uint32_t>;

std::uint32_t depth_below(const PriorityHierarchy& hierarchy, const Group& group) {
  std::uint32_t below = 0;
  for (std::uint32_t m = 0; m < group.member_count; ++m) {
    const Member& member = hierarchy.members[group.first_member + m];
    if (member.is_group)
      below = std::max(below, depth_below(hierarchy, hierarchy.groups[member.index]));
  }
  return below + 1;
}

std::vector<MemberPair> pairs_of(const PriorityHierarchy& hierarchy, const SeparationNode& node) {
  std::vector<MemberPair> pairs;
  for_each_pair(hierarchy, node, [&](std::uint32_t t, std::uint32_t f) {
    pairs.push_back({static_cast<std::uint8_t>(t), static_cast<std::uint8_t>(f)});
  });
  return pairs;
}

// Returns whether there was anything to add.
bool add_plane(const PlaneWords& plane, const std::vector<MemberPair>& pairs, Words& words) {
  if (pairs.empty()) return false;
  if (pairs.size() > kMostPairs)
    throw std::invalid_argument("a separation plane has " + std::to_string(pairs.size()) +
                                " pairs, and the priority processor counts " +
                                std::to_string(kMostPairs) + " at most; divide the group");
  for (const Word n : plane.normal) words.push_back(static_cast<std::uint32_t>(n));
  const auto distance = static_cast<std::uint64_t>(plane.distance);
  words.push_back(static_cast<std::uint32_t>(distance));
  words.push_back(static_cast<std::uint32_t>(distance >> 32));
  words.push_back(static_cast<std::uint32_t>(pairs.size() - 1));
  for (const MemberPair& pair : pairs)
    words.push_back(pair.true_member | static_cast<std::uint32_t>(pair.false_member) << 8);
  return true;
}

}  // namespace

PlaneWords plane_words(const Plane& plane, int scale, const WordFormats& formats) {
  const Vec3 n = unit_normal(plane);
  PlaneWords words;
  if (n == Vec3{}) return words;  // every point is on the plane
  const double normal[3] = {n.x, n.y, n.z};
  const double point[3] = {plane.exact.p.x, plane.exact.p.y, plane.exact.p.z};
  constexpr double kLimit = 0x1p62;
  // The whole and the broken part of each coordinate apart: products of the former are exact.
  std::uint64_t whole = 0;  // each product may wrap; modulo 2^64 the sum comes out right
  double broken = 0, estimate = 0;
  bool near = true;
  for (int i = 0; i < 3; ++i) {
    words.normal[i] = direction_word(normal[i], formats);
    if (words.normal[i] == 0) continue;
    const double scaled = std::ldexp(point[i], scale);
    const double down = std::floor(scaled);
    estimate += words.normal[i] * scaled;
    broken += words.normal[i] * (scaled - down);
    if (std::abs(down) < kLimit)
      whole += static_cast<std::uint64_t>(words.normal[i]) *
               static_cast<std::uint64_t>(static_cast<Accumulator>(down));
    else
      near = false;
  }
  const auto rest = static_cast<std::uint64_t>(static_cast<Accumulator>(std::floor(broken + 0.5)));
  const bool exact = near && std::abs(estimate) < kLimit;
  words.distance =
      static_cast<Accumulator>(exact ? whole + rest
                                     : static_cast<std::uint64_t>(static_cast<Accumulator>(
                                           std::clamp(estimate, -kLimit, kLimit))));
  return words;
}

PriorityMemory::PriorityMemory(const PriorityHierarchy& hierarchy, std::size_t item_count,
                               int scale, const MachineDescription& machine)
    : items(static_cast<std::uint32_t>(item_count)) {
  if (!hierarchy.groups.empty()) depth = depth_below(hierarchy, hierarchy.groups[0]);
  if (machine.hierarchy_depth != 0 && depth > machine.hierarchy_depth)
    throw std::invalid_argument("the scene's priority hierarchy has " + std::to_string(depth) +
                                " levels of groups, and machine '" + machine.name + "' has " +
                                std::to_string(machine.hierarchy_depth) +
                                " (hierarchy_depth); take a simpler scene or another machine");
  for (const Group& group : hierarchy.groups) {
    const auto record = static_cast<std::uint32_t>(words.size());
    group_address.push_back(record);
    words.insert(words.end(), 2, 0);
    for (std::uint32_t n = 0; n < group.node_count; ++n) {
      const SeparationNode& node = hierarchy.nodes[group.first_node + n];
      const PlaneWords plane = plane_words(hierarchy.planes[node.plane], scale, machine.formats);
      words[record + 1] += add_plane(plane, pairs_of(hierarchy, node), words);
    }
    words[record] = static_cast<std::uint32_t>(words.size());
    for (std::uint32_t m = 0; m < group.member_count; ++m) {
      const Member& member = hierarchy.members[group.first_member + m];
      words.push_back(member.is_group ? kGroupBit : member.index);
    }
  }
}

PriorityBank::PriorityBank(const PriorityMemory& memory)
    : memory_(&memory), words_(kDirectoryBegin + memory.items) {}

void PriorityBank::fill(const ActiveEnvironment& active, const ViewWords& view,
                        std::uint32_t ground_items) {
  for (const std::uint32_t item : listed_) words_[kDirectoryBegin + item] = 0;
  listed_.clear();
  words_.resize(first_record());
  for (std::uint32_t i = 0; i < 3; ++i)
    words_[kEyeAt + i] = static_cast<std::uint32_t>(view.eye[i]);
  words_[kDirectoryAt] = kDirectoryBegin;
  words_[kGroundAt] = ground_items;
  words_[kRootAt] = active.groups.empty() ? 0 : first_record();
  words_[kPiecesAt] = 0;
  for (const ActiveGroup& group : active.groups) {
    words_.push_back(memory_->group_address[group.group]);
    words_.push_back(static_cast<std::uint32_t>(group.active));
    words_.push_back(static_cast<std::uint32_t>(group.active >> 32));
    words_.push_back(first_record() + kRecordWords * group.first_child);
  }
  add_lists(active);
}

// Pieces come in the order of their static items, and those in front of it first.
void PriorityBank::add_lists(const ActiveEnvironment& active) {
  const auto next_address = [&] { return static_cast<std::uint32_t>(words_.size()); };
  if (active.moving.empty()) return;
  if (active.groups.empty()) {
    words_[kPiecesAt] = next_address();
    for (const auto& piece : active.moving) words_.push_back(piece.item | kMovingBit);
    words_.back() |= kLastBit;
    return;
  }
  for (std::size_t i = 0; i < active.moving.size();) {
    const std::uint32_t item = active.moving[i].neighbour;
    const bool instead = active.moving[i].instead;
    if (item == kNone) break;
    words_[kDirectoryBegin + item] = next_address();
    listed_.push_back(item);
    const auto here = [&] {
      return i < active.moving.size() && active.moving[i].neighbour == item;
    };
    for (; here() && active.moving[i].before; ++i)
      words_.push_back(active.moving[i].item | kMovingBit);
    if (!instead) words_.push_back(item);
    for (; here(); ++i) words_.push_back(active.moving[i].item | kMovingBit);
    words_.back() |= kLastBit;
  }
}

}  // namespace cigsim::priority_processor
