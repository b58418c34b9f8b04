// SPDX-License-Identifier: MIT
// What each step of accuracy costs on a scene: every knob turned, in time, cycles, memory and
// error.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/drawing/gnuplot.hpp"
#include "sim/measure/measure.hpp"
#include "sim/tradeoff/sweep.hpp"

namespace cigsim {

struct TradeoffPoint {
  std::string knob;
  Measured measured;
  std::optional<double> cycle_error;  ///< of the worst frame; none: no cycles, or no referee's
  bool front = false;  ///< nothing else is as fast with as few wrong elements, and better in one
};

struct Tradeoff {
  std::string scene;
  std::size_t frames = 0;
  MeasureOptions options;
  SweepRange range;
  std::optional<Level> referee;       ///< whose cycles count: RTL or clocked
  std::vector<std::string> left_out;  ///< what could not take part, and why
  std::vector<std::string> notes;     ///< what errors do not show
  std::vector<TradeoffPoint> points;  ///< as sweep()
};

struct TradeoffOptions {
  MeasureOptions measure;
  /// Told the share that is done of the reference pictures.
  std::function<void(double)> references;
};

/// Measures `range` over the views. Errors are those beside exact pictures of the most detailed
/// descriptions at the range's raster; cycles those beside the referee, the same machine in RTL, or
/// clocked where RTL does not take part. RTL that cannot be built is left out. Throws MeasureError.
Tradeoff run_tradeoff(const Database& database, const std::vector<FrameView>& views,
                      const SweepRange& range, const TradeoffOptions& options);

/// Share of the wrong elements, for plots with a logarithmic axis: without any, half of one.
double drawn_share(const PictureError& error);

/// docs/schemas/tradeoff.schema.json. What depends on the host is under "host".
nlohmann::ordered_json tradeoff_json(const Tradeoff& tradeoff);

/// The table on the terminal.
std::string tradeoff_table(const Tradeoff& tradeoff);

/// tradeoff.svg: time against wrong elements, with the Pareto front, and against colour; errors
/// against the widths of words; time and memory of numbers and levels.
Sheet tradeoff_sheet(const Tradeoff& tradeoff);

}  // namespace cigsim
