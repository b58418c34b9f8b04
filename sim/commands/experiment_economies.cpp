// SPDX-License-Identifier: MIT
// cigsim experiment economies: only what a scene requires, on and off.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>

#include "models/environment/generate.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/experiment.hpp"
#include "sim/commands/experiment_folder.hpp"
#include "sim/experiments/economies_json.hpp"
#include "sim/measure/child.hpp"
#include "sim/progress.hpp"
#include "sim/scene.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

constexpr std::uint32_t kCity = 1000;
constexpr std::uint64_t kRows = 20000, kQuickRows = 512;

struct Options {
  EconomyOptions economies;
  std::vector<std::string> scenes;
  std::optional<std::size_t> frames, rounds;
  std::optional<Raster> raster;
  bool rtl = false, quick = false, json = false;
  std::optional<std::string> out;
};

enum class Flight {
  kSlow,      ///< past the scene's own view
  kApproach,  ///< the built-in airfield's, from its middle on
  kWithin     ///< low through the middle of a city
};

struct Subject {
  std::string name;
  Database database;
  Flight flight = Flight::kSlow;
};

// Of a database nothing is copied, so that economies may point to it.
std::deque<Subject> subjects_of(const Options& options) {
  std::deque<Subject> subjects;
  for (const std::string& file : options.scenes)
    subjects.push_back({file, load_scene(file, {}).database});
  if (!subjects.empty()) return subjects;
  LoadedScene airfield = load_scene({}, {});
  subjects.push_back({airfield.name, std::move(airfield.database), Flight::kApproach});
  subjects.push_back({fmt::format("city of {}", kCity),
                      prepare_scene({generate_environment("city", {kCity, 1}), {}}, "city", {}),
                      Flight::kWithin});
  return subjects;
}

// Frames that follow each other, as far as the path goes; the eye moves as it does in flight.
std::vector<FrameView> approach(const Database& database, std::size_t frames) {
  ViewOptions view;
  view.path = "builtin";
  std::vector<FrameView> views = frame_views(view, load_path(view), database);
  if (views.size() <= frames) return views;
  const auto first = views.begin() + static_cast<std::ptrdiff_t>((views.size() - frames) / 2);
  return {first, first + static_cast<std::ptrdiff_t>(frames)};
}

// Northwards, one unit a frame, at the height of the lower roofs.
std::vector<FrameView> flight_within(const Database& database, std::size_t frames) {
  constexpr double kHeight = 30;
  std::vector<FrameView> views;
  const Vec3 middle = database.systems[0].sphere.centre;
  for (std::size_t f = 0; f < frames; ++f) {
    Viewpoint viewpoint{{}, database.view.fov};
    viewpoint.eye.position = {middle.x, middle.y + static_cast<double>(f), kHeight};
    views.push_back({viewpoint, static_cast<double>(f)});
  }
  return views;
}

std::vector<FrameView> views_of(const Subject& subject, std::size_t frames) {
  if (subject.flight == Flight::kApproach) return approach(subject.database, frames);
  if (subject.flight == Flight::kWithin) return flight_within(subject.database, frames);
  return slow_flight(subject.database, frames);
}

EconomyOptions economy_options(const Options& options) {
  EconomyOptions economies = options.economies;
  if (options.quick) {
    economies.frames = 4;
    economies.rounds = 2;
    economies.raster = {64, 64};
  }
  if (options.frames) economies.frames = *options.frames;
  if (options.rounds) economies.rounds = *options.rounds;
  if (options.raster) economies.raster = *options.raster;
  return economies;
}

EconomyReport measure(const Subject& subject, const Options& options, EconomyOptions economies) {
  Progress progress(subject.name);
  economies.progress = [&](double share, const std::string&) { progress.show(share); };
  const EconomyScene scene{subject.name, &subject.database, views_of(subject, economies.frames)};
  EconomyReport report{run_economies(scene, economies), {}};
  if (options.rtl)
    report.rtl = measure_rtl_size(
        subject.database, options.quick ? kQuickRows : kRows, economies.rounds, economies.seed,
        [](const std::string& line) { fmt::print(stderr, "RTL       {}\n", line); });
  return report;
}

void print(const std::vector<EconomyReport>& reports) {
  for (const EconomyReport& report : reports) fmt::print("{}", economies_text(report));
  fmt::print("Attributes that no scene can ask for here, so that nothing is saved:");
  const char* comma = " ";
  for (const char* attribute : attributes_of_no_machine()) {
    fmt::print("{}{}", comma, attribute);
    comma = ", ";
  }
  fmt::print("\n");
}

int run(const Options& options) {
  const EconomyOptions economies = economy_options(options);
  const std::deque<Subject> subjects = subjects_of(options);
  ExperimentFolder folder(options.out, "economies");
  std::vector<EconomyReport> reports;
  for (const Subject& subject : subjects) reports.push_back(measure(subject, options, economies));
  const nlohmann::ordered_json json = economies_json(reports, economies);
  folder.write(json, {economies_sheet(reports)});
  if (options.json)
    fmt::print("{}\n", dump(json));
  else
    print(reports);
  folder.tell(options.json);
  return std::all_of(reports.begin(), reports.end(),
                     [](const EconomyReport& r) { return r.holds(); })
             ? 0
             : 1;
}

void add_work_options(CLI::App& command, Options& o) {
  command
      .add_option("--scene", o.scenes,
                  "Scene files or prepared databases, each flown past its own view. Default: "
                  "the built-in airfield with its approach, and a generated city")
      ->type_name("FILE...");
  command
      .add_option_function<std::string>(
          "--frames",
          [&o](const std::string& text) {
            o.frames = static_cast<std::size_t>(parse_whole("--frames", text, 1, 100000));
          },
          "Frames of a scene; at levels that know time a tenth of them. Default: 60")
      ->type_name("N");
  command
      .add_option_function<std::string>(
          "--raster", [&o](const std::string& text) { o.raster = parse_raster("--raster", text); },
          "Default: 1024x1024")
      ->type_name("WxH");
  command
      .add_option_function<std::string>(
          "--rounds",
          [&o](const std::string& text) {
            o.rounds = static_cast<std::size_t>(parse_whole("--rounds", text, 1, 1000));
          },
          "Trials of each side, in random order. Default: 5")
      ->type_name("N");
  command.add_flag("--rtl", o.rtl,
                   "Also build the SO engine in RTL, sized to each scene and of 256 x 256: about a "
                   "minute and a half a scene");
  command.add_flag("--quick", o.quick, "Few small frames: a quick look");
}

}  // namespace

void add_experiment_economies(CLI::App& experiment, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = experiment.add_subcommand(
      "economies", "What leaving out saves that a scene does not require, on and off in turns");
  command->footer(
      "Exit code 1 when an economy changes a picture or a cycle that it must not change.\n"
      "\nExamples:\n"
      "  cigsim experiment economies --out economies\n"
      "  cigsim experiment economies --scene scenes/levine-towers.json --rtl\n"
      "  cigsim experiment economies --quick\n");
  add_work_options(*command, *options);
  add_seed_option(*command, options->economies.seed);
  command
      ->add_option("--out", options->out,
                   "Write economies.json and economies.svg into this folder (gnuplot draws it)")
      ->type_name("DIR");
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace cigsim
