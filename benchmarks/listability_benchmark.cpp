// SPDX-License-Identifier: MIT
// How long the separation program and the proof of listability take: see docs/performance.md.
#include <benchmark/benchmark.h>

#include "models/database/separation_planes/published.hpp"
#include "models/database/separation_planes/separate.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/random.hpp"

namespace cigsim {
namespace {

using listability::PriorityTable;

StumpDeck city(std::int64_t boxes) {
  GenerateOptions options;
  options.objects = static_cast<std::uint32_t>(boxes);
  StumpDeck deck;
  deck.objects = generate_environment("city", options).objects;
  return deck;
}

PriorityTable table_of(const separation_planes::SeparationResult& result) {
  PriorityTable table;
  table.members = static_cast<std::uint32_t>(result.bodies.size());
  for (const separation_planes::ResultPlane& plane : result.planes) {
    for (const auto& [t, f] : plane.pairs)
      table.pairs.push_back({static_cast<std::uint32_t>(table.planes.size()), t - 1, f - 1});
    table.planes.push_back(plane.plane);
  }
  return table;
}

// 64 members, 63 planes; every pair on a plane at random. `upright`: all planes contain the
// vertical, so that any three normals depend on each other.
PriorityTable random_table(bool upright) {
  Random random(1);
  PriorityTable table;
  table.members = 64;
  for (int p = 0; p < 63; ++p)
    table.planes.push_back(plane_with_normal(
        {random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)},
        {random.between(-1, 1), random.between(-1, 1), upright ? 0 : random.between(-1, 1)}));
  for (std::uint32_t a = 0; a < 64; ++a)
    for (std::uint32_t b = 0; b < a; ++b) table.pairs.push_back({random.below(63), a, b});
  return table;
}

void separate_as_published(benchmark::State& state) {
  const StumpDeck deck = city(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(separation_planes::PublishedProgram(deck, "city").run());
  state.counters["planes"] =
      static_cast<double>(separation_planes::PublishedProgram(deck, "city").run().planes.size());
}

void separate_exactly(benchmark::State& state) {
  const StumpDeck deck = city(state.range(0));
  separation_planes::SeparationResult result;
  for (auto _ : state) result = separation_planes::separate(deck);
  state.counters["planes"] = static_cast<double>(result.planes.size());
  state.counters["no_table_below"] = result.least ? result.least->any_table : 0;
}

void prove_divided(benchmark::State& state) {
  const PriorityTable table = table_of(separation_planes::separate(city(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(listability::prove(table));
}

void prove_random(benchmark::State& state) {
  const PriorityTable table = random_table(state.range(0) != 0);
  for (auto _ : state) benchmark::DoNotOptimize(listability::prove(table));
}

void all_cells(benchmark::State& state) {
  const listability::Arrangement eyes(random_table(false).planes);
  std::uint64_t cells = 0;
  for (auto _ : state) {
    cells = 0;
    eyes.for_each_cell([&](std::uint64_t, const listability::CellPath&) { return ++cells > 0; });
  }
  state.counters["cells"] = static_cast<double>(cells);
}

BENCHMARK(separate_as_published)->Arg(8)->Arg(16)->Arg(64)->Unit(benchmark::kMillisecond);
BENCHMARK(separate_exactly)->Arg(8)->Arg(16)->Arg(64)->Unit(benchmark::kMillisecond);
BENCHMARK(prove_divided)->Arg(8)->Arg(16)->Arg(64)->Unit(benchmark::kMillisecond);
BENCHMARK(prove_random)->ArgName("upright")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(all_cells)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cigsim

BENCHMARK_MAIN();
