// SPDX-License-Identifier: MIT
#include "sim/drawing/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/drawing/gnuplot.hpp"
#include "sim/drawing/plot_frame.hpp"

namespace cigsim {
namespace {

constexpr double kNameLetters = 10;
constexpr const char* kFrontColour = "#b2182b";

// Told apart on white, and by most who see colours differently.
const std::string& colour_of(std::size_t number) {
  static const std::array<std::string, 8> colours{"#2f6fab", "#d1762b", "#3c8f5c", "#8b5ea8",
                                                  "#b2182b", "#1395a5", "#7a6a4f", "#5c5c5c"};
  return colours[number % colours.size()];
}

// gnuplot's number of it, and a size at which all look equally large.
std::string words_of(Mark mark, double size) {
  struct Point {
    int number;
    double size;
  };
  const auto point = [mark]() -> Point {
    switch (mark) {
      case Mark::kSquare:
        return {5, 0.9};
      case Mark::kTriangle:
        return {9, 1.1};
      case Mark::kPointedDown:
        return {11, 1.1};
      case Mark::kDiamond:
        return {13, 1.2};
      case Mark::kPentagon:
        return {15, 1};
      case Mark::kCross:
        return {2, 1};
      default:
        return {7, 1};
    }
  }();
  return fmt::format("pt {} ps {:.2g}", point.number, size * point.size);
}

std::string style_of(const Curve& curve, const std::string& colour) {
  const std::string paint = fmt::format("lc rgb '{}'", colour);
  switch (curve.style) {
    case CurveStyle::kLine:
      return "lines lw 1.5 " + paint;
    case CurveStyle::kBound:
      return "lines lw 1.2 dt (6,4) " + paint;
    case CurveStyle::kMarks:
      return fmt::format("points {} {}", words_of(curve.mark, 0.7), paint);
    case CurveStyle::kBars:
      return "boxes fs solid 0.6 noborder " + paint;
    case CurveStyle::kFront:
      return "points pt 6 ps 1.2 lw 1.5 " + paint;
    default:
      return fmt::format("linespoints lw 1.5 {} {}", words_of(curve.mark, 0.5), paint);
  }
}

// The commands of one plot, in the cell of a sheet.
class PlotWords {
 public:
  PlotWords(const Plot& plot, const PlotFrame& frame, PlotSize sheet, Vec2 corner, int& next_block,
            std::string& blocks)
      : plot_(plot),
        sheet_(sheet),
        corner_(corner),
        frame_(frame),
        next_block_(next_block),
        blocks_(blocks) {
    for (const Curve& curve : plot.curves)
      for (const Vec2& point : curve.points)
        if (drawable(plot, point)) marks_.push_back(point);
  }

  std::string words() {
    std::string out = around();
    if (marks_.empty())
      return out +
             "set label 999 'nothing to draw' at graph 0.5, graph 0.5 center\n"
             "unset key\nset xrange [0:1]\nset yrange [0:1]\nplot NaN notitle\n";
    const std::optional<AxisRange> x = x_range(plot_), y = y_range(plot_);
    out += axis("x", x) + axis("y", y) + row_names();
    if (x && y) out += names(*x, *y);
    return out + "plot " + curves() + "\n";
  }

 private:
  // A place in the cell as gnuplot's of the sheet.
  std::string screen(double x, double y) const {
    return fmt::format("screen {:.6f}, screen {:.6f}", (corner_.x + x) / sheet_.width,
                       1 - (corner_.y + y) / sheet_.height);
  }

