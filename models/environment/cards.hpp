// SPDX-License-Identifier: MIT
// A deck of Pfister's program (Pfister, "A PL1 Computer Program for Hidden Line Elimination",
// appendix, procedure MAIN): a quoted instruction, then its data, as a stream without regard to the
// ends of cards.
//
//   'BEGIN STRUCTURE DATA'                               a new structure; the one before goes
//   'VERTEX' X=0, Y=0, Z=0, NEDGES=3, TAG=1; 2 4 5       NEDGES numbers follow; nobody uses them
//   'FACE' LABEL=1, NVERT=4; 1 2 3 4                     tags, clockwise as seen from outside
//   'END STRUCTURE DATA'                                 finds edges, convex and concave
//   'VIEW DATA' R=10, D=2, THETA=30, PHI=20, DR=0, DD=0, DTHETA=0, DPHI=0;
//   'PLOT' DELAY=1;                                      draws
//   'STOP'
//
// PL/I rules: items are parted by blanks, ends of lines or one comma; a quote within quotes stands
// twice; NAME=value data are in any order and end with a semicolon, and what is not named keeps its
// value. An instruction is known by a word within it, the first of VIEW DATA, VERTEX, FACE, PLOT,
// BEGIN STRUCTURE DATA, END STRUCTURE DATA, STOP; only its first 30 characters count. What no word
// is in is reported and skipped. That its data, up to the next quote, go with it is ours.
//
// Axes: x right, y up, z towards the viewer who has THETA = PHI = 0. In the environment these are
// x east, z up and y south.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/environment/environment.hpp"
#include "models/environment/read.hpp"

namespace cigsim {

/// Distance of the eye from the origin, of the view plane from the eye, angles in degrees, and what
/// is added to each for the next picture.
struct CardsView {
  double r = 0, d = 0, theta = 0, phi = 0;
  double dr = 0, dd = 0, dtheta = 0, dphi = 0;
};

struct CardsVertex {
  int tag = 0;
  Vec3 position;  ///< in his axes
  int line = 0;
};

struct CardsFace {
  int label = 0;
  std::vector<std::uint32_t> vertices;  ///< places in the structure's list
  int line = 0;
};

struct CardsStructure {
  std::vector<CardsVertex> vertices;
  std::vector<CardsFace> faces;
};

/// A picture that the deck asks for.
struct CardsPlot {
  std::uint32_t structure = 0;  ///< into CardsDeck::structures
  CardsView view;
  double delay = 0;
  int line = 0;
};

struct CardsDeck {
  std::vector<CardsStructure> structures;  ///< those that were ended
  std::vector<CardsPlot> plots;
  std::optional<CardsView> view;  ///< the last
  /// Instructions that were skipped, with their lines, in the source's manner.
  std::vector<std::string> reports;
  std::vector<Notice> notices;
};

/// Throws InputError with the line. The published limits (100 vertices, 16 corners a face) do not
/// apply.
CardsDeck parse_cards(std::string_view text, const std::string& name);
CardsDeck read_cards_deck(const std::filesystem::path& file);

/// His axes to the environment's.
inline Vec3 from_cards_axes(const Vec3& p) { return {p.x, 0 - p.z, p.y}; }

/// The view as the environment has it; the picture is 2 units high on his view plane.
DefaultView cards_view(const CardsView& view);

}  // namespace cigsim
