// SPDX-License-Identifier: MIT
// The prepared database: what the machine reads in real time.
//
// Flat arrays, in the manner of a memory image. An *item* is the unit that the priority processor
// orders: a convex object, a piece of one, or a sheet of coplanar faces. Within an item the order
// of the faces is right from every eyepoint (Schumacker's fixed face priority). A *group* is a
// level of the priority hierarchy: at most 64 members, each an item or a further group, and the
// separation planes between them as a binary tree, so that every group is listable by construction
// (Stump 1986, ch. III: a plane resolves each pair of objects on its two sides).
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "models/environment/environment.hpp"
#include "models/environment/read.hpp"
#include "models/numeric/plane.hpp"

namespace cigsim {

inline constexpr std::uint32_t kNone = 0xffffffffu;

/// A convex polygon, anticlockwise as seen from its front.
struct PreparedFace {
  std::uint32_t first_corner = 0;  ///< into FaceSet::corners
  std::uint32_t corner_count = 0;
  std::uint32_t plane = 0;   ///< into FaceSet::planes; the normal is on the front
  std::uint32_t object = 0;  ///< object number, from 1
  Colour colour;             ///< shade included
  bool two_sided = false;    ///< seen from the back too
};

struct Sphere {
  Vec3 centre;
  double radius = 0;
};

struct Item {
  std::uint32_t first_face = 0, face_count = 0;  ///< in fixed priority order, highest first
  std::uint32_t first_vertex = 0,
                vertex_count = 0;  ///< corners of its faces index from first_vertex
  Sphere sphere;
};

/// The exact coordinates of a vertex that a cut made, where a double does not hold them.
struct CutVertex {
  std::uint32_t vertex = 0;
  ExactVec position;
};

/// Items and all that they need; the static environment is one set, moving pieces another.
struct FaceSet {
  std::vector<Vec3> vertices;
  std::vector<CutVertex> cut_vertices;  ///< ascending by vertex
  std::vector<std::uint32_t> corners;   ///< vertex index relative to the item's first_vertex
  std::vector<Plane> planes;
  std::vector<PreparedFace> faces;
  std::vector<Item> items;

  /// The exact position of a cut vertex, or nullptr when the double is exact.
  const ExactVec* exact(std::uint32_t vertex) const {
    const auto cut =
        std::lower_bound(cut_vertices.begin(), cut_vertices.end(), vertex,
                         [](const CutVertex& c, std::uint32_t v) { return c.vertex < v; });
    return cut == cut_vertices.end() || cut->vertex != vertex ? nullptr : &cut->position;
  }

  void clear() {
    vertices.clear();
    cut_vertices.clear();
    corners.clear();
    planes.clear();
    faces.clear();
    items.clear();
  }
};

/// An inner node of a group's plane tree. A child >= 0 is a node of the group, a child < 0 is the
/// member ~child. The masks have a bit a member; TRUE is the side of the plane's normal.
struct SeparationNode {
  std::uint32_t plane = 0;  ///< into PriorityHierarchy::planes
  std::int32_t true_child = 0, false_child = 0;
  std::uint64_t true_members = 0, false_members = 0;
  /// Pairs that the plane resolves, into PriorityHierarchy::pairs, where a table made by hand lists
  /// them (then the children are 0 and mean nothing, and the masks hold the members of the pairs);
  /// none listed: every TRUE member with every FALSE member.
  std::uint32_t first_pair = 0, pair_count = 0;
};

/// A TRUE/FALSE pair of members of a group (Stump 1986, ch. III).
struct MemberPair {
  std::uint8_t true_member = 0, false_member = 0;
};

struct Member {
  bool is_group = false;
  std::uint32_t index = 0;  ///< into FaceSet::items or PriorityHierarchy::groups
  Sphere sphere;            ///< everything below
  /// Of a choice only: the item has no faces. It holds the place of a description that shows
  /// nothing here, for the moving pieces that may come there, and is never listed itself.
  bool placeholder = false;
};

/// A thing with several descriptions, of which one is shown at a time (Levine 1975, ch. II.G).
struct PreparedChoice {
  Sphere sphere;  ///< around all descriptions, in the system's axes
  /// Of each description but the last and most detailed one: the largest projected radius, in
  /// elements, at which it is shown; ascending from above 0.
  std::vector<double> thresholds;
};

inline constexpr std::uint32_t kGroupCapacity = 64;

struct Group {
  std::uint32_t first_member = 0, member_count = 0;
  /// Node 0 is the root; member_count - 1 nodes (of a table made by hand, at most 63; of a choice
  /// none).
  std::uint32_t first_node = 0, node_count = 0;
  /// Into PriorityHierarchy::choices: the members are the descriptions, least detailed first, and
  /// one of them is active at a time. A choice that a plane cuts has several such groups.
  std::uint32_t choice = kNone;
};

struct PriorityHierarchy {
  std::vector<Plane> planes;
  std::vector<SeparationNode> nodes;
  /// Of a table made by hand, node by node; then there is one group, of items. Empty: none is.
  std::vector<MemberPair> pairs;
  std::vector<Member> members;
  std::vector<Group> groups;  ///< groups[0] is the root when there is an item
  std::vector<PreparedChoice> choices;
};

/// A coordinate system with its own faces and priority data, in its own axes.
struct PreparedSystem {
  std::string name;
  Placement placement;
  std::vector<MotionKey> motion;
  FaceSet set;
  PriorityHierarchy hierarchy;
  Sphere sphere;  ///< of all items
};

struct PreparationReport {
  std::uint64_t objects = 0, faces = 0, vertices = 0;
  std::uint64_t convex_objects = 0, unclosed_objects = 0;
  std::uint64_t items = 0;   ///< what the priority lists hold
  std::uint64_t pieces = 0;  ///< convex objects and faces of the others, counted after the cuts
  std::uint64_t cuts = 0;    ///< how often a plane cut an item in two
  std::uint64_t planes = 0, groups = 0, depth = 0;
  std::uint64_t pairs = 0;    ///< TRUE/FALSE pairs over all groups
  std::uint64_t choices = 0;  ///< things with several descriptions
  double seconds = 0;
  std::vector<Notice> notices;
};

struct Database {
  std::string name;
  std::uint32_t object_count = 0;
  std::vector<std::string> object_names;
  std::vector<PreparedSystem> systems;  ///< systems[0] is the environment's own
  FaceSet ground;                       ///< one item; faces from the last drawn to the first
  Colour background;
  DefaultView view;  ///< the scene's, or a sensible one
  PreparationReport report;
};

}  // namespace cigsim
