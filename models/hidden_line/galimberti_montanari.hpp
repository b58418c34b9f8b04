// SPDX-License-Identifier: MIT
// The hidden-line program of Pfister (after Galimberti and Montanari, CACM 12(4), 1969), as he
// published it: procedures SOLVE, HIDE and the transform of MAIN.
//
// It finds each face's inward normal (the sum of cross products over its corners, which run
// clockwise as seen from outside), each edge's two faces, and from these whether the edge is
// concave: (Ps - Pr) . (n1 x n2) > 0. For a picture it drops edges of two faces that are off view,
// and concave edges with one such face. What is left is drawn whole: right for one convex object;
// of a concave one, or of several, edges that other faces cover are drawn too.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/environment/cards.hpp"
#include "models/numeric/number.hpp"
#include "models/numeric/orientation2.hpp"

namespace cigsim::hidden_line {

/// An edge as his CSOLVE finds it: `ends` run as the first face does.
struct SolvedEdge {
  std::uint32_t ends[2] = {0, 0};  ///< vertices
  std::uint32_t faces[2] = {0, 0};
  bool concave = false;
};

struct SolvedStructure {
  std::vector<ExactVec> normals;  ///< inward, a face each; not of unit length
  std::vector<SolvedEdge> edges;
  bool concave() const;
};

/// Throws InputError (`name` and the line of a face) unless each edge has exactly two faces, and
/// they pass it in opposite directions: his list would hold an address of nothing, or the wrong
/// one. Signs are decided exactly, where his are of rounded unit normals.
SolvedStructure solve(const CardsStructure& structure, const std::string& name);

/// A line on his view plane: x right, y up; the screen shows -1 to 1.
struct DrawnEdge {
  std::uint32_t edge = 0;
  Vec2 from, to;
};

struct HiddenEdges {
  std::vector<DrawnEdge> drawn;
  std::uint32_t off_view_faces = 0;
  std::uint32_t dropped = 0;          ///< both faces off view
  std::uint32_t dropped_concave = 0;  ///< concave, with one face off view
  std::uint32_t behind_eye = 0;       ///< left out; his program divides by zero or mirrors them
};

/// On view: seen from outside; edge on counts as off view, as in his program.
HiddenEdges hide(const CardsStructure& structure, const SolvedStructure& solved,
                 const CardsView& view);

/// A point on his view plane; false when it is not in front of the eye.
bool transpose(const CardsView& view, const Vec3& point, Vec2& out);

/// The function keys of MAIN, 2 to 14: they set the increments. False for other keys. In his
/// program the distances do not keep their increments (RMAG = R + DR): a key moves them once, and
/// the key that stops them moves them back. `as_published` does the same; otherwise the distances
/// go on from picture to picture as the angles do, and stay where they are stopped.
bool press(int key, CardsView& view, bool as_published);

/// The step to the next picture (VEWCYC). Distances stay above 0 unless `as_published`.
void step(CardsView& view, bool as_published);

}  // namespace cigsim::hidden_line
