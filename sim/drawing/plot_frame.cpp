// SPDX-License-Identifier: MIT
#include "sim/drawing/plot_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace cigsim {
namespace {

// Pixels.
constexpr double kLeft = 78, kRight = 30, kTitle = 34, kNoteLine = 15, kAxis = 50, kKeyLine = 16;
constexpr double kRowMargin = 24, kRowLetters = 10, kNoteLetters = 10;
// As gnuplot lays out a key: its mark and room, and a letter.
constexpr double kKeySample = 36, kKeyLetter = 7;

std::size_t longest(const std::vector<std::string>& words) {
  std::size_t most = 0;
  for (const std::string& word : words) most = std::max(most, word.size());
  return most;
}

// As few lines as fit.
std::vector<std::string> lines_of(const std::vector<std::string>& notes, double width) {
  std::vector<std::string> lines;
  for (const std::string& note : notes) {
    const std::string longer = lines.empty() ? note : lines.back() + ";  " + note;
    if (!lines.empty() && words_width(longer, kNoteLetters) <= width)
      lines.back() = longer;
    else
      lines.push_back(note);
  }
  return lines;
}

bool any_names(const Plot& plot) {
  return std::any_of(plot.curves.begin(), plot.curves.end(),
                     [](const Curve& curve) { return !curve.names.empty(); });
}

// Marks do not stand on the frame; lines may end there.
bool has_marks(const Plot& plot) {
  return std::any_of(plot.curves.begin(), plot.curves.end(), [](const Curve& curve) {
    return curve.style == CurveStyle::kMarks || curve.style == CurveStyle::kFront;
  });
}

template <class Coordinate>
std::optional<AxisRange> range_over(const Plot& plot, bool log, Coordinate coordinate) {
  if (!log && !any_names(plot)) return {};
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Curve& curve : plot.curves)
    for (const Vec2& point : curve.points) {
      if (!drawable(plot, point)) continue;
      low = std::min(low, coordinate(point));
      high = std::max(high, coordinate(point));
    }
  if (!log) {
    const double room = high > low ? 0.08 * (high - low) : std::max(1.0, std::abs(low));
    return AxisRange{low - room, high + room, false};
  }
  const double least = std::log10(low), most = std::log10(high);
  const double room = has_marks(plot) ? 0.02 * std::max(1.0, most - least) : -1e-9;
  // What doubles hold is not left.
  const double from = std::clamp(std::floor(least - room), -307.0, 307.0);
  const double to = std::clamp(std::ceil(most + room), from + 1, 308.0);
  return AxisRange{std::pow(10, from), std::pow(10, to), true};
}

}  // namespace

double words_width(std::string_view words, double size) {
  constexpr double kLetter = 0.56;
  const auto letters = std::count_if(words.begin(), words.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;  // no continuation of UTF-8
  });
  return kLetter * size * static_cast<double>(letters);
}

double AxisRange::share(double value) const {
  if (log) return (std::log10(value) - std::log10(low)) / (std::log10(high) - std::log10(low));
  return (value - low) / (high - low);
}

bool drawable(const Plot& plot, const Vec2& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && (!plot.log_x || point.x > 0) &&
         (!plot.log_y || point.y > 0);
}

PlotFrame plot_frame(const Plot& plot, const PlotSize& size) {
  PlotFrame frame;
  PixelBox& box = frame.box;
  box.left = kLeft;
  if (!plot.rows.empty())
    for (const std::string& row : plot.rows)
      box.left = std::max(box.left, kRowMargin + words_width(row, kRowLetters));
  box.left = std::min(box.left, size.width / 2.0);
  box.right = size.width - kRight;
  frame.notes = lines_of(plot.notes, size.width - kRight);
  std::vector<std::string> labels;
  for (const Curve& curve : plot.curves)
    if (!curve.label.empty()) labels.push_back(curve.label);
  const double label = kKeySample + kKeyLetter * static_cast<double>(longest(labels));
  const int count = std::max(1, static_cast<int>(labels.size()));
  frame.key_columns = std::clamp(static_cast<int>((box.right - box.left) / label), 1, count);
  const int key_rows = labels.empty() ? 0 : (count + frame.key_columns - 1) / frame.key_columns;
  box.top = kTitle + kNoteLine * static_cast<double>(frame.notes.size());
  box.bottom = size.height - kAxis - kKeyLine * (key_rows > 0 ? key_rows + 0.5 : 0);
  // A frame is left, however much is around it.
  box.bottom = std::max(box.bottom, size.height / 3.0);
  box.top = std::min(box.top, box.bottom - size.height / 6.0);
  return frame;
}

std::vector<PlotFrame> plot_frames(const std::vector<Plot>& plots, std::size_t columns,
                                   const PlotSize& size) {
  std::vector<PlotFrame> frames;
  for (const Plot& plot : plots) frames.push_back(plot_frame(plot, size));
  for (std::size_t first = 0; first < frames.size(); first += columns) {
    const std::span row(frames.data() + first, std::min(columns, frames.size() - first));
    double top = 0, bottom = size.height;
    for (const PlotFrame& frame : row) {
      top = std::max(top, frame.box.top);
      bottom = std::min(bottom, frame.box.bottom);
    }
    for (PlotFrame& frame : row) {
      frame.box.top = std::min(top, bottom - size.height / 6.0);
      frame.box.bottom = bottom;
    }
  }
  return frames;
}

std::optional<AxisRange> x_range(const Plot& plot) {
  return range_over(plot, plot.log_x, [](const Vec2& point) { return point.x; });
}

std::optional<AxisRange> y_range(const Plot& plot) {
  if (!plot.rows.empty())  // the first on top
    return AxisRange{static_cast<double>(plot.rows.size()) - 0.5, -0.5, false};
  return range_over(plot, plot.log_y, [](const Vec2& point) { return point.y; });
}

}  // namespace cigsim
