// SPDX-License-Identifier: MIT
// cigsim replay: a mismatch that cigsim compare found, again.
#include <fmt/format.h>

#include <memory>

#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/cosim/frames.hpp"
#include "sim/cosim/replay_file.hpp"
#include "sim/cosim/report.hpp"
#include "sim/cosim/reproduce.hpp"
#include "sim/stats.hpp"
#include "sim/wave/recording.hpp"
#include "sim/wave/wave_file.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
using namespace cosim;

struct Options {
  std::string file;
  std::optional<std::string> wave;
  bool json = false;
};

int replay_frames(const FrameReplay& replay, const Options& options) {
  FramesOptions run;
  run.say = say_on_stderr;
  if (options.wave) {
    run.after = kCyclesAfter;
    run.wave =
        WaveRequest{*options.wave, window_around(replay.mismatch.cycle), replay.plan.stages,
                    WaveRequest::Spot{replay.mismatch.cycle, replay.plan.description.clock_ns}};
  }
  const FramesResult result = compare_frames({&replay.plan, 1}, run);
  if (options.json) {
    const Json mismatch = result.mismatch ? mismatch_json(*result.mismatch) : Json();
    fmt::print("{}\n", dump({{"mismatch", mismatch}}));
    return result.mismatch ? 1 : 0;
  }
  fmt::print("Replay    {}, {} frames, {} cycles\n", replay.plan.name, replay.plan.frames.size(),
             result.cycles);
  if (result.mismatch)
    for (const std::string& line : mismatch_lines(*result.mismatch)) fmt::print("{}\n", line);
  else
    fmt::print("Result    no mismatch any more; it was: {}, cycle {}: {}\n", replay.mismatch.stage,
               replay.mismatch.cycle, replay.mismatch.field);
  if (run.wave) fmt::print("{}\n", view_command(*run.wave));
  return result.mismatch ? 1 : 0;
}

int replay_so(const SoReplay& replay, const Options& options) {
  if (options.wave)
    throw UsageError("--wave: is for replays of frames; this one is of a row of the SO matrix");
  SoVectorOptions run;
  run.objects = replay.inputs.objects;
  run.planes = replay.inputs.planes;
  const RtlVariant variant = so_engine_variant(run.objects, run.planes);
  const RtlLibrary library = rtl_library(variant, say_on_stderr);
  if (library.variant != variant)
    throw UsageError("a row of the SO matrix is replayed in its own size; install verilator");
  run.library = library.file;
  run.seed = replay.seed;
  run.stuck = replay.stuck;
  const SoVectorResult result = replay_so_case(run, replay.inputs);
  if (options.json) {
    Json mismatch;
    if (result.mismatch) mismatch = {{"summary", summary(*result.mismatch)}};
    fmt::print("{}\n", dump({{"mismatch", mismatch}}));
  } else if (result.mismatch) {
    for (const std::string& line : mismatch_lines(*result.mismatch)) fmt::print("{}\n", line);
  } else {
    fmt::print("Result    no mismatch any more; it was: {}\n", replay.difference);
  }
  return result.mismatch ? 1 : 0;
}

int replay_command(const Options& options) {
  const Replay replay = read_replay(options.file);
  if (const auto* so = std::get_if<SoReplay>(&replay)) return replay_so(*so, options);
  return replay_frames(std::get<FrameReplay>(replay), options);
}

}  // namespace

void add_replay(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("replay", "Run a mismatch that compare found again, with waves");
  command->footer(
      "Exit code 1: the mismatch is still there; 0: it is not.\n"
      "\nExample:\n"
      "  cigsim replay out/mismatch.json --wave mismatch.vcd\n");
  command->add_option("FILE", options->file, "A file that cigsim compare wrote")->required();
  command
      ->add_option_function<std::string>(
          "--wave",
          [options](const std::string& file) {
            check_ending("--wave", file, {"vcd", "fst"});
            check_wave_file("--wave", file, "vcd2fst");
            options->wave = file;
          },
          "Record from shortly before the mismatch to shortly after")
      ->type_name("FILE.vcd|.fst");
  command->add_flag("--json", options->json, "Print what was found as JSON");
  command->callback([options, &exit_code] { exit_code = replay_command(*options); });
}

}  // namespace cigsim
