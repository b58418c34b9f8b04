// SPDX-License-Identifier: MIT
#include "sim/wave/wave_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/arguments.hpp"
#include "sim/wave/wave_file.hpp"

namespace cigsim {
namespace {

constexpr std::uint64_t kMostCycles = 1'000'000'000'000;
constexpr const char* kPacker = "vcd2fst";

CycleWindow parse_window(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
    throw UsageError(fmt::format("--wave-cycles: '{}' must be A:B, two cycles", text));
  const auto cycle = [](const std::string& number) {
    return static_cast<Cycle>(parse_whole("--wave-cycles", number, 0, kMostCycles));
  };
  const CycleWindow window{cycle(text.substr(0, colon)), cycle(text.substr(colon + 1))};
  if (window.last < window.first)
    throw UsageError(fmt::format("--wave-cycles: '{}' must begin before it ends", text));
  return window;
}

std::vector<Stage> stages_with_pins(const LevelChoice& levels) {
  std::vector<Stage> stages;
  std::copy_if(kAllStages.begin(), kAllStages.end(), std::back_inserter(stages),
               [&](Stage stage) { return has_pins(levels[stage]); });
  return stages;
}

}  // namespace

void add_wave_options(CLI::App& command, WaveChoices& choices) {
  CLI::Option* wave =
      command
          .add_option_function<std::string>(
              "--wave",
              [&choices](const std::string& file) {
                check_ending("--wave", file, {"vcd", "fst"});
                choices.file = file;
              },
              "Record the pins and registers of clocked and RTL stages, cycle by cycle, and save "
              "a view of them beside the file")
          ->type_name("FILE.vcd|.fst")
          ->group("Waves");
  command
      .add_option_function<std::string>(
          "--wave-cycles",
          [&choices](const std::string& text) { choices.window = parse_window(text); },
          "Record cycles A to B alone. Default: all")
      ->type_name("A:B")
      ->needs(wave)
      ->group("Waves");
  command
      .add_option_function<std::vector<std::string>>(
          "--wave-scope",
          [&choices](const std::vector<std::string>& names) {
            for (const std::string& name : names)
              choices.scopes.push_back(parse_stage("--wave-scope", name));
          },
          "Record this stage alone; any number of times. Default: all with pins")
      ->type_name("STAGE")
      ->expected(1)
      ->take_all()
      ->needs(wave)
      ->group("Waves");
}

std::optional<WaveRequest> wave_request(const WaveChoices& choices, const LevelChoice& levels) {
  if (!choices.file) return {};
  check_wave_file("--wave", *choices.file, kPacker);
  WaveRequest request{*choices.file, choices.window, stages_with_pins(levels), {}};
  for (const Stage stage : choices.scopes) {
    if (has_pins(levels[stage])) continue;
    if (!exists(stage, Level::kClocked))
      throw UsageError(fmt::format("--wave-scope: {} has no clocked level", name_of(stage)));
    throw UsageError(fmt::format("--wave-scope: {0} is {1} in this run; add --level {0}=clocked",
                                 name_of(stage), name_of(levels[stage])));
  }
  if (request.stages.empty())
    throw UsageError(
        "--wave: no stage is clocked or RTL in this run; add --level clocked, or one stage such as "
        "--level priority_resolver=clocked");
  if (!choices.scopes.empty())
    std::erase_if(request.stages, [&](Stage stage) {
      return std::find(choices.scopes.begin(), choices.scopes.end(), stage) == choices.scopes.end();
    });
  return request;
}

}  // namespace cigsim
