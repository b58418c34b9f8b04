// SPDX-License-Identifier: MIT
#include "benchmarks/number_contest.hpp"

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace cigsim::benchmarks {
namespace {

constexpr double kGoal = 1.5;
constexpr std::size_t kCompared = 32;  // frames: exact ones take long

MachineOptions options(NumberType number, const Raster& raster) {
  MachineOptions out;
  out.number = number;
  out.raster = raster;
  return out;
}

void time_frames(benchmark::State& state, FunctionalMachine& machine,
                 const std::vector<FrameView>& views) {
  std::size_t frame = 0;
  for (auto _ : state) {
    const FrameView& view = views[frame++ % views.size()];
    benchmark::DoNotOptimize(machine.compute(view.viewpoint, view.position));
  }
}

}  // namespace

NumberContest::NumberContest(std::string name, const Database& database,
                             std::vector<FrameView> views, const Raster& raster)
    : name_(std::move(name)),
      database_(database),
      views_(std::move(views)),
      raster_(raster),
      rounded_(database, options(NumberType::kDouble, raster)),
      certified_(database, options(NumberType::kCertified, raster)) {}

bool NumberContest::agree() {
  FunctionalMachine exact(database_, options(NumberType::kExact, raster_));
  std::size_t frames = 0, wrong = 0, rounded_wrong = 0;
  std::uint64_t decisions = 0, redone = 0;
  const auto differing = [](const Picture& a, const Picture& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.numbers.size(); ++i)
      count += a.numbers[i] != b.numbers[i] || a.colours[i] != b.colours[i];
    return count;
  };
  const std::size_t step = std::max<std::size_t>(1, views_.size() / kCompared);
  for (std::size_t k = 0; k < views_.size(); k += step, ++frames) {
    const FrameView& view = views_[k];
    const Picture& want = exact.compute(view.viewpoint, view.position);
    wrong += differing(want, certified_.compute(view.viewpoint, view.position));
    rounded_wrong += differing(want, rounded_.compute(view.viewpoint, view.position));
    const Redone& r = *certified_.stats().redone;
    decisions += r.vertices + r.faces + r.crossings;
    redone += r.vertices_redone + r.faces_redone + r.crossings_redone;
  }
  fmt::print(
      "{}: {} frames against exact ones: certified differ in {} elements, doubles in {}; {} of {} "
      "decisions redone{}\n",
      name_, frames, wrong, rounded_wrong, redone, decisions, wrong == 0 ? "" : " -- wrong");
  return wrong == 0;
}

void NumberContest::register_all() {
  benchmark::RegisterBenchmark((name_ + " double").c_str(), [this](benchmark::State& state) {
    time_frames(state, rounded_, views_);
  })->UseRealTime();
  benchmark::RegisterBenchmark((name_ + " certified").c_str(), [this](benchmark::State& state) {
    time_frames(state, certified_, views_);
  })->UseRealTime();
}

void NumberContest::print_ratio(const SummaryReporter& summary) const {
  const auto rounded = summary.times(name_ + " double");
  const auto certified = summary.times(name_ + " certified");
  if (rounded && certified)
    fmt::print("{}: certified / double: {:.2f} by medians, {:.2f} by least times (goal: {})\n",
               name_, certified->median / rounded->median, certified->least / rounded->least,
               kGoal);
}

}  // namespace cigsim::benchmarks
