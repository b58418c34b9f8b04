// SPDX-License-Identifier: MIT
// A face, or what a division left of it, in the list of Newell's algorithm.
#pragma once

#include <optional>
#include <vector>

#include "models/survey/visible_surface/algorithm.hpp"
#include "models/survey/visible_surface/depth_order.hpp"

namespace cigsim::survey {

struct Piece {
  std::uint32_t face = 0, plane = 0, rank = 0;
  std::vector<RasterPlace> corners;
  int first_line = 0, first_element = 0, end_element = 0;
  std::vector<Row> rows;     ///< from first_line
  double far = 0, near = 0;  ///< bounds of its depth; larger is nearer
  bool moved = false;        ///< to the front of the list, out of the order of depth

  int end_line() const { return first_line + static_cast<int>(rows.size()); }
};

/// A whole face as a piece.
Piece piece_of(const FaceList& list, std::uint32_t face);

/// The tests of Newell, Newell and Sancha 1972, counted.
class PieceTests {
 public:
  PieceTests(const FaceList& list, const DepthOrder& order, Work& work)
      : list_(list), order_(order), work_(work) {}

  /// True when `p` must not be written before `q` as far as the tests can tell: their depths, their
  /// extents and their elements overlap, and neither is `p` behind the plane of `q` nor `q` in
  /// front of the plane of `p`.
  bool blocks(const Piece& p, const Piece& q);

  /// `p` lies behind the plane of `q` throughout; of two in one plane, the later in the list.
  bool behind(const Piece& p, const Piece& q);
  /// `p` lies in front of the plane of `q` throughout.
  bool before(const Piece& p, const Piece& q);

  /// The plane with this number passes through the piece: corners lie strictly on both sides.
  bool divides(std::uint32_t plane, const Piece& piece);

 private:
  bool all_corners(const Piece& p, std::uint32_t plane, int side);
  bool share_an_element(const Piece& p, const Piece& q);

  const FaceList& list_;
  const DepthOrder& order_;
  Work& work_;
};

/// The parts of a piece behind and in front of a plane that divides it, without those that cover no
/// element.
std::vector<Piece> divide(const FaceList& list, const DepthOrder& order, const Piece& piece,
                          std::uint32_t plane);

}  // namespace cigsim::survey
