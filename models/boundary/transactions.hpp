// SPDX-License-Identifier: MIT
// The transactions that pass between stages, every quantity of the stage's number type N.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "models/database/database.hpp"
#include "models/numeric/number.hpp"

namespace cigsim {

/// What the pilot's station sends for a frame. Environment units and degrees.
struct Viewpoint {
  Placement eye;
  double fov = 60;  ///< vertical, degrees, in (0, 180)
};

/// The raster: width x height square elements, row 0 at the top; element (c, r) is sampled at
/// (c + 1/2, r + 1/2).
struct Raster {
  int width = 1024, height = 1024;
};

/// Environment to viewpoint system (left-handed: u along the line of sight, v right, w up):
/// (u, v, w) = rotation * (p - eye). A point projects to column width/2 + focal v/u and row
/// height/2 - focal w/u. Doubles: every level takes these values as exact.
struct ViewTransform {
  Vec3 eye;
  Mat3 rotation;
  double focal = 1;  ///< raster units
  Raster raster;
};

/// Which faces an item reference means: the static environment, the pieces of moving models placed
/// for this frame, or the ground.
enum class SetId : std::uint8_t { kStatic = 0, kMoving = 1, kGround = 2 };

struct ItemRef {
  SetId set = SetId::kStatic;
  std::uint32_t item = 0;
  friend bool operator==(const ItemRef&, const ItemRef&) = default;
};

/// A group in view with the members that are in view (bit a member).
struct ActiveGroup {
  std::uint32_t group = 0;
  std::uint64_t active = 0;
  std::uint32_t first_child = 0;  ///< active groups below: consecutive, in member order
};

/// frame_calculator -> geometry_processor and priority_processor.
struct ActiveEnvironment {
  ViewTransform view;
  std::vector<ActiveGroup> groups;  ///< [0] is the root; breadth first; empty: nothing in view
  /// Moving pieces, each with the place in the static order where it belongs.
  struct MovingPiece {
    std::uint32_t item = 0;       ///< in the moving set
    std::uint32_t neighbour = 0;  ///< static item whose place it takes, or kNone: no static item
    bool before = false;          ///< in front of the neighbour, or behind it
    std::uint64_t order = 0;      ///< among pieces of one place, ascending from the front
    bool instead = false;         ///< the neighbour is a placeholder, which is not listed
  };
  std::vector<MovingPiece> moving;
  /// Of the choices that retrieval met, how many show their least detailed description, their
  /// second, and so on.
  std::vector<std::uint32_t> detail;
};

/// A group whose counts were not unique in a frame, and why. Objects by their numbers.
struct ListabilityFault {
  std::uint32_t group = 0;
  std::vector<std::uint32_t> members;  ///< in view, ascending
  /// A shortest ring of members, each of which precedes the next, and the last the first; empty:
  /// there is none.
  std::vector<std::uint32_t> circuit;
  std::vector<std::array<std::uint32_t, 2>> unresolved;  ///< pairs in view that no plane resolves
  friend bool operator==(const ListabilityFault&, const ListabilityFault&) = default;
};

/// priority_processor -> priority_resolver: items from the highest priority to the lowest. The
/// place of an item in the list is its priority; a face's follows from its place in the item.
struct PriorityList {
  std::vector<ItemRef> items;
  std::vector<ListabilityFault> faults;
};

/// A front face on the raster. Its edges cover the lines [first_line, end_line).
struct RasterFace {
  std::uint32_t object = 0;
  Colour colour;
  std::uint32_t first_edge = 0;
  std::uint32_t edge_count = 0;
  int first_line = 0, end_line = 0;
  float area = 0;  ///< elements that it covers, about
};

/// An edge in raster units. On line r in [first_line, end_line) it crosses column
/// x + slope (r - first_line), measured to the right from the first element's sample point, so that
/// the first element at or right of it is the smallest whole number not below that.
template <class N>
struct Edge {
  int first_line = 0, end_line = 0;
  bool left = false;  ///< a left edge of its face
  N x{}, slope{};
};

/// geometry_processor -> edge_orderer. Faces in the order of the list, and of each item's own.
template <class N>
struct EdgeList {
  std::vector<RasterFace> faces;
  std::vector<Edge<N>> edges;
};

/// edge_orderer -> priority_resolver: on one line, ascending by element.
struct Crossing {
  std::uint32_t face = 0;     ///< into EdgeList::faces
  std::uint16_t element = 0;  ///< first element at or right of the edge, 0..width
  bool left = false;
};

/// priority_resolver -> video_processor: elements [first, end) of one line show one face.
struct Span {
  std::uint32_t face = kNone;  ///< into EdgeList::faces; kNone: background
  std::uint16_t first = 0, end = 0;
};

/// video_processor -> display. Rows from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> colours;  ///< 0xAABBGGRR: bytes R, G, B, A in memory; A = 255
  std::vector<std::uint16_t> numbers;  ///< object numbers; 65535 stands for itself and above

  void fit(const Raster& raster) {
    width = raster.width;
    height = raster.height;
    colours.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    numbers.resize(colours.size());
  }
};

}  // namespace cigsim