  // All but the axes and what is drawn.
  std::string around() const {
    const PixelBox& box = frame_.box;
    std::string out = "reset\n";
    const auto margin = [&out](const char* side, double at) {
      out += fmt::format("set {}margin at screen {:.6f}\n", side, at);
    };
    margin("l", (corner_.x + box.left) / sheet_.width);
    margin("r", (corner_.x + box.right) / sheet_.width);
    margin("t", 1 - (corner_.y + box.top) / sheet_.height);
    margin("b", 1 - (corner_.y + box.bottom) / sheet_.height);
    out +=
        "set border 3 lc rgb '#6e6e6e'\nset tics out nomirror font ',10' textcolor rgb '#333333'\n"
        "set grid lc rgb '#dcdcdc' dt solid\n";
    out += fmt::format(
        "set key at {} center top horizontal Left reverse maxcols {} noenhanced samplen 2 font "
        "',10'\n",
        screen((box.left + box.right) / 2, box.bottom + 50), frame_.key_columns);
    constexpr double kTitleBase = 16, kNoteLine = 15;
    out += fmt::format("set label 1 {} at {} left noenhanced font ',13'\n",
                       gnuplot_quoted(plot_.title), screen(12, kTitleBase));
    for (std::size_t i = 0; i < frame_.notes.size(); ++i)
      out +=
          fmt::format("set label {} {} at {} left noenhanced font ',10' textcolor rgb '#5c5c5c'\n",
                      i + 2, gnuplot_quoted(frame_.notes[i]),
                      screen(12, kTitleBase + kNoteLine * static_cast<double>(i + 1)));
    out += fmt::format("set label 998 {} at {} center noenhanced font ',11'\n",
                       gnuplot_quoted(plot_.x_label),
                       screen((box.left + box.right) / 2, box.bottom + 36));
    out += fmt::format("set label 997 {} at {} center rotate by 90 noenhanced font ',11'\n",
                       gnuplot_quoted(plot_.y_label), screen(18, (box.top + box.bottom) / 2));
    return out;
  }

  static std::string axis(const char* name, const std::optional<AxisRange>& range) {
    if (!range) return fmt::format("set {}range [*:*]\n", name);
    std::string out = fmt::format("set {}range [{:.17g}:{:.17g}]\n", name, range->low, range->high);
    if (!range->log) return out;
    constexpr double kLeastPlain = 1e-4, kMostPlain = 1e5;
    const bool plain = range->low >= 0.99 * kLeastPlain && range->high <= 1.01 * kMostPlain;
    out +=
        fmt::format("set logscale {}\nset format {} '{}'\n", name, name, plain ? "%g" : "10^{%L}");
    return out;
  }

  std::string row_names() const {
    if (plot_.rows.empty()) return {};
    std::string out = "set ytics noenhanced (";
    for (std::size_t i = 0; i < plot_.rows.size(); ++i)
      out += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_quoted(plot_.rows[i]), i);
    return out + ")\n";
  }

  // Where a point stands in the cell.
  Vec2 place(const Vec2& point, const AxisRange& x, const AxisRange& y) const {
    const PixelBox& box = frame_.box;
    return {box.left + x.share(point.x) * (box.right - box.left),
            box.bottom - y.share(point.y) * (box.bottom - box.top)};
  }

  // Places along the steps of a front, which names shall not cover either.
  void add_steps(const Curve& curve, const AxisRange& x, const AxisRange& y,
                 std::vector<Vec2>& marks) const {
    constexpr double kStep = 6;
    const auto line = [&marks](const Vec2& from, const Vec2& to) {
      const double length = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
      for (double at = kStep; at < length; at += kStep)
        marks.push_back(
            {from.x + at / length * (to.x - from.x), from.y + at / length * (to.y - from.y)});
    };
    std::optional<Vec2> last;
    for (const Vec2& point : curve.points) {
      if (!drawable(plot_, point)) continue;
      const Vec2 at = place(point, x, y);
      if (last) {
        line(*last, {at.x, last->y});
        line({at.x, last->y}, at);
      }
      last = at;
    }
  }

