// SPDX-License-Identifier: MIT
#include <numeric>

#include "sim/measure/host.hpp"
#include "sim/measure/reference.hpp"
#include "sim/stats.hpp"
#include "sim/tradeoff/tradeoff.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

Json cycles_json(const TradeoffPoint& point) {
  const std::vector<Cycle>& delays = point.measured.delays;
  if (delays.empty()) return nullptr;
  return {
      {"delays", delays},
      {"mean_delay", static_cast<double>(std::accumulate(delays.begin(), delays.end(), Cycle{0})) /
                         static_cast<double>(delays.size())},
      {"error", point.cycle_error ? Json(*point.cycle_error) : Json()}};
}

Json host_figures(const TradeoffPoint& point) {
  const Measured& m = point.measured;
  if (m.given_up) return {{"given_up", *m.given_up}};
  const bool timed = m.mcycles_per_second.median > 0;
  return {{"given_up", nullptr},
          {"frame_ms", spread_json(m.frame_ms)},
          {"frames_per_second", m.frame_ms.median > 0 ? Json(1e3 / m.frame_ms.median) : Json()},
          {"million_cycles_per_second", timed ? spread_json(m.mcycles_per_second) : Json()},
          {"memory_mib", spread_json(m.memory_mib)},
          {"front", point.front}};
}

Json point_json(const TradeoffPoint& point) {
  const Measured& m = point.measured;
  return {{"name", m.setting.name},
          {"knob", point.knob},
          {"setting", setting_json(m.setting)},
          {"error", m.errors.empty() ? Json() : picture_error_json(m.error())},
          {"overload", m.overload.frames > 0 ? overload_sum_json(m.overload) : Json()},
          {"cycles", cycles_json(point)},
          {"host", host_figures(point)}};
}

}  // namespace

Json tradeoff_json(const Tradeoff& t) {
  Json points = Json::array();
  for (const TradeoffPoint& point : t.points) points.push_back(point_json(point));
  return {{"experiment", "tradeoff"},
          {"seed", t.options.seed},
          {"versions", versions_json()},
          {"host", host_json()},
          {"scene", t.scene},
          {"raster", {t.range.raster.width, t.range.raster.height}},
          {"frames", t.frames},
          {"rounds", t.options.rounds},
          {"machine", t.range.description.name},
          {"reference", {{"number", name_of(exact_number())}, {"detail", "most"}}},
          {"referee", t.referee ? Json(name_of(*t.referee)) : Json()},
          {"left_out", t.left_out},
          {"notes", t.notes},
          {"points", std::move(points)}};
}

}  // namespace cigsim
