// SPDX-License-Identifier: MIT
#include "sim/drawing/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cigsim {
namespace {

bool drawable(const Plot& plot, const Vec2& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && (!plot.log_x || point.x > 0) &&
         (!plot.log_y || point.y > 0);
}

const char* style_of(CurveStyle style) {
  switch (style) {
    case CurveStyle::kLine:
      return "lines lw 1.5";
    case CurveStyle::kMarks:
      return "points pt 7 ps 0.6";
    case CurveStyle::kBars:
      return "boxes fs solid 0.6 noborder";
    case CurveStyle::kFront:
      return "points pt 6 ps 1.2 lw 1.5 lc rgb '#b2182b'";
    default:
      return "linespoints lw 1.5 pt 7 ps 0.4";
  }
}

// A name as a field of a block of data.
std::string name_field(const std::string& name) {
  std::string out = "\"";
  for (const char c : name)
    if (static_cast<unsigned char>(c) >= 0x20 && c != '"' && c != '\\') out += c;
  return out + "\"";
}

// The points as a named block of data, and the words that plot it; empty where nothing can be
// drawn.
std::string curve_words(const Plot& plot, const Curve& curve, int& next_block,
                        std::string& blocks) {
  std::string data;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Vec2& point = curve.points[i];
    if (!drawable(plot, point)) continue;
    data += fmt::format("{:.17g} {:.17g}", point.x, point.y);
    if (i < curve.names.size()) data += fmt::format(" {}", name_field(curve.names[i]));
    data += '\n';
  }
  if (data.empty()) return {};
  const int block = next_block++;
  blocks += fmt::format("$d{} << EOD\n{}EOD\n", block, data);
  std::string out =
      fmt::format("$d{} using 1:2 with {} {}", block, style_of(curve.style),
                  curve.label.empty() ? "notitle" : "title " + gnuplot_quoted(curve.label));
  if (curve.style == CurveStyle::kFront)
    out += fmt::format(", $d{} using 1:2 with steps lw 1 lc rgb '#b2182b' notitle", block);
  if (!curve.names.empty())
    out += fmt::format(
        ", $d{} using 1:2:3 with labels left offset char 0.7,0.4 noenhanced font ',8' notitle",
        block);
  return out;
}

std::string plot_words(const Plot& plot, int& next_block, std::string& blocks) {
  std::string curves;
  for (const Curve& curve : plot.curves) {
    const std::string words = curve_words(plot, curve, next_block, blocks);
    if (words.empty()) continue;
    curves += (curves.empty() ? "" : ", ") + words;
  }
  std::string out =
      "reset\nset key outside below horizontal noenhanced samplen 2 font ',9'\nset grid lc rgb "
      "'#d8d8d8'\n";
  out += fmt::format("set title {} noenhanced font ',12'\nset xlabel {} noenhanced\n",
                     gnuplot_quoted(plot.title), gnuplot_quoted(plot.x_label));
  out += fmt::format("set ylabel {} noenhanced\n", gnuplot_quoted(plot.y_label));
  const auto has = [&plot](auto what) {
    return std::any_of(plot.curves.begin(), plot.curves.end(), what);
  };
  if (has([](const Curve& curve) { return !curve.names.empty(); }))
    out += "set offsets graph 0.03, graph 0.2, graph 0.06, graph 0.03\n";  // room for the names
  else if (has([](const Curve& curve) { return curve.style == CurveStyle::kMarks; }))
    out += "set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\n";  // none on the frame
  if (plot.log_x) out += "set logscale x\nset format x '%g'\n";
  if (plot.log_y) out += "set logscale y\nset format y '%g'\n";
  for (std::size_t i = 0; i < plot.notes.size(); ++i)
    out += fmt::format("set label {} {} at graph 0.03, graph {:.3f} noenhanced font ',9'\n", i + 1,
                       gnuplot_quoted(plot.notes[i]), 0.95 - 0.055 * static_cast<double>(i));
  if (!curves.empty())
    return out + fmt::format("set xrange [*:*]\nset yrange [*:*]\nplot {}\n", curves);
  return out +
         "set label 999 'nothing to draw' at graph 0.5, graph 0.5 center\n"
         "unset logscale\nset xrange [0:1]\nset yrange [0:1]\nplot NaN notitle\n";
}

}  // namespace

std::string plot_script(const std::vector<Plot>& plots, int columns, PlotSize size) {
  std::string blocks, commands;
  int next_block = 0;
  for (const Plot& plot : plots) commands += plot_words(plot, next_block, blocks);
  return blocks + gnuplot_sheet(plots.size(), columns, size.width, size.height) + commands +
         "unset multiplot\n";
}

void write_plots(const std::vector<Plot>& plots, int columns, const std::filesystem::path& file,
                 PlotSize size) {
  draw_by_gnuplot(plot_script(plots, columns, size), file);
}

}  // namespace cigsim
