// SPDX-License-Identifier: MIT
// Plots of figures as SVG, drawn by gnuplot (Debian's package gnuplot-nox).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "models/numeric/orientation2.hpp"

namespace cigsim {

enum class CurveStyle {
  kLine,
  kMarks,      ///< a mark a point, unconnected
  kLineMarks,  ///< marks, connected
  kBars        ///< a box a point, down to the axis
};

struct Curve {
  std::string label = {};  ///< of the key; empty: not in the key
  std::vector<Vec2> points = {};
  CurveStyle style = CurveStyle::kLineMarks;
};

struct Plot {
  std::string title = {}, x_label = {}, y_label = {};
  bool log_x = false, log_y = false;
  std::optional<std::pair<double, double>> x_range = {},
                                           y_range = {};  ///< none: what the points need
  std::vector<std::string> notes = {};                    ///< lines of words under the title
  std::vector<Curve> curves = {};
};

/// Whether gnuplot is there.
bool can_plot();

/// The commands for gnuplot that draw the plots side by side in rows of `columns`, each 480 x 360
/// pixels, as SVG on its standard output. Points that are not finite, and on a logarithmic axis
/// those that are not positive, are left out; a plot without any says so.
std::string plot_script(const std::vector<Plot>& plots, int columns);

/// Draws them into `file`, whole or not at all. Throws InputError, naming the package, when gnuplot
/// is missing, and when it or the file system fails.
void write_plots(const std::vector<Plot>& plots, int columns, const std::filesystem::path& file);

}  // namespace cigsim
