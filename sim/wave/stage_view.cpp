// SPDX-License-Identifier: MIT
#include "sim/wave/stage_view.hpp"

#include <algorithm>
#include <stdexcept>

#include "sim/wave/embedded_views.hpp"
#include "sim/wave/signal_names.hpp"

namespace cigsim {
namespace {

constexpr std::string_view kClock = "@28\ncigsim.clock\n";

// As in the file; a signal that the file does not have stays as it is.
std::string with_range(std::string_view name, const std::vector<WaveSignal>& signals) {
  try {
    const WaveSignal& signal = signals[SignalNames(signals).find(name)];
    return signal.name + signal.range;
  } catch (const std::invalid_argument&) {
    return std::string(name);
  }
}

}  // namespace

StageView stage_view(std::string_view stage, const std::vector<WaveSignal>& signals,
                     const std::string& folder) {
  const std::string scope = "cigsim." + std::string(stage) + ".";
  const bool rtl = std::any_of(signals.begin(), signals.end(), [&](const WaveSignal& signal) {
    return signal.name.starts_with(scope + "rtl.");
  });
  std::string_view view =
      embedded_text(embedded_views(), std::string(stage) + (rtl ? ".rtl.gtkw" : ".gtkw"));
  if (const std::size_t clock = view.find(kClock); clock != std::string_view::npos)
    view.remove_prefix(clock + kClock.size());
  StageView result;
  while (!view.empty()) {
    const std::size_t end = std::min(view.find('\n'), view.size());
    const std::string_view line = view.substr(0, end);
    view.remove_prefix(std::min(end + 1, view.size()));
    if (line.starts_with('^')) {
      const std::size_t name = line.find(' ') + 1;
      result.names.emplace(line.substr(name));
      result.text.append(line.substr(0, name)).append(folder).append(line.substr(name));
    } else {
      result.text += line.starts_with(scope) ? with_range(line, signals) : std::string(line);
    }
    result.text += '\n';
  }
  return result;
}

}  // namespace cigsim
