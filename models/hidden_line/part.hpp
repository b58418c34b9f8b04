// SPDX-License-Identifier: MIT
// What the hidden-line algorithm calls an object (Levine 1975, ch. VI.A): a convex solid, a plane
// figure that may be concave, or a wire frame, which hides nothing.
//
// Reconstruction: the source says that other bodies can be built of these. Here a body that is not
// convex becomes a figure a face. Its faces know their neighbours, so that nothing is seen through
// the seam between two of them, and edges that only the division made are not drawn.
#pragma once

#include <cstdint>
#include <vector>

#include "models/database/polygon.hpp"
#include "models/environment/environment.hpp"
#include "models/numeric/plane.hpp"

namespace cigsim::hidden_line {

inline constexpr std::uint32_t kNoFace = 0xffffffffu, kNoSeam = 0xffffffffu;

enum class PartKind : std::uint8_t { kSolid, kFigure, kWire };

/// When an edge is drawn that is not a back edge.
enum class Drawn : std::uint8_t {
  kAlways,
  kWhenExtreme,  ///< it divides a face of the input: only the outline may show it
  kNever,
};

struct PartEdge {
  std::uint32_t a = 0, b = 0;  ///< vertices of the part
  std::uint32_t face[2] = {kNoFace, kNoFace};
  Drawn drawn = Drawn::kAlways;
  std::uint32_t number = 0;  ///< the edge of the object, from 0; figures of a body share some
  std::uint32_t seam =
      kNoSeam;  ///< of a figure: the seam (PartSet::seams) that the edge is part of
};

struct PartFace {
  Loop loop;  ///< anticlockwise as seen from the plane's positive side
  Plane plane;
  /// loop[i] to loop[i + 1] is this edge of the part.
  std::vector<std::uint32_t> edges;
};

/// Solids have all their faces, figures one, wire frames none.
struct Part {
  PartKind kind = PartKind::kSolid;
  std::uint32_t object = 0;  ///< number, from 1
  bool two_sided = false;    ///< a figure that is seen from its back too
  bool marking = false;      ///< lies on the ground: drawn, hides nothing
  std::vector<Vec3> vertices;
  std::vector<PartFace> faces;
  std::vector<PartEdge> edges;
  /// Of a concave figure: convex loops that together are its face; empty: the face is convex.
  std::vector<Loop> cells;
};

/// Where figures of one body meet along an edge.
struct SeamSide {
  std::uint32_t part = 0, edge = 0;
};

struct PartSet {
  std::vector<Part> parts;
  std::vector<std::vector<SeamSide>> seams;
};

/// A convex solid of an object with convex planar faces, anticlockwise as seen from outside. The
/// caller vouches for its shape.
Part solid_part(const Object& object, std::uint32_t number);

/// A plane figure with one simple loop, seen from both sides. Throws std::invalid_argument when the
/// loop has no area or does not lie in one plane exactly, or crosses itself.
Part figure_part(const std::vector<Vec3>& loop, std::uint32_t number);

/// The edges of an object's faces, each once.
Part wire_part(const Object& object, std::uint32_t number);

/// Adds edges (`edges` of the faces, `face` of the edges) to a part with vertices and faces.
void connect_edges(Part& part);

}  // namespace cigsim::hidden_line
