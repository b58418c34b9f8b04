// SPDX-License-Identifier: MIT
#include "sim/drawing/svg.hpp"

#include <fmt/format.h>

#include "sim/markup.hpp"

namespace cigsim {
namespace {

std::string attributes(const SvgStyle& style) {
  std::string out = fmt::format("stroke=\"{}\" stroke-width=\"{:.6g}\" fill=\"{}\"", style.stroke,
                                style.width, style.fill);
  if (!style.dash.empty()) out += fmt::format(" stroke-dasharray=\"{}\"", style.dash);
  return out;
}

const char* name_of(SvgAnchor anchor) { return anchor == SvgAnchor::kMiddle ? "middle" : "start"; }

}  // namespace

SvgDrawing::SvgDrawing(double width, double height, std::string_view title)
    : text_(fmt::format(
          "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.6g} {1:.6g}\" "
          "width=\"{0:.6g}\" height=\"{1:.6g}\" font-family=\"Helvetica, Arial, sans-serif\" "
          "stroke-linecap=\"round\" role=\"img\">\n<title>{2}</title>\n"
          "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
          width, height, markup_escaped(title))) {}

void SvgDrawing::line(const Vec2& from, const Vec2& to, const SvgStyle& style) {
  text_ += fmt::format("<line x1=\"{:.6g}\" y1=\"{:.6g}\" x2=\"{:.6g}\" y2=\"{:.6g}\" {}/>\n",
                       from.x, from.y, to.x, to.y, attributes(style));
}

void SvgDrawing::polygon(std::span<const Vec2> corners, const SvgStyle& style) {
  text_ += "<polygon points=\"";
  for (const Vec2& corner : corners) text_ += fmt::format("{:.6g},{:.6g} ", corner.x, corner.y);
  text_ += fmt::format("\" {}/>\n", attributes(style));
}

void SvgDrawing::circle(const Vec2& centre, double radius, const SvgStyle& style) {
  text_ += fmt::format("<circle cx=\"{:.6g}\" cy=\"{:.6g}\" r=\"{:.6g}\" {}/>\n", centre.x,
                       centre.y, radius, attributes(style));
}

void SvgDrawing::text(const Vec2& at, std::string_view words, double size, SvgAnchor anchor,
                      std::string_view fill) {
  text_ += fmt::format(
      "<text x=\"{:.6g}\" y=\"{:.6g}\" font-size=\"{:.6g}\" text-anchor=\"{}\" fill=\"{}\">{}"
      "</text>\n",
      at.x, at.y, size, name_of(anchor), fill, markup_escaped(words));
}

}  // namespace cigsim
