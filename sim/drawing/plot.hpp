// SPDX-License-Identifier: MIT
// Plots of figures as SVG, drawn by gnuplot (Debian's package gnuplot-nox).
#pragma once

#include <string>
#include <vector>

#include "models/numeric/orientation2.hpp"

namespace cigsim {

enum class CurveStyle {
  kLine,
  kMarks,      ///< a mark a point, unconnected
  kLineMarks,  ///< marks, connected
  kBars,       ///< a box a point, down to the axis
  kBound,      ///< a broken line in the colour of the curve before
  kFront       ///< rings connected by steps, ascending in x: a Pareto front
};

enum class Mark { kDisc, kSquare, kTriangle, kPointedDown, kDiamond, kPentagon, kCross };

struct Curve {
  std::string label = {};  ///< of the key; empty: not in the key
  std::vector<Vec2> points = {};
  CurveStyle style = CurveStyle::kLineMarks;
  /// Written beside the points, one each, where none covers another; empty: none are.
  std::vector<std::string> names = {};
  std::string colour = {};  ///< "#2f6fab"; empty: the next of the plot's own
  Mark mark = Mark::kDisc;
};

struct Plot {
  std::string title = {}, x_label = {}, y_label = {};
  bool log_x = false, log_y = false;
  std::vector<std::string> notes = {};  ///< words under the title
  /// Names of rows from the top, instead of figures along y: a point's y is the number of its row,
  /// from 0.
  std::vector<std::string> rows = {};
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

}  // namespace cigsim