  // The names of points, and lines to them where they are not beside.
  std::string names(const AxisRange& x, const AxisRange& y) const {
    std::vector<Vec2> marks;
    for (const Vec2& mark : marks_) marks.push_back(place(mark, x, y));
    for (const Curve& curve : plot_.curves)
      if (curve.style == CurveStyle::kFront) add_steps(curve, x, y, marks);
    std::vector<NamedMark> named;
    std::vector<std::string> words;
    for (const Curve& curve : plot_.curves)
      for (std::size_t i = 0; i < std::min(curve.points.size(), curve.names.size()); ++i) {
        if (!drawable(plot_, curve.points[i])) continue;
        named.push_back({place(curve.points[i], x, y), words_width(curve.names[i], kNameLetters),
                         kNameLetters + 2, !plot_.rows.empty()});
        words.push_back(curve.names[i]);
      }
    std::string out;
    const std::vector<std::optional<NamePlace>> places = place_names(named, marks, frame_.box);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!places[i]) continue;
      const PixelBox& box = places[i]->box;
      out += fmt::format("set label {} {} at {} left front noenhanced font ',{}'\n", 1000 + i,
                         gnuplot_quoted(words[i]), screen(box.left, (box.top + box.bottom) / 2),
                         kNameLetters);
      if (const std::optional<Vec2>& end = places[i]->leader)
        out += fmt::format("set arrow {} from {} to {} nohead lw 0.7 lc rgb '#8c8c8c'\n", i + 1,
                           screen(named[i].at.x, named[i].at.y), screen(end->x, end->y));
    }
    return out;
  }

  std::string curves() {
    std::string out, colour = colour_of(0);
    std::size_t own = 0;
    for (const Curve& curve : plot_.curves) {
      if (!curve.colour.empty())
        colour = curve.colour;
      else if (curve.style == CurveStyle::kFront)
        colour = kFrontColour;
      else if (curve.style != CurveStyle::kBound)
        colour = colour_of(own++);
      const std::string words = curve_words(curve, colour);
      if (words.empty()) continue;
      out += (out.empty() ? "" : ", ") + words;
    }
    return out;
  }

  // The points as a named block of data, and the words that plot it; empty where nothing can be
  // drawn.
  std::string curve_words(const Curve& curve, const std::string& colour) {
    std::string data;
    for (const Vec2& point : curve.points)
      if (drawable(plot_, point)) data += fmt::format("{:.17g} {:.17g}\n", point.x, point.y);
    if (data.empty()) return {};
    const int block = next_block_++;
    blocks_ += fmt::format("$d{} << EOD\n{}EOD\n", block, data);
    std::string out =
        fmt::format("$d{} using 1:2 with {} {}", block, style_of(curve, colour),
                    curve.label.empty() ? "notitle" : "title " + gnuplot_quoted(curve.label));
    if (curve.style == CurveStyle::kFront)
      out += fmt::format(", $d{} using 1:2 with steps lw 1 lc rgb '{}' notitle", block, colour);
    return out;
  }

  const Plot& plot_;
  const PlotSize sheet_;
  const Vec2 corner_;
  const PlotFrame& frame_;
  std::vector<Vec2> marks_;  // all that can be drawn
  int& next_block_;
  std::string& blocks_;
};

}  // namespace

std::string plot_script(const std::vector<Plot>& plots, int columns, PlotSize size) {
  const int count = static_cast<int>(plots.size());
  const PlotSize sheet{columns * size.width, (count + columns - 1) / columns * size.height};
  const std::vector<PlotFrame> frames = plot_frames(plots, static_cast<std::size_t>(columns), size);
  std::string blocks, commands;
  int next_block = 0;
  for (int i = 0; i < count; ++i) {
    const Vec2 corner{static_cast<double>(i % columns * size.width),
                      static_cast<double>(i / columns * size.height)};
    const auto index = static_cast<std::size_t>(i);
    commands += PlotWords(plots[index], frames[index], sheet, corner, next_block, blocks).words();
  }
  return blocks + gnuplot_sheet(plots.size(), columns, size.width, size.height) + commands +
         "unset multiplot\n";
}

}  // namespace cigsim
