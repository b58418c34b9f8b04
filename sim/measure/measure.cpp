// SPDX-License-Identifier: MIT
#include "sim/measure/measure.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/measure/child.hpp"

namespace cigsim {
namespace {

// The trials of one setting.
struct Series {
  std::map<Stage, std::filesystem::path> libraries;
  std::vector<double> frame_ms, memory_mib, mcycles_per_second;
  std::optional<std::uint64_t> digest;
};

void add(const Trial& trial, Series& series, Measured& result) {
  if (series.digest.value_or(trial.digest) != trial.digest)
    throw MeasureError(
        fmt::format("{}: its pictures differ from one round to another", result.setting.name));
  const double total_ms = std::accumulate(trial.frame_ms.begin(), trial.frame_ms.end(), 0.0);
  series.frame_ms.push_back(total_ms / static_cast<double>(trial.frame_ms.size()));
  series.memory_mib.push_back(trial.memory_mib);
  if (total_ms > 0)
    series.mcycles_per_second.push_back(static_cast<double>(trial.cycles) / total_ms * 1e-3);
  if (series.digest) return;
  series.digest = trial.digest;
  result.delays = trial.delays;
  result.errors = trial.errors;
  result.overload = trial.overload;
}

}  // namespace

PictureError Measured::error() const {
  PictureError total;
  for (const PictureError& error : errors) total += error;
  return total;
}

std::vector<Measured> measure(const std::vector<Setting>& settings, const Workload& work,
                              const MeasureOptions& options) {
  std::vector<Measured> results;
  std::vector<Series> series(settings.size());
  for (std::size_t s = 0; s < settings.size(); ++s) {
    results.emplace_back().setting = settings[s];
    series[s].libraries = rtl_libraries(settings[s], *work.database);
  }
  // What this process has freed must not serve the children: it would not show as memory of theirs.
  ::malloc_trim(0);
  const std::vector<std::size_t> order = interleaved(settings.size(), options.rounds, options.seed);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t s = order[i];
    if (options.progress)
      options.progress(static_cast<double>(i) / static_cast<double>(order.size()),
                       settings[s].name);
    if (results[s].given_up) continue;
    // The errors of the first round are those of all.
    Workload round = work;
    if (series[s].digest) round.references = nullptr;
    Trial trial;
    try {
      trial = run_trial(settings[s], round, series[s].libraries, options.limit_s);
    } catch (const MeasureError& error) {
      results[s].given_up = error.what();
      continue;
    }
    add(trial, series[s], results[s]);
  }
  for (std::size_t s = 0; s < settings.size(); ++s) {
    results[s].frame_ms = spread(series[s].frame_ms);
    results[s].memory_mib = spread(series[s].memory_mib);
    results[s].mcycles_per_second = spread(series[s].mcycles_per_second);
  }
  return results;
}

std::optional<double> cycle_error(const std::vector<Cycle>& delays,
                                  const std::vector<Cycle>& referee) {
  if (delays.empty() || delays.size() != referee.size()) return {};
  double worst = 0;
  for (std::size_t v = 0; v < delays.size(); ++v) {
    const double difference = std::abs(static_cast<double>(delays[v] - referee[v]));
    if (difference > 0)
      worst = std::max(worst, difference / std::max(1.0, static_cast<double>(referee[v])));
  }
  return worst;
}

}  // namespace cigsim
