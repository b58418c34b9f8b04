// SPDX-License-Identifier: MIT
// The SO matrix at 64 objects and 64 planes: the RTL by Verilator alone, the same vectors compared
// with the golden model in every cycle, the golden model alone, and the RTL by Icarus.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <fstream>
#include <sstream>

#include "tests/rtl/icarus/so_stimulus.hpp"

namespace cigsim::benchmarks {
namespace {

using benchmark::Counter;
using cosim::SoVectorOptions;
using priority_processor::SoBits;

constexpr unsigned kSize = 64;

SoVectorOptions options_of(std::uint64_t vectors) {
  return {.library = CIGSIM_RTL_LIBRARIES "/so_engine-Objects=64-Planes=64.so",
          .objects = kSize,
          .planes = kSize,
          .vectors = vectors};
}

void tell(benchmark::State& state, double cycles) {
  state.counters["cycles/s"] = Counter(cycles, Counter::kIsRate);
  state.counters["pairs/s"] = Counter(cycles * kSize, Counter::kIsRate);
}

void run(benchmark::State& state, bool compare) {
  SoVectorOptions options = options_of(300'000);
  options.compare = compare;
  double cycles = 0;
  for (auto _ : state) {
    const cosim::SoVectorResult result = run_so_vectors(options);
    if (result.mismatch) state.SkipWithError("RTL and golden model differ");
    cycles += static_cast<double>(result.cycles);
  }
  tell(state, cycles);
}

void verilator_alone(benchmark::State& state) { run(state, false); }
void verilator_compared(benchmark::State& state) { run(state, true); }

void golden_alone(benchmark::State& state) {
  Random random(1);
  priority_processor::SoGolden golden(kSize, kSize);
  const auto rows = cosim::random_so_rows(random, cosim::SoKind::kThin, kSize, kSize);
  for (unsigned o = 0; o < kSize; ++o) golden.set_row(o, rows[o]);
  SoBits eye{};
  const SoBits all{~std::uint64_t{0}};
  for (auto _ : state) {
    eye[0] = random.bits();
    golden.mark(eye, all);
    for (unsigned l = 0; l < kSize; ++l) benchmark::DoNotOptimize(golden.row(l));
  }
  state.counters["pairs/s"] =
      Counter(static_cast<double>(state.iterations()) * kSize * kSize, Counter::kIsRate);
}

/// Processor time of the programs that this one has started and that ended, in seconds.
double time_of_children() {
  rusage usage;
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// The run alone, without what builds it; reading and writing of the vectors is in it.
void icarus(benchmark::State& state) {
  const auto folder = std::filesystem::temp_directory_path() / "cigsim-so-benchmark";
  std::filesystem::create_directories(folder);
  SoVectorOptions options = options_of(1'500);
  std::ofstream stimulus(folder / "stimulus");
  std::ostringstream expected;
  write_cycles(options, stimulus, expected);
  const std::uint64_t cycles = run_so_vectors(options).cycles;
  stimulus.close();
  build_with_icarus(CIGSIM_SOURCE_DIR, "so_engine_tb", "", folder / "engine.vvp");
  double all_cycles = 0;
  for (auto _ : state) {
    const double before = time_of_children();
    run_with_icarus(folder / "engine.vvp", folder / "stimulus", folder / "outputs");
    state.SetIterationTime(time_of_children() - before);
    all_cycles += static_cast<double>(cycles);
  }
  std::ostringstream outputs;
  outputs << std::ifstream(folder / "outputs").rdbuf();
  if (outputs.str() != expected.str()) state.SkipWithError("Icarus and Verilator differ");
  std::filesystem::remove_all(folder);
  tell(state, all_cycles);
}

BENCHMARK(verilator_alone)->Unit(benchmark::kMillisecond);
BENCHMARK(verilator_compared)->Unit(benchmark::kMillisecond);
BENCHMARK(golden_alone)->Unit(benchmark::kMicrosecond);
BENCHMARK(icarus)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(1);

}  // namespace
}  // namespace cigsim::benchmarks

BENCHMARK_MAIN();
