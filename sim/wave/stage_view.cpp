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

bool has_scope(const std::vector<WaveSignal>& signals, const std::string& scope) {
  return std::any_of(signals.begin(), signals.end(),
                     [&](const WaveSignal& signal) { return signal.name.starts_with(scope); });
}

// The view that the program carries under `name`, without the clock; what it shows of `scope` is
// that of `shown`.
void append(StageView& result, const std::string& name, const std::string& scope,
            const std::string& shown, const std::vector<WaveSignal>& signals,
            const std::string& folder) {
  std::string_view view = embedded_text(embedded_views(), name);
  if (const std::size_t clock = view.find(kClock); clock != std::string_view::npos)
    view.remove_prefix(clock + kClock.size());
  while (!view.empty()) {
    const std::size_t end = std::min(view.find('\n'), view.size());
    const std::string_view line = view.substr(0, end);
    view.remove_prefix(std::min(end + 1, view.size()));
    if (line.starts_with('^')) {
      const std::size_t names = line.find(' ') + 1;
      result.names.emplace(line.substr(names));
      result.text.append(line.substr(0, names)).append(folder).append(line.substr(names));
    } else if (line.starts_with(scope)) {
      result.text += with_range(shown + std::string(line.substr(scope.size())), signals);
    } else {
      result.text += line;
    }
    result.text += '\n';
  }
}

}  // namespace

StageView stage_view(std::string_view stage, const std::vector<WaveSignal>& signals,
                     const std::string& folder) {
  const std::string name(stage), scope = "cigsim." + name + ".", twin = "cigsim." + name + "_twin.";
  StageView result;
  append(result, name + (has_scope(signals, scope + "rtl.") ? ".rtl.gtkw" : ".gtkw"), scope, scope,
         signals, folder);
  if (has_scope(signals, twin)) {
    result.text += "@200\n-CLOCKED TWIN\n";
    append(result, name + ".gtkw", scope, twin, signals, folder);
  }
  return result;
}

}  // namespace cigsim
