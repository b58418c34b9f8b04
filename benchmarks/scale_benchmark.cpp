// SPDX-License-Identifier: MIT
// The cost of a frame against the size of the environment, with the same things in view:
// scale_benchmark [OBJECTS ...]; see docs/performance.md.
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmarks/stage_times.hpp"
#include "models/database/prepare.hpp"
#include "sim/experiments/crowded_city.hpp"

namespace cigsim::benchmarks {
namespace {

constexpr std::uint32_t kVisible = 1000;
constexpr int kFrames = 401;

struct Scale {
  explicit Scale(std::uint32_t objects) {
    const CrowdedCity city = make_crowded_city(kVisible, objects);
    viewpoint = city.viewpoint;
    database = prepare(city.environment);
    machine = std::make_unique<FunctionalMachine>(database, MachineOptions{});
  }

  Viewpoint viewpoint;
  Database database;
  std::unique_ptr<FunctionalMachine> machine;
  std::vector<FrameStats> frames;
  std::vector<double> thread_ms;  ///< of each frame
};

/// The ground's number follows those of all objects, so it may differ.
bool same(const Picture& a, const Picture& b) {
  return a.colours == b.colours &&
         std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(),
                    [](auto m, auto n) { return m == n || (m > kVisible && n > kVisible); });
}

int run(const std::vector<std::uint32_t>& sizes) {
  std::vector<std::unique_ptr<Scale>> scales;
  for (const std::uint32_t objects : sizes) scales.push_back(std::make_unique<Scale>(objects));
  // Frames of the environments in turn, so that they share the machine's moods.
  for (int k = 0; k < kFrames; ++k)
    for (const auto& scale : scales) {
      const double before = thread_milliseconds();
      scale->machine->compute(scale->viewpoint, 0);
      scale->thread_ms.push_back(thread_milliseconds() - before);
      scale->frames.push_back(scale->machine->stats());
    }
  const Picture reference = scales.front()->machine->compute(scales.front()->viewpoint, 0);
  const auto self = [](double ms) { return ms; };
  const double least = median_of(scales.front()->thread_ms, self);
  bool good = true;
  for (const auto& scale : scales) {
    const bool equal = same(reference, scale->machine->compute(scale->viewpoint, 0));
    good = good && equal;
    const FrameStats& stats = scale->machine->stats();
    const double frame = median_of(scale->thread_ms, self);
    fmt::print("{} objects: {} items active, {} edges, {} picture\n", scale->database.object_count,
               stats.active_items, stats.edges, equal ? "the same" : "ANOTHER");
    fmt::print("  {:<20}{:>9.4f} ms, ratio {:.2f}\n", "frame", frame, frame / least);
    for (const Stage& stage : kStages)
      fmt::print(
          "  {:<20}{:>9.4f} ms\n", stage.name,
          median_of(scale->frames, [&](const FrameStats& f) { return f.stages.*stage.time; }));
  }
  return good ? 0 : 1;
}

std::uint32_t size_of(const std::string& argument) {
  const unsigned long size = std::stoul(argument);
  if (size < kVisible || size > 10'000'000) throw std::out_of_range(argument);
  return static_cast<std::uint32_t>(size);
}

}  // namespace
}  // namespace cigsim::benchmarks

int main(int argc, char** argv) {
  std::vector<std::uint32_t> sizes;
  try {
    for (int k = 1; k < argc; ++k) sizes.push_back(cigsim::benchmarks::size_of(argv[k]));
  } catch (const std::logic_error&) {
    fmt::print(stderr, "scale_benchmark [OBJECTS ...]: numbers from 1000 to 10000000\n");
    return 2;
  }
  if (sizes.empty()) sizes = {1000, 1'000'000};
  return cigsim::benchmarks::run(sizes);
}
