// SPDX-License-Identifier: MIT
// A line drawing as SVG: a white sheet with lines, polygons, circles and words.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "models/numeric/orientation2.hpp"

namespace cigsim {

/// Colours are those of SVG ("#2f6fab", "none"). A dash is a list of lengths ("4 3"), or empty.
struct SvgStyle {
  std::string_view stroke = "#1b1b1b";
  double width = 1;
  std::string_view dash = {};
  std::string_view fill = "none";
};

enum class SvgAnchor { kStart, kMiddle };

class SvgDrawing {
 public:
  /// A sheet in pixels, x to the right, y down. `title` says what it shows, to readers of screens.
  SvgDrawing(double width, double height, std::string_view title);

  void line(const Vec2& from, const Vec2& to, const SvgStyle& style = {});
  void polygon(std::span<const Vec2> corners, const SvgStyle& style);
  void circle(const Vec2& centre, double radius, const SvgStyle& style);
  /// `at` is the left end or the middle of the words' base line; `size` the height of letters.
  void text(const Vec2& at, std::string_view words, double size = 12,
            SvgAnchor anchor = SvgAnchor::kStart, std::string_view fill = "#1b1b1b");

  /// The whole file.
  std::string svg() const { return text_ + "</svg>\n"; }

 private:
  std::string text_;
};

}  // namespace cigsim
