// SPDX-License-Identifier: MIT
#include "sim/tradeoff/tradeoff.hpp"

#include <algorithm>

#include "sim/arguments.hpp"
#include "sim/measure/child.hpp"
#include "sim/measure/pareto.hpp"
#include "sim/measure/reference.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

bool has(const SweepRange& range, Level level) {
  return std::find(range.levels.begin(), range.levels.end(), level) != range.levels.end();
}

// Without RTL where that can be neither found nor built.
void settle_levels(const Database& database, Tradeoff& tradeoff) {
  std::vector<Level>& levels = tradeoff.range.levels;
  if (has(tradeoff.range, Level::kRtl)) {
    try {
      Setting setting;
      setting.machine.description = tradeoff.range.description;
      rtl_libraries(at_level(setting, Level::kRtl), database);
    } catch (const UsageError& error) {
      tradeoff.left_out.push_back(error.what());
      std::erase(levels, Level::kRtl);
    }
  }
  if (has(tradeoff.range, Level::kRtl))
    tradeoff.referee = Level::kRtl;
  else if (has(tradeoff.range, Level::kClocked) || has(tradeoff.range, Level::kTimed))
    tradeoff.referee = Level::kClocked;
}

// The referee's delays of the same machine: among the points, or computed now.
std::vector<Cycle> referee_delays(const Setting& setting, Tradeoff& tradeoff,
                                  const Workload& work) {
  const Setting referee = at_level(setting, *tradeoff.referee);
  for (const TradeoffPoint& point : tradeoff.points)
    if (point.measured.setting.levels == referee.levels &&
        setting_json(point.measured.setting) == setting_json(referee))
      return point.measured.delays;
  Workload alone = work;
  alone.references = nullptr;
  MeasureOptions once = tradeoff.options;
  once.rounds = 1;
  once.progress = {};
  const Measured measured = measure({referee}, alone, once).front();
  if (measured.given_up)
    tradeoff.left_out.push_back("the referee of " + setting.name + ": " + *measured.given_up);
  return measured.delays;
}

void compare_cycles(Tradeoff& tradeoff, const Workload& work) {
  std::vector<std::pair<nlohmann::ordered_json, std::vector<Cycle>>> known;
  for (TradeoffPoint& point : tradeoff.points) {
    if (point.measured.delays.empty()) continue;
    const auto key = setting_json(at_level(point.measured.setting, *tradeoff.referee));
    auto found = std::find_if(known.begin(), known.end(),
                              [&](const auto& entry) { return entry.first == key; });
    if (found == known.end())
      found =
          known.insert(known.end(), {key, referee_delays(point.measured.setting, tradeoff, work)});
    point.cycle_error = cycle_error(point.measured.delays, found->second);
  }
}

void mark_front(std::vector<TradeoffPoint>& points) {
  std::vector<Vec2> costs;
  std::vector<TradeoffPoint*> measured;
  for (TradeoffPoint& point : points) {
    if (point.measured.given_up) continue;
    costs.push_back(
        {point.measured.frame_ms.median, static_cast<double>(point.measured.error().wrong)});
    measured.push_back(&point);
  }
  const std::vector<bool> front = pareto_front(costs);
  for (std::size_t i = 0; i < front.size(); ++i) measured[i]->front = front[i];
}

}  // namespace

Tradeoff run_tradeoff(const Database& database, const std::vector<FrameView>& views,
                      const SweepRange& range, const TradeoffOptions& options) {
  Tradeoff tradeoff;
  tradeoff.frames = views.size();
  tradeoff.options = options.measure;
  tradeoff.range = range;
  settle_levels(database, tradeoff);
  if (numbers_saturate(database)) tradeoff.notes.emplace_back(kNumbersSaturate);
  const std::vector<ReferencePicture> references =
      reference_pictures(database, views, range.raster, options.references);
  const Workload work{&database, views, &references};
  std::vector<Setting> settings;
  for (SweepPoint& point : sweep(tradeoff.range)) {
    TradeoffPoint& added = tradeoff.points.emplace_back();
    added.knob = std::move(point.knob);
    settings.push_back(std::move(point.setting));
  }
  std::vector<Measured> measured = measure(settings, work, options.measure);
  for (std::size_t i = 0; i < measured.size(); ++i)
    tradeoff.points[i].measured = std::move(measured[i]);
  compare_cycles(tradeoff, work);
  mark_front(tradeoff.points);
  return tradeoff;
}

double drawn_share(const PictureError& error) {
  if (error.wrong > 0 || error.elements == 0) return error.share();
  return 0.5 / static_cast<double>(error.elements);
}

}  // namespace cigsim
