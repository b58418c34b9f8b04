// SPDX-License-Identifier: MIT
// Separation planes with hand-written pairs, and Stump's worked examples (1986, ch. III).
#pragma once

#include <vector>

#include "models/machine/scale.hpp"
#include "tests/levels/priority_bench.hpp"

namespace cigsim::test {

inline ViewWords eye_words(const Vec3& eye, int scale, const WordFormats& formats) {
  ViewWords words;
  std::uint64_t overflows = 0;
  const double eyes[3] = {eye.x, eye.y, eye.z};
  for (int i = 0; i < 3; ++i) words.eye[i] = coordinate_word(eyes[i], scale, formats, overflows);
  return words;
}

struct TablePlane {
  Vec3 normal, point;
  std::vector<MemberPair> pairs;  ///< objects from 0
};

/// Objects 0 to n - 1 in one group with hand-written pairs.
inline PriorityHierarchy table_hierarchy(std::uint32_t objects,
                                         const std::vector<TablePlane>& planes) {
  PriorityHierarchy h;
  h.groups.push_back({0, objects, 0, static_cast<std::uint32_t>(planes.size())});
  for (std::uint32_t m = 0; m < objects; ++m) h.members.push_back({false, m, {}});
  for (const TablePlane& plane : planes) {
    SeparationNode node;
    node.plane = static_cast<std::uint32_t>(h.planes.size());
    node.first_pair = static_cast<std::uint32_t>(h.pairs.size());
    node.pair_count = static_cast<std::uint32_t>(plane.pairs.size());
    h.planes.push_back(plane_with_normal(plane.point, plane.normal));
    h.pairs.insert(h.pairs.end(), plane.pairs.begin(), plane.pairs.end());
    h.nodes.push_back(node);
  }
  return h;
}

inline constexpr int kTableScale = 20;

/// The same, seen from `eye`.
inline PriorityCase table_case(std::uint32_t objects, const std::vector<TablePlane>& planes,
                               const Vec3& eye) {
  const PriorityHierarchy h = table_hierarchy(objects, planes);
  PriorityCase c;
  c.memories.push_back(
      std::make_unique<priority_processor::PriorityMemory>(h, objects, kTableScale, c.machine));
  ActiveEnvironment active;
  active.groups.push_back({0, (std::uint64_t{1} << objects) - 1, 1});
  c.filled.assign(2, priority_processor::PriorityBank(*c.memories[0]));
  for (priority_processor::PriorityBank& bank : c.filled)
    bank.fill(active, eye_words(eye, kTableScale, c.machine.formats), 0);
  c.frames = 1;
  return c;
}

namespace stump {

inline constexpr std::uint8_t A = 0, B = 1, C = 2, D = 3;
inline constexpr Vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

// The eye at the origin is FALSE on planes whose normals point away from it.

/// Fig. 7, as far as its table goes.
inline const std::vector<TablePlane> kFig7{{kX, {10, 0, 0}, {{C, B}, {D, A}}},
                                           {kY, {0, 10, 0}, {{B, D}, {C, A}}},
                                           {kZ, {0, 0, 10}, {{B, A}, {D, C}}}};
/// The same objects with other pairs, which are listable.
inline const std::vector<TablePlane> kFig7Reassigned{{kX, {10, 0, 0}, {{C, A}, {C, B}}},
                                                     {kY, {0, 10, 0}, {{D, A}, {D, B}}},
                                                     {kZ, {0, 0, 10}, {{B, A}, {D, C}}}};

inline const std::vector<TablePlane> kTestCase1{{kX, {10, 0, 0}, {{1, 0}}}};
inline const std::vector<TablePlane> kTestCase2{
    {{-1, 0, 0}, {60, 0, 0}, {{2, 0}, {2, 1}, {3, 0}, {3, 1}}},
    {{1, 1, 0}, {10, 10, 0}, {{3, 2}, {1, 0}}}};
inline const std::vector<TablePlane> kTestCase3{{kX, {25, 0, 0}, {{4, 0}, {4, 1}, {4, 2}, {4, 3}}},
                                                {kY, {0, 25, 0}, {{3, 0}, {3, 1}, {3, 2}}},
                                                {kX, {10, 0, 0}, {{2, 0}, {2, 1}}},
                                                {kY, {0, 10, 0}, {{1, 0}}}};

}  // namespace stump
}  // namespace cigsim::test
