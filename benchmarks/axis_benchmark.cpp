// SPDX-License-Identifier: MIT
// Certified numbers beside doubles in views along an axis, which lay edges through rows and columns
// of samples, so that the bounds of doubles decide nothing there; see docs/performance.md.
#include <fmt/core.h>

#include <string>
#include <utility>
#include <vector>

#include "benchmarks/number_contest.hpp"
#include "benchmarks/summary_reporter.hpp"
#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"

namespace cigsim::benchmarks {
namespace {

constexpr int kEyepoints = 8;
// Odd: the middle of the picture is a sample. With 90 degrees the focal length is half of it.
constexpr Raster kRaster{1023, 1023};

/// Eyepoints at whole multiples of `step`, in a row to the right.
std::vector<FrameView> views(const Vec3& eye, double step, double pitch, double fov = 90) {
  std::vector<FrameView> out;
  for (int k = 0; k < kEyepoints; ++k)
    out.push_back({{{{eye.x + step * k, eye.y, eye.z}, 0, pitch, 0}, fov}, 0});
  return out;
}

Environment scaled(Environment environment, double scale) {
  for (Object& object : environment.objects)
    for (Vec3& v : object.vertices) v = v * scale;
  return environment;
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

  const Environment forty_eight = generate_environment("cubes", {48, 1});
  Environment buildings = generate_environment("city", {200, 1});
  buildings.ground.clear();
  const Database cubes = prepare(forty_eight), tenths = prepare(scaled(forty_eight, 0.1)),
                 boxes = prepare(buildings);
  NumberContest contests[] = {
      {"cubes", cubes, views({0, -10, 0}, 1, 0), kRaster},
      {"cubes, 60 degrees", cubes, views({0, -10, 0}, 1, 0, 60), kRaster},
      {"cubes on samples", cubes, views({1.5, -6, 1.5}, 3, 0), kRaster},
      {"cubes from above", cubes, views({1.5, 1.5, 12}, 1, -90), kRaster},
      {"cubes of tenths", tenths, views({0, -1, 0}, 0.1, 0), kRaster},
      {"tenths on samples", tenths, views({0.15, -0.6, 0.15}, 0.3, 0), kRaster},
      {"boxes", boxes, views({0, -400, 32}, 16, 0), kRaster},
      {"boxes from above", boxes, views({0, 0, 512}, 16, -90), kRaster}};
  bool good = true;
  for (NumberContest& contest : contests) good = contest.agree() && good;
  if (!good) return 1;
  for (NumberContest& contest : contests) contest.register_all();
  SummaryReporter summary;
  benchmark::RunSpecifiedBenchmarks(&summary);
  fmt::print("\n");
  for (const NumberContest& contest : contests) contest.print_ratio(summary);
  return 0;
}

}  // namespace
}  // namespace cigsim::benchmarks

int main(int argc, char** argv) { return cigsim::benchmarks::run(argc, argv); }
