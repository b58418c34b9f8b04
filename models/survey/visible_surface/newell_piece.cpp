// SPDX-License-Identifier: MIT
#include "models/survey/visible_surface/newell_piece.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace cigsim::survey {
namespace {

void bound(const FaceList& list, Piece& piece) {
  piece.first_element = list.raster.width;
  piece.end_element = 0;
  for (const Row& row : piece.rows) {
    if (row.first == row.end) continue;
    piece.first_element = std::min<int>(piece.first_element, row.first);
    piece.end_element = std::max<int>(piece.end_element, row.end);
  }
  const RoundedPlane& plane = list.rounded[piece.plane];
  piece.far = std::numeric_limits<double>::infinity();
  piece.near = -piece.far;
  for (const RasterPlace& at : piece.corners) {
    const double depth = plane.a * at.x.get_d() + plane.b * at.y.get_d() + plane.c;
    piece.far = std::min(piece.far, depth - plane.slack);
    piece.near = std::max(piece.near, depth + plane.slack);
  }
}

// The corners on one side of a line, given how far each lies on that side.
std::vector<RasterPlace> part(const std::vector<RasterPlace>& corners,
                              const std::vector<Exact>& distance, int sign) {
  std::vector<RasterPlace> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t k = i + 1 < corners.size() ? i + 1 : 0;
    const int a = sgn(distance[i]) * sign, b = sgn(distance[k]) * sign;
    if (a >= 0) out.push_back(corners[i]);
    if (a * b >= 0) continue;
    const Exact t(distance[i] / (distance[i] - distance[k]));
    out.push_back({Exact(corners[i].x + (corners[k].x - corners[i].x) * t),
                   Exact(corners[i].y + (corners[k].y - corners[i].y) * t)});
  }
  return out;
}

// The elements of a row where plane `p` is in front of `q` (in_front) or behind it.
Row part_of_row(const DepthOrder& order, std::uint32_t p, std::uint32_t q, const Row& row, int line,
                bool in_front) {
  const auto wanted = [&](int x) { return (order.sign(p, q, x, line) > 0) == in_front; };
  if (row.first == row.end) return row;
  const bool first = wanted(row.first), last = wanted(row.end - 1);
  if (first && last) return row;
  if (!first && !last) return {row.first, row.first};
  int low = row.first, high = row.end - 1;  // the answers differ at these two
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (wanted(middle) == first ? low : high) = middle;
  }
  const auto at = static_cast<std::uint16_t>(high);
  return first ? Row{row.first, at} : Row{at, row.end};
}

}  // namespace

Piece piece_of(const FaceList& list, std::uint32_t index) {
  const SurveyFace& face = list.faces[index];
  Piece piece;
  piece.face = index;
  piece.plane = face.plane;
  piece.rank = face.rank;
  piece.corners.assign(list.places.begin() + face.first_place,
                       list.places.begin() + face.first_place + face.place_count);
  piece.first_line = face.first_line;
  piece.rows.assign(list.rows.begin() + face.first_row,
                    list.rows.begin() + face.first_row +
                        static_cast<std::ptrdiff_t>(face.end_line) - face.first_line);
  bound(list, piece);
  return piece;
}

bool PieceTests::blocks(const Piece& p, const Piece& q) {
  work_.comparisons += 3;
  if (p.near < q.far || p.face == q.face) return false;
  if (p.end_element <= q.first_element || q.end_element <= p.first_element) return false;
  if (p.end_line() <= q.first_line || q.end_line() <= p.first_line) return false;
  return !behind(p, q) && !before(q, p) && share_an_element(p, q);
}

bool PieceTests::behind(const Piece& p, const Piece& q) {
  return p.plane == q.plane ? p.face > q.face : all_corners(p, q.plane, -1);
}

bool PieceTests::before(const Piece& p, const Piece& q) {
  return p.plane == q.plane ? p.face < q.face : all_corners(p, q.plane, 1);
}

bool PieceTests::all_corners(const Piece& p, std::uint32_t plane, int side) {
  return std::all_of(p.corners.begin(), p.corners.end(), [&](const RasterPlace& at) {
    ++work_.depths;
    return order_.sign(p.plane, plane, at) * side >= 0;
  });
}

bool PieceTests::divides(std::uint32_t plane, const Piece& piece) {
  return piece.plane != plane && !all_corners(piece, plane, 1) && !all_corners(piece, plane, -1);
}

bool PieceTests::share_an_element(const Piece& p, const Piece& q) {
  const int first = std::max(p.first_line, q.first_line);
  const int end = std::min(p.end_line(), q.end_line());
  for (int r = first; r < end; ++r) {
    ++work_.comparisons;
    const Row &a = p.rows[static_cast<std::size_t>(r - p.first_line)],
              &b = q.rows[static_cast<std::size_t>(r - q.first_line)];
    if (std::max(a.first, b.first) < std::min(a.end, b.end)) return true;
  }
  return false;
}

std::vector<Piece> divide(const FaceList& list, const DepthOrder& order, const Piece& piece,
                          std::uint32_t plane) {
  const DepthPlane &p = list.planes[piece.plane], &q = list.planes[plane];
  const Exact a(p.a - q.a), b(p.b - q.b), c(p.c - q.c);
  std::vector<Exact> distance;
  for (const RasterPlace& at : piece.corners) distance.emplace_back(a * at.x + b * at.y + c);
  std::vector<Piece> parts;
  for (const bool in_front : {false, true}) {
    Piece made;
    made.face = piece.face;
    made.plane = piece.plane;
    made.rank = piece.rank;
    made.first_line = piece.first_line;
    made.corners = part(piece.corners, distance, in_front ? 1 : -1);
    for (std::size_t r = 0; r < piece.rows.size(); ++r)
      made.rows.push_back(part_of_row(order, piece.plane, plane, piece.rows[r],
                                      piece.first_line + static_cast<int>(r), in_front));
    bound(list, made);
    if (made.end_element > 0) parts.push_back(std::move(made));
  }
  return parts;
}

}  // namespace cigsim::survey
