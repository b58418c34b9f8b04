// SPDX-License-Identifier: MIT
// Plots of figures as SVG, drawn by gnuplot (Debian's package gnuplot-nox).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "models/numeric/orientation2.hpp"
#include "sim/drawing/gnuplot.hpp"

namespace cigsim {

enum class CurveStyle {
  kLine,
  kMarks,      ///< a mark a point, unconnected
  kLineMarks,  ///< marks, connected
  kBars,       ///< a box a point, down to the axis
  kFront       ///< rings connected by steps, ascending in x: a Pareto front
};

struct Curve {
  std::string label = {};  ///< of the key; empty: not in the key
  std::vector<Vec2> points = {};
  CurveStyle style = CurveStyle::kLineMarks;
  std::vector<std::string> names = {};  ///< written beside the points, one each; empty: none are
};

struct Plot {
  std::string title = {}, x_label = {}, y_label = {};
  bool log_x = false, log_y = false;
  std::vector<std::string> notes = {};  ///< lines of words under the title
  std::vector<Curve> curves = {};
};

/// Pixels.
struct PlotSize {
  int width = 480, height = 360;
};

/// The commands for gnuplot that draw the plots side by side in rows of `columns`, each of the same
/// size, as SVG on its standard output. Points that are not finite, and on a logarithmic axis those
/// that are not positive, are left out; a plot without any says so.
std::string plot_script(const std::vector<Plot>& plots, int columns, PlotSize size = {});

/// Draws them into `file`, as draw_by_gnuplot() does.
void write_plots(const std::vector<Plot>& plots, int columns, const std::filesystem::path& file,
                 PlotSize size = {});

}  // namespace cigsim
