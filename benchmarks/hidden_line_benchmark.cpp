// SPDX-License-Identifier: MIT
// Hidden lines of Levine's data sets (Levine 1975, app. III): a frame a degree, yaw and then pitch
// through 360 degrees, all of the set in view.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "models/environment/placement.hpp"
#include "models/hidden_line/hidden_lines.hpp"
#include "models/hidden_line/scene_parts.hpp"

namespace cigsim::benchmarks {
namespace {

using benchmark::Counter;

hidden_line::HiddenLines load(const std::string& set) {
  const Environment environment =
      read_environment(std::string(CIGSIM_SOURCE_DIR) + "/scenes/levine-" + set + ".json")
          .environment;
  const std::vector<Placement> placements(environment.systems.size());
  Notices notices;
  return hidden_line::HiddenLines(hidden_line::scene_parts(environment, placements, {}, notices));
}

// 720 views from three times the reach of the set.
std::vector<ViewTransform> views_of(const hidden_line::HiddenLines& lines) {
  Vec3 low = lines.parts()[0].vertices[0], high = low;
  for (const hidden_line::Part& part : lines.parts())
    for (const Vec3& v : part.vertices) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
  const Vec3 centre = low * 0.5 + high * 0.5, d = high - low;
  const double distance = 1.5 * std::sqrt(dot(d, d));
  std::vector<ViewTransform> views;
  for (const bool pitch : {false, true})
    for (int degrees = 0; degrees < 360; ++degrees) {
      Placement eye{{}, pitch ? 0.0 : degrees, pitch ? degrees : 0.0, 0};
      const Mat3 axes = body_axes(eye);
      views.push_back({centre - axes.row[0] * distance, axes, 1024, {1024, 1024}});
    }
  return views;
}

void frames(benchmark::State& state, const char* set) {
  hidden_line::HiddenLines lines = load(set);
  const std::vector<ViewTransform> views = views_of(lines);
  double computed = 0, actual = 0, exact = 0, edges = 0;
  for (auto _ : state)
    for (const ViewTransform& view : views) {
      lines.compute(view);
      const hidden_line::Counters& c = lines.counters();
      computed += static_cast<double>(c.intersections_computed);
      actual += static_cast<double>(c.actual_intersections);
      exact += static_cast<double>(c.exact);
      edges += static_cast<double>(c.edges_displayed);
    }
  const double count = static_cast<double>(state.iterations()) * static_cast<double>(views.size());
  state.counters["frame"] = Counter(count, Counter::kIsRate | Counter::kInvert);  // time of a frame
  state.counters["ED"] = edges / count;
  state.counters["AI/IC"] = actual / computed;
  state.counters["exact"] = exact / count;
}

BENCHMARK_CAPTURE(frames, cubes_4, "cubes-4")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, cubes_8, "cubes-8")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, cubes_16, "cubes-16")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, cubes_24, "cubes-24")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, cubes_32, "cubes-32")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, cubes_48, "cubes-48")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, city, "city")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cigsim::benchmarks

BENCHMARK_MAIN();
