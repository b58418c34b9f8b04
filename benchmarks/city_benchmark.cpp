// SPDX-License-Identifier: MIT
// A frame of a city by cigsim, by Mesa llvmpipe and by Embree, and frames of the city and of the
// approach in certified numbers beside doubles, in one run; see docs/performance.md.
#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "benchmarks/agreement.hpp"
#include "benchmarks/city_scene.hpp"
#include "benchmarks/embree_renderer.hpp"
#include "benchmarks/mesa_packed.hpp"
#include "benchmarks/mesa_targets.hpp"
#include "benchmarks/number_contest.hpp"
#include "benchmarks/stage_times.hpp"
#include "benchmarks/summary_reporter.hpp"
#include "models/frame_calculator/functional.hpp"
#include "sim/functional_machine.hpp"
#include "sim/scene.hpp"
#include "sim/view.hpp"

namespace cigsim::benchmarks {
namespace {

constexpr Raster kRaster{1024, 1024};
constexpr const char* kPacked = "llvmpipe";
constexpr const char* kTargets = "llvmpipe, 2 targets";
constexpr const char* kEmbree = "Embree";
constexpr double kMostDiffering = 0.005;

MachineOptions machine_options() {
  MachineOptions options;
  options.raster = kRaster;
  return options;
}

/// One scene and all who draw it.
struct Contest {
  Contest(std::string scene_name, bool with_ground)
      : name(std::move(scene_name)),
        scene(make_city(with_ground)),
        mesh(make_mesh(scene.database)),
        machine(scene.database, machine_options()),
        packed(mesh, kRaster),
        targets(mesh, kRaster) {
    for (const Viewpoint& viewpoint : scene.path)
      views.push_back(frame_calculator::view_transform(viewpoint, kRaster));
    if (EmbreeRenderer::available()) embree = std::make_unique<EmbreeRenderer>(mesh, kRaster);
  }

