// SPDX-License-Identifier: MIT
#include "sim/hidden_line_picture.hpp"

#include <algorithm>
#include <cmath>

#include "sim/drawing/svg.hpp"

namespace cigsim {
namespace {

constexpr double kShortest = 1e-3;

struct ClippedRange {
  double low = 0, high = 1;
  // Keeps where a value that is linear between the ends is not negative.
  void keep(double at_a, double at_b) {
    if (at_a < 0 && at_b < 0) high = -1;
    if (at_a < 0 && at_b >= 0) low = std::max(low, at_a / (at_a - at_b));
    if (at_a >= 0 && at_b < 0) high = std::min(high, at_a / (at_a - at_b));
  }
};

}  // namespace

bool project_line(const ViewTransform& view, const Vec3& a, const Vec3& b, Vec2& from, Vec2& to) {
  const double width = view.raster.width / 2.0, height = view.raster.height / 2.0, f = view.focal;
  const Vec3 p = view.rotation * (a - view.eye), q = view.rotation * (b - view.eye);
  ClippedRange range;
  range.keep(p.x, q.x);
  range.keep(width * p.x + f * p.y, width * q.x + f * q.y);
  range.keep(width * p.x - f * p.y, width * q.x - f * q.y);
  range.keep(height * p.x + f * p.z, height * q.x + f * q.z);
  range.keep(height * p.x - f * p.z, height * q.x - f * q.z);
  if (!(range.low < range.high)) return false;
  const auto place = [&](double t, Vec2& out) {
    const Vec3 at = t == 1 ? q : p + (q - p) * t;
    if (!(at.x > 0)) return false;
    out = {std::clamp(width + f * at.y / at.x, 0.0, 2 * width),
           std::clamp(height - f * at.z / at.x, 0.0, 2 * height)};
    return true;
  };
  return place(range.low, from) && place(range.high, to);
}

std::vector<PictureLine> picture_lines(const hidden_line::HiddenLines& lines,
                                       const ViewTransform& view) {
  std::vector<PictureLine> out;
  for (const hidden_line::Piece& piece : lines.pieces()) {
    const hidden_line::Part& part = lines.parts()[piece.part];
    const hidden_line::PartEdge& edge = part.edges[piece.edge];
    const Vec3 &a = part.vertices[edge.a], d = part.vertices[edge.b] - a;
    const auto at = [&](double t) { return t == 1 ? part.vertices[edge.b] : a + d * t; };
    PictureLine line{{}, {}, piece.visible};
    if (project_line(view, at(piece.from), at(piece.to), line.from, line.to) &&
        std::hypot(line.to.x - line.from.x, line.to.y - line.from.y) > kShortest)
      out.push_back(line);
  }
  return out;
}

std::string lines_svg(const std::vector<PictureLine>& lines, const Raster& raster,
                      std::string_view title) {
  SvgDrawing drawing(raster.width, raster.height, title);
  const double width = std::max(1.0, raster.height / 600.0);
  const SvgStyle hidden{"#9a9a9a", width / 2, "4 4", "none"}, visible{"#1b1b1b", width, {}, "none"};
  for (const bool now : {false, true})
    for (const PictureLine& line : lines)
      if (line.visible == now) drawing.line(line.from, line.to, now ? visible : hidden);
  return drawing.svg();
}

}  // namespace cigsim
