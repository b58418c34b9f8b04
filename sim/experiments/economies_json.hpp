// SPDX-License-Identifier: MIT
// The economies experiment as JSON, as a table, and as a plot.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "sim/drawing/gnuplot.hpp"
#include "sim/experiments/economies.hpp"
#include "sim/experiments/rtl_size.hpp"

namespace cigsim {

/// A scene's economies, and those of its RTL where they were asked for.
struct EconomyReport {
  SceneEconomies economies;
  std::optional<RtlSize> rtl;
  bool holds() const { return economies.holds() && (!rtl || rtl->golden); }
};

/// What a scene may ask for in other machines and this one has not, so that nothing can be saved.
std::span<const char* const> attributes_of_no_machine();

/// The same seed gives the same text, but for what stands under "host".
nlohmann::ordered_json economies_json(const std::vector<EconomyReport>& reports,
                                      const EconomyOptions& options);

/// Lines for the terminal.
std::string economies_text(const EconomyReport& report);

/// The shares of the time that are saved, a scene a plot: economies.svg.
Sheet economies_sheet(const std::vector<EconomyReport>& reports);

}  // namespace cigsim
