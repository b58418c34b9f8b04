// SPDX-License-Identifier: MIT
#include "sim/drawing/heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/drawing/gnuplot.hpp"

namespace cigsim {
namespace {

constexpr int kLeastWidth = 480, kCellWidth = 44, kLeastHeight = 280, kCellHeight = 26;
constexpr int kMargins = 200;  // names, title and colours around the cells
constexpr double kDark = 0.6;  // from here on the colours reach, white words are legible
constexpr std::size_t kMostCellsWithValues = 400;

std::string ticks(const std::vector<std::string>& names, bool from_the_top) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i)
    out += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_quoted(names[i]),
                       from_the_top ? names.size() - 1 - i : i);
  return out;
}

struct Size {
  int width = kLeastWidth, height = kLeastHeight;
};

Size size_of(const std::vector<HeatMap>& maps) {
  Size size;
  for (const HeatMap& map : maps) {
    const int columns = static_cast<int>(map.columns.size());
    const int rows = static_cast<int>(map.rows.size() + map.notes.size());
    size.width = std::max(size.width, columns * kCellWidth + kMargins);
    size.height = std::max(size.height, rows * kCellHeight + kMargins);
  }
  return size;
}

// The cells as lines "column row value"; rows count from the bottom.
std::string cells(const HeatMap& map) {
  std::string out;
  for (std::size_t r = 0; r < map.rows.size(); ++r)
    for (std::size_t c = 0; c < map.columns.size(); ++c) {
      const double value = map.values[r * map.columns.size() + c];
      out += fmt::format("{} {} ", c, map.rows.size() - 1 - r);
      out += std::isfinite(value) ? fmt::format("{:.17g}\n", value) : "NaN\n";
    }
  return out;
}

bool has_values(const HeatMap& map) {
  return std::any_of(map.values.begin(), map.values.end(),
                     [](double value) { return std::isfinite(value); });
}

std::string map_words(const HeatMap& map, std::size_t block) {
  std::string out = fmt::format(
      "reset\nset title {} noenhanced font ',12'\nset xlabel {} noenhanced\nset ylabel {} "
      "noenhanced\n",
      gnuplot_quoted(map.title), gnuplot_quoted(map.x_label), gnuplot_quoted(map.y_label));
  for (std::size_t i = 0; i < map.notes.size(); ++i)
    out += fmt::format(
        "set label {} {} at graph 0, graph 1 offset character 0,{:.1f} noenhanced font ',9'\n",
        i + 1, gnuplot_quoted(map.notes[i]), 0.7 + static_cast<double>(map.notes.size() - 1 - i));
  if (!has_values(map))
    return out +
           "set label 999 'nothing to draw' at graph 0.5, graph 0.5 center\n"
           "set xrange [0:1]\nset yrange [0:1]\nplot NaN notitle\n";
  out += fmt::format(
      "set xtics out nomirror rotate by -35 noenhanced font ',9' ({})\nset ytics out nomirror "
      "noenhanced font ',9' ({})\n",
      ticks(map.columns, false), ticks(map.rows, true));
  out += fmt::format("set xrange [-0.5:{}.5]\nset yrange [-0.5:{}.5]\n", map.columns.size() - 1,
                     map.rows.size() - 1);
  out += fmt::format(
      "set object 1 rectangle from graph 0,0 to graph 1,1 fc rgb '#e4e4e4' fs solid noborder "
      "behind\n"
      "set palette defined (0 '#f7fbf4', 0.15 '#fee391', 0.5 '#fe9929', 1 '#8c1a10')\n"
      "set cbrange [{:.17g}:{:.17g}]\nset bmargin 6\nset tmargin {}\nset title offset character "
      "0,{}\n",
      map.low, map.high, 3 + map.notes.size(), map.notes.size());
  out += fmt::format("plot $m{0} using 1:2:3 with image pixels notitle", block);
  if (map.values.size() <= kMostCellsWithValues)
    out += fmt::format(
        ", $m{0} using 1:2:(valid(3) ? sprintf('%.3g', $3) : ''):(valid(3) && $3 > {1:.17g} ? "
        "0xffffff : 0x1b1b1b) with labels font ',9' textcolor rgb variable notitle",
        block, map.low + kDark * (map.high - map.low));
  return out + "\n";
}

}  // namespace

std::string heat_map_script(const std::vector<HeatMap>& maps, int columns) {
  std::string blocks, commands;
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const HeatMap& map = maps[m];
    if (map.values.size() != map.rows.size() * map.columns.size())
      throw std::invalid_argument("heat map: its values are not rows times columns");
    blocks += fmt::format("$m{} << EOD\n{}EOD\n", m, cells(map));
    commands += map_words(map, m);
  }
  const Size size = size_of(maps);
  return blocks + gnuplot_sheet(maps.size(), columns, size.width, size.height) + commands +
         "unset multiplot\n";
}

}  // namespace cigsim
