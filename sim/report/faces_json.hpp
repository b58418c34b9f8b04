// SPDX-License-Identifier: MIT
// A frame's faces as data of the page, from which it works out what pierces an element.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sim/report/shown_faces.hpp"

namespace cigsim {

/// "#rrggbb"
std::string colour_words(const Colour& colour);

/// A list of faces from the highest priority down, each [object, "#rrggbb", [edge, …]]; an edge is
/// [first line, end line, left ? 1 : 0, x, slope], and on line r its element is
/// ceil(x + slope (r - first line)) in doubles, clamped to 0..width. Where rounding makes the
/// machine's element another one, a sixth entry lists those: [line, element, line, element, …].
nlohmann::ordered_json faces_json(const FrameFaces& faces, int width);

/// Lines with a limit: [line, first face that is not there or null, first element that shows the
/// background or null].
nlohmann::ordered_json limits_json(const std::vector<LineLimit>& limits);

}  // namespace cigsim
