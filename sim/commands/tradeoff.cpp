// SPDX-License-Identifier: MIT
// cigsim tradeoff: what each knob costs on a scene, and what it gets wrong.
#include "sim/tradeoff/tradeoff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/commands/experiment_folder.hpp"
#include "sim/machine_options.hpp"
#include "sim/progress.hpp"
#include "sim/scene.hpp"
#include "sim/stats.hpp"
#include "sim/view.hpp"

namespace cigsim {
namespace {

constexpr std::uint64_t kMostRounds = 1000;
constexpr std::size_t kPathFrames = 5;          // of a path, unless --frames tells
constexpr double kMostReferences = 4294967296;  // bytes that the right pictures may take
constexpr double kReferenceBytes = 10;          // an element: colour, number, distance

struct Options {
  std::optional<std::string> scene;
  ViewOptions view;
  PreparationChoices preparation;
  MachineChoices machine;
  std::vector<Level> levels{kAllLevels.begin(), kAllLevels.end()};
  MeasureOptions measure;
  std::optional<std::string> out;
  bool json = false;
};

std::vector<Level> parse_levels(const std::string& text) {
  std::vector<Level> levels;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    levels.push_back(parse_choice<Level>("--levels", text.substr(begin, end - begin),
                                         {{"functional", Level::kFunctional},
                                          {"timed", Level::kTimed},
                                          {"clocked", Level::kClocked},
                                          {"rtl", Level::kRtl}}));
    begin = end + 1;
  }
  return levels;
}

MachineOptions words_of_every_tradeoff(const MachineChoices& words,
                                       const std::optional<Raster>& raster) {
  try {
    return machine_options(words, raster);
  } catch (const UsageError& error) {
    if (words.machine) throw;
    throw UsageError(fmt::format("{}; machine words take part in every trade-off", error.what()));
  }
}

SweepRange range_of(const Options& options, const Database& database,
                    const std::vector<FrameView>& views) {
  MachineChoices words = options.machine;
  words.number = NumberType::kMachine;
  const MachineOptions machine = words_of_every_tradeoff(words, options.view.raster);
  SweepRange range;
  range.raster = machine.raster;
  range.description = machine.description;
  range.overload = machine.overload;
  range.eye_reach = eye_reach(views);
  range.choices = has_choices(database);
  range.levels = options.levels;
  return range;
}

void check_memory(const SweepRange& range, std::size_t frames) {
  const double bytes = kReferenceBytes * static_cast<double>(frames) * range.raster.width *
                       static_cast<double>(range.raster.height);
  if (bytes > kMostReferences)
    throw UsageError(
        fmt::format("--frames: the right pictures of {} frames at {} x {} would take {:.0f} MiB; "
                    "take fewer frames or a smaller raster",
                    frames, range.raster.width, range.raster.height, bytes / 1048576));
}

Tradeoff measure(const Options& options, const LoadedScene& scene,
                 const std::vector<FrameView>& views) {
  const SweepRange range = range_of(options, scene.database, views);
  check_memory(range, views.size());
  Progress progress("measuring");
  TradeoffOptions how{options.measure, {}};
  constexpr double kReferences = 0.1;  // of the work, about
  how.references = [&](double share) { progress.show(kReferences * share); };
  how.measure.progress = [&](double share, const std::string&) {
    progress.show(kReferences + (1 - kReferences) * share);
  };
  Tradeoff result = run_tradeoff(scene.database, views, range, how);
  result.scene = scene.name;
  return result;
}

int tradeoff_command(const Options& options) {
  ViewOptions view = options.view;
  const std::vector<PathRow> path = load_path(view);
  if (!path.empty() && !view.frames) view.frames = std::min(path.size(), kPathFrames);
  const LoadedScene scene = load_scene(options.scene, options.preparation);
  ExperimentFolder folder(options.out, "tradeoff");
  const Tradeoff result = measure(options, scene, frame_views(view, path, scene.database));
  const nlohmann::ordered_json json = tradeoff_json(result);
  folder.write(json, {tradeoff_sheet(result)});
  if (options.json)
    fmt::print("{}\n", dump(json));
  else
    fmt::print("{}", tradeoff_table(result));
  folder.tell(options.json);
  return 0;
}

void add_measure_options(CLI::App& command, Options& o) {
  using Text = std::string;
  const auto add = [&](const char* name, const char* form, auto take, const char* help) {
    command.add_option_function<Text>(name, take, help)->type_name(form)->group("Measuring");
  };
  add(
      "--levels", "LEVEL[,LEVEL...]", [&o](const Text& t) { o.levels = parse_levels(t); },
      "Which of functional, timed, clocked and rtl take part. Default: all; rtl where it can be "
      "built");
  add(
      "--rounds", "R",
      [&o](const Text& t) { o.measure.rounds = parse_whole("--rounds", t, 1, kMostRounds); },
      "How often each setting is measured, all of them in random order each time. Default: 3");
  add(
      "--seed", "S",
      [&o](const Text& t) { o.measure.seed = parse_whole("--seed", t, 0, 0x7fffffff); },
      "Of that order. Default: 1");
  add(
      "--limit", "SECONDS",
      [&o](const Text& t) { o.measure.limit_s = parse_number("--limit", t, 1e-3, 1e6); },
      "A setting whose frames take longer is given up. Default: 300");
  command.add_option("--out", o.out, "Folder for tradeoff.json and the plots tradeoff.svg")
      ->type_name("DIR")
      ->group("Measuring");
  command.add_flag("--json", o.json, "Print the figures as JSON")->group("Measuring");
}

}  // namespace

void add_tradeoff(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("tradeoff", "Measure what each step of accuracy costs on a scene");
  command->footer(
      "Turns one knob at a time (level of each stage, numbers, widths of machine words, levels of\n"
      "detail, raster, priority, resolver, retrieval, coherence), and some together: time, cycles\n"
      "and memory of each, and what it gets wrong in elements, cycles and colour. Each trial is a\n"
      "process of its own; the rounds interleave the settings in random order. Smoothing, and its\n"
      "sub-samples, does not exist in this machine.\n"
      "\nExamples:\n"
      "  cigsim tradeoff --path builtin --out tradeoff         the airfield's approach\n"
      "  cigsim tradeoff city.obj --raster 640x480 --levels functional\n"
      "  cigsim tradeoff --machine asupt1975 --levels timed,clocked,rtl --rounds 5\n");
  add_scene_option(*command, options->scene);
  add_measure_options(*command, *options);
  add_view_options(*command, options->view);
  command->get_option("--frames")
      ->description(fmt::format("How many frames. With a path they are spread evenly along it; "
                                "without one the eye stays and "
                                "moving models move. Default: {} of the path, or 1",
                                kPathFrames));
  command->get_option("--raster")
      ->description(
          "Elements a line and lines, each 1 to 4096: machine words always take part. Default: "
          "1024x1024, or the machine's own");
  add_preparation_options(*command, options->preparation);
  add_description_options(*command, options->machine);
  command->callback([options, &exit_code] { exit_code = tradeoff_command(*options); });
}

}  // namespace cigsim