  std::string name;
  CityScene scene;
  std::vector<ViewTransform> views;
  Mesh mesh;
  FunctionalMachine machine;
  MesaPacked packed;
  MesaTargets targets;
  std::unique_ptr<EmbreeRenderer> embree;
};

Picture unpacked(const std::vector<std::uint32_t>& elements) {
  Picture picture{kRaster.width, kRaster.height, {}, {}};
  for (const std::uint32_t element : elements) {
    picture.colours.push_back(element | 0xff000000u);
    picture.numbers.push_back(static_cast<std::uint16_t>(element >> 24));
  }
  return picture;
}

bool report(const Contest& contest, const char* other, const Agreement& agreement) {
  const bool good = agreement.share() < kMostDiffering;
  fmt::print(
      "{}: cigsim and {}: differences in {:.4f} % of the elements; in {} of {} without a neighbour "
      "that "
      "agrees{}\n",
      contest.name, other, 100 * agreement.share(), agreement.astray, agreement.elements,
      good ? "" : " -- too many");
  return good;
}

bool agree(Contest& contest) {
  Agreement packed, targets, embree;
  for (std::size_t k = 0; k < contest.views.size(); ++k) {
    const Picture& picture = contest.machine.compute(contest.scene.path[k], 0);
    packed += compare(picture, unpacked(contest.packed.draw(contest.views[k])));
    targets += compare(picture, contest.targets.draw(contest.views[k]));
    if (contest.embree) embree += compare(picture, contest.embree->draw(contest.views[k]));
  }
  bool good = report(contest, kPacked, packed);
  good = report(contest, kTargets, targets) && good;
  return contest.embree ? report(contest, kEmbree, embree) && good : good;
}

void time_cigsim(benchmark::State& state, Contest& contest) {
  std::size_t frame = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        contest.machine.compute(contest.scene.path[frame++ % contest.scene.path.size()], 0));
  contest.machine.compute(contest.scene.path.front(), 0);
  const FrameStats& stats = contest.machine.stats();
  state.counters["bytes"] = 6.0 * kRaster.width * kRaster.height;
  state.counters["edges"] = static_cast<double>(stats.edges);
  state.counters["face-lines"] = static_cast<double>(stats.crossings) / 2;
  state.counters["spans"] = static_cast<double>(stats.spans);
}

template <class Renderer>
void time_renderer(benchmark::State& state, const Contest& contest, Renderer& renderer) {
  std::size_t frame = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(renderer.draw(contest.views[frame++ % contest.views.size()]));
}

/// The floor: the bytes of a frame, written in order.
void time_fill(benchmark::State& state) {
  Picture picture{kRaster.width, kRaster.height, {}, {}};
  picture.colours.resize(static_cast<std::size_t>(kRaster.width) * kRaster.height);
  picture.numbers.resize(picture.colours.size());
  std::uint32_t value = 0;
  for (auto _ : state) {
    ++value;
    std::fill(picture.colours.begin(), picture.colours.end(), value);
    std::fill(picture.numbers.begin(), picture.numbers.end(), static_cast<std::uint16_t>(value));
    benchmark::DoNotOptimize(picture.colours.data());
    benchmark::DoNotOptimize(picture.numbers.data());
    benchmark::ClobberMemory();
  }
  state.counters["bytes"] = 6.0 * kRaster.width * kRaster.height;
}

void register_contest(Contest& contest) {
  const auto add = [&](const char* who, auto function) {
    benchmark::RegisterBenchmark((contest.name + " " + who).c_str(), function)->UseRealTime();
  };
  add("cigsim", [&](benchmark::State& state) { time_cigsim(state, contest); });
  add(kPacked, [&](benchmark::State& state) { time_renderer(state, contest, contest.packed); });
  add(kTargets, [&](benchmark::State& state) { time_renderer(state, contest, contest.targets); });
  if (contest.embree)
    add(kEmbree, [&](benchmark::State& state) { time_renderer(state, contest, *contest.embree); });
}

/// Median milliseconds of each stage.
void print_stages(Contest& contest) {
  constexpr std::size_t kFrames = 401;
  std::vector<StageTimes> frames;
  for (std::size_t k = 0; k < kFrames; ++k) {
    contest.machine.compute(contest.scene.path[k % contest.scene.path.size()], 0);
    frames.push_back(contest.machine.stats().stages);
  }
  fmt::print("\n{}: median ms of each stage\n", contest.name);
  for (const Stage& stage : kStages)
    fmt::print("  {:<20}{:>9.4f}\n", stage.name,
               median_of(frames, [&](const StageTimes& times) { return times.*stage.time; }));
}

void print_ratio(const SummaryReporter& summary, const Contest& contest, const char* other,
                 double goal) {
  const auto own = summary.times(contest.name + " cigsim");
  const auto others = summary.times(contest.name + " " + other);
  if (own && others)
    fmt::print("{}: {} / cigsim: {:.1f} by medians, {:.1f} by least times (goal: {:.0f})\n",
               contest.name, other, others->median / own->median, others->least / own->least, goal);
}

std::vector<FrameView> frames_of(const CityScene& scene) {
  std::vector<FrameView> views;
  for (const Viewpoint& viewpoint : scene.path) views.push_back({viewpoint, 0});
  return views;
}

std::vector<FrameView> approach(const Database& airfield) {
  ViewOptions options;
  options.path = "builtin";
  options.frames = 30;  // so that each run meets all of them
  return frame_views(options, load_path(options), airfield);
}

int run(int argc, char** argv) {
  // Defaults before the user's options, so that these win.
  std::vector<std::string> arguments{argv[0], "--benchmark_repetitions=41",
                                     "--benchmark_enable_random_interleaving=true",
                                     "--benchmark_min_time=0.03"};
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 2;

  Contest contests[] = {{"city", true}, {"boxes", false}};
  fmt::print("{}\n", contests[0].packed.description());
  fmt::print("{}\n", contests[0].embree ? contests[0].embree->description()
                                        : "Embree is skipped: this processor has no AVX2");
  bool good = true;
  for (Contest& contest : contests) good = agree(contest) && good;
  const LoadedScene airfield = load_scene({}, {});
  NumberContest numbers[] = {
      {contests[0].name, contests[0].scene.database, frames_of(contests[0].scene), kRaster},
      {contests[1].name, contests[1].scene.database, frames_of(contests[1].scene), kRaster},
      {"approach", airfield.database, approach(airfield.database), kRaster}};
  for (NumberContest& contest : numbers) good = contest.agree() && good;
  if (!good) return 1;

  benchmark::RegisterBenchmark("fill", time_fill)->UseRealTime();
  for (Contest& contest : contests) register_contest(contest);
  for (NumberContest& contest : numbers) contest.register_all();
  SummaryReporter summary;
  benchmark::RunSpecifiedBenchmarks(&summary);
  for (Contest& contest : contests) print_stages(contest);
  fmt::print("\n");
  for (const Contest& contest : contests) {
    print_ratio(summary, contest, kPacked, 10);
    print_ratio(summary, contest, kTargets, 10);
    print_ratio(summary, contest, kEmbree, 25);
  }
  for (const NumberContest& contest : numbers) contest.print_ratio(summary);
  return 0;
}

}  // namespace
}  // namespace cigsim::benchmarks

int main(int argc, char** argv) { return cigsim::benchmarks::run(argc, argv); }
