// SPDX-License-Identifier: MIT
#include "sim/experiments/economies.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "models/environment/placement.hpp"
#include "sim/measure/trial.hpp"

namespace cigsim {
namespace {

// Trials of one side, one a round.
struct Series {
  std::vector<double> frame_ms, memory_mib, stage_ms;
};

double mean_of(const std::vector<double>& values) {
  return values.empty() ? 0
                        : std::accumulate(values.begin(), values.end(), 0.0) /
                              static_cast<double>(values.size());
}

// The machine's figures over the frames, of one side.
struct Walk {
  std::uint64_t active_items = 0, ordered_groups = 0, tested_planes = 0, faces = 0, edges = 0;
  double stage_ms = 0;

  void add(const FrameStats& stats) {
    active_items += stats.active_items;
    ordered_groups += stats.ordered_groups;
    tested_planes += stats.tested_planes;
    faces += stats.faces;
    edges += stats.edges;
  }
};

std::uint64_t differing_elements(const Picture& a, const Picture& b) {
  std::uint64_t differing = 0;
  for (std::size_t e = 0; e < a.colours.size(); ++e)
    differing += a.colours[e] != b.colours[e] || a.numbers[e] != b.numbers[e];
  return differing;
}

// Both sides at the functional level frame by frame: what they count, the time of the stage, and
// how their pictures differ.
class Twins {
 public:
  Twins(const Economy& economy, const std::vector<FrameView>& views)
      : economy_(economy),
        views_(views),
        with_(*economy.database_with, economy.setting_with.machine),
        without_(*economy.database_without, economy.setting_without.machine) {}

  void look(EconomyResult& result) {
    Walk with, without;
    for (const FrameView& view : views_) {
      const Picture& a = with_.compute(view.viewpoint, view.position);
      const Picture& b = without_.compute(view.viewpoint, view.position);
      result.elements += a.colours.size();
      result.differing += differing_elements(a, b);
      with.add(with_.stats());
      without.add(without_.stats());
    }
    const auto add = [&](const char* what, std::uint64_t Walk::*value) {
      if (with.*value != without.*value)
        result.counts.push_back({what, with.*value, without.*value});
    };
    add("active items", &Walk::active_items);
    add("groups ordered", &Walk::ordered_groups);
    add("planes tested", &Walk::tested_planes);
    add("front faces", &Walk::faces);
    add("edges", &Walk::edges);
  }

  // One pass of each side over all frames.
  void time_stage(bool first, Series& with, Series& without) {
    for (const bool is_with : {first, !first})
      (is_with ? with : without).stage_ms.push_back(pass(is_with ? with_ : without_));
  }

 private:
  double pass(FunctionalMachine& machine) {
    double sum = 0;
    for (const FrameView& view : views_) {
      machine.compute(view.viewpoint, view.position);
      sum += machine.stats().stages.*economy_.stage->second;
    }
    return sum / static_cast<double>(views_.size());
  }

  const Economy& economy_;
  const std::vector<FrameView>& views_;
  FunctionalMachine with_, without_;
};

std::vector<FrameView> some(const std::vector<FrameView>& views) {
  const std::size_t count = std::max<std::size_t>(2, views.size() / 10);
  return {views.begin(),
          views.begin() + static_cast<std::ptrdiff_t>(std::min(count, views.size()))};
}

void finish(const Series& series, EconomySide& side) {
  side.frame_ms = spread(series.frame_ms);
  side.memory_mib = spread(series.memory_mib);
  side.stage_ms = spread(series.stage_ms);
}

void run_trials(const Economy& economy, const std::vector<FrameView>& views,
                const EconomyOptions& options, EconomyResult& result, Series& with,
                Series& without) {
  for (const std::size_t side : interleaved(2, options.rounds, options.seed)) {
    const bool is_with = side == 0;
    const Setting& setting = is_with ? economy.setting_with : economy.setting_without;
    const Workload work{is_with ? economy.database_with : economy.database_without, views, nullptr};
    const Trial trial = run_trial(setting, work, {}, options.limit_s);
    Series& series = is_with ? with : without;
    series.frame_ms.push_back(mean_of(trial.frame_ms));
    series.memory_mib.push_back(trial.memory_mib);
    EconomySide& seen = is_with ? result.with : result.without;
    seen.digests.push_back(trial.digest);
    seen.delays.push_back(trial.delays);
  }
}

// How many of `values` are not `want`.
template <class T>
std::size_t others(const std::vector<T>& values, const T& want) {
  return values.size() - static_cast<std::size_t>(std::count(values.begin(), values.end(), want));
}

}  // namespace

std::size_t EconomyResult::wrong_rounds() const {
  std::size_t wrong = 0;
  for (const EconomySide* side : {&with, &without}) {
    const EconomySide& model = economy.same_pictures ? without : *side;
    if (!side->digests.empty()) wrong += others(side->digests, model.digests.front());
    if (economy.same_cycles && !side->delays.empty())
      wrong += others(side->delays, without.delays.front());
  }
  return wrong;
}

std::vector<FrameView> slow_flight(const Database& database, std::size_t frames) {
  const Vec3 eye = database.view.eye.position;
  const Vec3 way = database.systems[0].sphere.centre - eye;
  const double step = 1e-3 * std::hypot(way.x, way.y, way.z);
  const Vec3 right = body_axes(database.view.eye).row[1];
  std::vector<FrameView> views;
  for (std::size_t f = 0; f < frames; ++f) {
    Viewpoint viewpoint{database.view.eye, database.view.fov};
    viewpoint.eye.position = eye + right * (step * static_cast<double>(f));
    views.push_back({viewpoint, static_cast<double>(f)});
  }
  return views;
}

EconomyResult run_economy(const Economy& economy, const EconomyScene& scene,
                          const EconomyOptions& options) {
  const bool functional =
      economy.setting_with.levels.functional() && economy.setting_without.levels.functional();
  const std::vector<FrameView> views = functional ? scene.views : some(scene.views);
  EconomyResult result;
  result.economy = economy;
  result.frames = views.size();
  Series with, without;
  run_trials(economy, views, options, result, with, without);
  if (functional) {
    Twins twins(economy, views);
    twins.look(result);
    if (economy.stage)
      for (std::size_t round = 0; round < options.rounds; ++round)
        twins.time_stage(round % 2 == 0, with, without);
  }
  finish(with, result.with);
  finish(without, result.without);
  return result;
}

bool SceneEconomies::holds() const {
  return so.wrong_rows == 0 && std::all_of(results.begin(), results.end(),
                                           [](const EconomyResult& r) { return r.holds(); });
}

SceneEconomies run_economies(const EconomyScene& scene, const EconomyOptions& options) {
  SceneEconomies out;
  out.scene = scene;
  LeanDatabases lean;
  const std::vector<Economy> economies = economies_of(scene, options, lean);
  const double steps = static_cast<double>(economies.size()) + 1;
  for (const Economy& economy : economies) {
    if (options.progress)
      options.progress(static_cast<double>(out.results.size()) / steps, economy.name);
    out.results.push_back(run_economy(economy, scene, options));
  }
  out.so = so_steps(*scene.database, scene.views, options.raster, options.rounds, options.seed);
  return out;
}

}  // namespace cigsim
