// SPDX-License-Identifier: MIT
// How a plot lies in its cell of a sheet: the frame, what is around it, and what its axes reach.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/drawing/name_places.hpp"
#include "sim/drawing/plot.hpp"

namespace cigsim {

/// Width of words in pixels at a size of letters, about (Helvetica).
double words_width(std::string_view words, double size);

/// What an axis reaches over; on a logarithmic one both are positive.
struct AxisRange {
  double low = 0, high = 1;
  bool log = false;
  /// Where on the axis a value stands, from 0 to 1.
  double share(double value) const;
};

struct PlotFrame {
  PixelBox box;                    ///< in the cell
  std::vector<std::string> notes;  ///< as lines that fit
  int key_columns = 1;
};

PlotFrame plot_frame(const Plot& plot, const PlotSize& size);

/// Of plots on a sheet; those beside each other begin and end at the same height.
std::vector<PlotFrame> plot_frames(const std::vector<Plot>& plots, std::size_t columns,
                                   const PlotSize& size);

/// Whether a plot's axes can show a point: finite, and positive where they are logarithmic.
bool drawable(const Plot& plot, const Vec2& point);

/// Whole powers of ten on a logarithmic axis; of a linear one, room for the marks. Nothing when
/// gnuplot shall choose: a linear axis without names beside its points. The plot has a point that
/// can be drawn.
std::optional<AxisRange> x_range(const Plot& plot);
std::optional<AxisRange> y_range(const Plot& plot);

}  // namespace cigsim
