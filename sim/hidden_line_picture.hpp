// SPDX-License-Identifier: MIT
// Visible pieces of edges as lines on the raster, and as an SVG.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "models/hidden_line/hidden_lines.hpp"
#include "models/numeric/orientation2.hpp"

namespace cigsim {

/// A line on the raster, in elements from the top left; within the raster.
struct PictureLine {
  Vec2 from, to;
  bool visible = true;
};

/// The part of a line in space that is in view, projected; false when there is none.
bool project_line(const ViewTransform& view, const Vec3& a, const Vec3& b, Vec2& from, Vec2& to);

/// What of the pieces is in view. Lines that are no longer than 1/1000 element are left out.
std::vector<PictureLine> picture_lines(const hidden_line::HiddenLines& lines,
                                       const ViewTransform& view);

/// Hidden lines dashed and beneath the visible ones.
std::string lines_svg(const std::vector<PictureLine>& lines, const Raster& raster,
                      std::string_view title);

}  // namespace cigsim
