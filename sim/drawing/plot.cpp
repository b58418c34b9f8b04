// SPDX-License-Identifier: MIT
#include "sim/drawing/plot.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <stdexcept>

#include "models/environment/input_error.hpp"
#include "models/environment/write.hpp"
#include "sim/program_pipe.hpp"

namespace cigsim {
namespace {

constexpr int kPlotWidth = 480, kPlotHeight = 360;

// Words as gnuplot's quoted string; within single quotes only these count.
std::string in_quotes(std::string_view words) {
  std::string out = "'";
  for (const char c : words) {
    if (c == '\'') out += '\'';
    if (static_cast<unsigned char>(c) >= 0x20) out += c;
  }
  return out + "'";
}

bool drawable(const Plot& plot, const Vec2& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && (!plot.log_x || point.x > 0) &&
         (!plot.log_y || point.y > 0);
}

std::string range(const std::optional<std::pair<double, double>>& range) {
  return range ? fmt::format("[{:.17g}:{:.17g}]", range->first, range->second) : "[*:*]";
}

const char* style_of(CurveStyle style) {
  switch (style) {
    case CurveStyle::kLine:
      return "lines lw 1.5";
    case CurveStyle::kMarks:
      return "points pt 7 ps 0.4";
    case CurveStyle::kBars:
      return "boxes fs solid 0.6 noborder";
    default:
      return "linespoints lw 1.5 pt 7 ps 0.4";
  }
}

// The points as a named block of data, and the words that plot it; empty where nothing can be
// drawn.
std::string curve_words(const Plot& plot, const Curve& curve, int& next_block,
                        std::string& blocks) {
  std::string data;
  for (const Vec2& point : curve.points)
    if (drawable(plot, point)) data += fmt::format("{:.17g} {:.17g}\n", point.x, point.y);
  if (data.empty()) return {};
  const int block = next_block++;
  blocks += fmt::format("$d{} << EOD\n{}EOD\n", block, data);
  return fmt::format("$d{} using 1:2 with {} {}", block, style_of(curve.style),
                     curve.label.empty() ? "notitle" : "title " + in_quotes(curve.label));
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
                     in_quotes(plot.title), in_quotes(plot.x_label));
  out += fmt::format("set ylabel {} noenhanced\n", in_quotes(plot.y_label));
  if (plot.log_x) out += "set logscale x\n";
  if (plot.log_y) out += "set logscale y\n";
  for (std::size_t i = 0; i < plot.notes.size(); ++i)
    out += fmt::format("set label {} {} at graph 0.03, graph {:.3f} noenhanced font ',9'\n", i + 1,
                       in_quotes(plot.notes[i]), 0.95 - 0.055 * static_cast<double>(i));
  if (!curves.empty())
    return out + fmt::format("set xrange {}\nset yrange {}\nplot {}\n", range(plot.x_range),
                             range(plot.y_range), curves);
  return out +
         "set label 999 'nothing to draw' at graph 0.5, graph 0.5 center\n"
         "unset logscale\nset xrange [0:1]\nset yrange [0:1]\nplot NaN notitle\n";
}

// A file in memory that the program which we start can read by the name path().
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view contents) : file_(::memfd_create("plot", 0)) {
    if (file_ < 0) throw std::runtime_error("no memory for a plot");
    while (!contents.empty()) {
      const ssize_t written = ::write(file_, contents.data(), contents.size());
      if (written <= 0) throw std::runtime_error("no memory for a plot");
      contents.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  ~MemoryFile() { ::close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return fmt::format("/proc/self/fd/{}", file_); }

 private:
  int file_;
};

}  // namespace

bool can_plot() { return has_program("gnuplot"); }

std::string plot_script(const std::vector<Plot>& plots, int columns) {
  const int rows = (static_cast<int>(plots.size()) + columns - 1) / columns;
  std::string blocks, commands;
  int next_block = 0;
  for (const Plot& plot : plots) commands += plot_words(plot, next_block, blocks);
  return blocks +
         fmt::format(
             "set terminal svg size {},{} font 'Helvetica,11' background rgb '#ffffff'\n"
             "set multiplot layout {},{}\n",
             columns * kPlotWidth, rows * kPlotHeight, rows, columns) +
         commands + "unset multiplot\n";
}

void write_plots(const std::vector<Plot>& plots, int columns, const std::filesystem::path& file) {
  if (!can_plot())
    throw InputError(file.string(), 0,
                     "cannot be drawn without gnuplot; install Debian's package gnuplot-nox");
  const MemoryFile script(plot_script(plots, columns));
  Pipe gnuplot({"gnuplot", script.path()}, Pipe::End::kReads);
  std::string svg;
  char block[1 << 14];
  while (const std::size_t got = std::fread(block, 1, sizeof block, gnuplot.file()))
    svg.append(block, got);
  if (!gnuplot.finish() || svg.empty())
    throw InputError(file.string(), 0, "was not drawn: gnuplot failed; is its installation whole?");
  write_file(file, svg);
}

}  // namespace cigsim
