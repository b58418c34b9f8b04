// SPDX-License-Identifier: MIT
#include "sim/report/faces_json.hpp"

#include <fmt/format.h>

#include <cmath>

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

// Short numbers for a small page. What this moves by an element is told apart, as is what has no
// number at all.
double shortened(double value, double scale) {
  constexpr double kLarge = 1e8;
  if (!std::isfinite(value)) return 0;
  return std::abs(value) < kLarge ? std::round(value * scale) / scale : value;
}

std::int32_t element_of(double at, int width) {
  const double up = std::ceil(at);
  return up > 0 ? static_cast<std::int32_t>(std::min(up, static_cast<double>(width))) : 0;
}

Json edge_json(const FrameFaces& faces, const FaceEdge& edge, int width) {
  const double x = shortened(edge.x, 1e6), slope = shortened(edge.slope, 1e9);
  Json out{edge.first_line, edge.end_line, edge.left ? 1 : 0, x, slope};
  Json others = Json::array();
  const auto elements = faces.elements_of(edge);
  for (std::size_t k = 0; k < elements.size(); ++k) {
    if (element_of(x + slope * static_cast<double>(k), width) == elements[k]) continue;
    others.push_back(edge.first_line + static_cast<int>(k));
    others.push_back(elements[k]);
  }
  if (!others.empty()) out.push_back(std::move(others));
  return out;
}

}  // namespace

std::string colour_words(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
}

Json faces_json(const FrameFaces& faces, int width) {
  Json out = Json::array();
  for (std::size_t f = 0; f < faces.faces.size(); ++f) {
    const RasterFace& face = faces.faces[f];
    Json edges = Json::array();
    for (const FaceEdge& edge : faces.edges_of(f)) edges.push_back(edge_json(faces, edge, width));
    out.push_back({face.object, colour_words(face.colour), std::move(edges)});
  }
  return out;
}

Json limits_json(const std::vector<LineLimit>& limits) {
  const auto number = [](std::uint32_t value) { return value == kNone ? Json() : Json(value); };
  Json out = Json::array();
  for (std::size_t r = 0; r < limits.size(); ++r)
    if (limits[r].faces != kNone || limits[r].elements != kNone)
      out.push_back({r, number(limits[r].faces), number(limits[r].elements)});
  return out;
}

}  // namespace cigsim
