// SPDX-License-Identifier: MIT
// Heat maps as SVG, drawn by gnuplot: a table of shares as coloured cells.
#pragma once

#include <string>
#include <vector>

namespace cigsim {

struct HeatMap {
  std::string title = {}, x_label = {}, y_label = {};
  std::vector<std::string> columns = {}, rows = {};  ///< names along x; along y from the top
  /// Row by row from the top, rows.size() * columns.size() of them; what is not finite stays an
  /// empty cell (not applicable).
  std::vector<double> values = {};
  double low = 0, high = 1;             ///< what the colours reach from (white) and to (dark red)
  std::vector<std::string> notes = {};  ///< lines of words under the title
};

/// The commands for gnuplot that draw the maps side by side in rows of `columns`, as SVG on its
/// standard output. Each cell shows its value where there are at most 400 of them. Throws
/// std::invalid_argument when a map's values are not rows times columns.
std::string heat_map_script(const std::vector<HeatMap>& maps, int columns);

}  // namespace cigsim
