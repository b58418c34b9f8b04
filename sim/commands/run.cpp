// SPDX-License-Identifier: MIT
// cigsim run: the main job.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <numeric>

#include "models/environment/input_error.hpp"
#include "models/environment/write.hpp"
#include "sim/arguments.hpp"
#include "sim/budget/budget_run.hpp"
#include "sim/commands/commands.hpp"
#include "sim/frame_run.hpp"
#include "sim/listability.hpp"
#include "sim/machine_options.hpp"
#include "sim/progress.hpp"
#include "sim/scene.hpp"
#include "sim/stability/envelope_check.hpp"
#include "sim/stability/envelope_table.hpp"
#include "sim/stats.hpp"
#include "sim/timeline_picture.hpp"
#include "sim/view.hpp"
#include "sim/wave/recording.hpp"

namespace cigsim {
namespace {

constexpr std::uint64_t kMostRepeats = 1000000;
constexpr int kBroken = 1;       // exit code: the budget of errors was not kept
constexpr int kSignalled = 128;  // exit code of a program that a signal ended, less the signal

struct Options {
  std::optional<std::string> scene;
  ViewOptions view;
  MachineChoices machine;
  PreparationChoices preparation;
  std::size_t repeat = 1;
  std::string out = "out";
  std::optional<std::string> timeline;
  std::optional<Budget> max_error;
  WaveChoices wave;
  bool json = false;
};

void check_inputs(const Options& options) {
  const std::string figures = (std::filesystem::path(options.out) / "stats.json").string();
  for (const auto& input : {options.scene, options.view.path, options.machine.machine})
    if (input) check_not_input("--out", figures, *input);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder.string(), 0, "cannot make this folder: " + error.message());
  // Figures of an earlier run must not stand beside the pictures of this one.
  std::filesystem::remove(folder / "stats.json", error);
}

// Sums over the run; cycles are those of the slowest picture.
void print_machine(const RunRecord& run) {
  const MachineDescription& machine = run.machine.description;
  fmt::print("Machine   {}, level {}, {:g} ns a cycle\n", machine.name, run.levels.text(),
             machine.clock_ns);
  std::uint64_t overflows = 0, items = 0, faces = 0, lines = 0, late = 0, extended = 0;
  Cycle delay = 0;
  for (const FrameRecord& frame : run.frames) {
    const Overload& o = *frame.stats.overload;
    overflows += std::accumulate(o.overflows.begin(), o.overflows.end(), std::uint64_t{0});
    items += o.dropped_items;
    faces += o.dropped_faces;
    lines += o.overfull_lines;
    late += o.late_lines;
    if (!frame.stats.timing) continue;
    extended += frame.stats.timing->extended > 0;
    delay = std::max(delay, frame.stats.timing->transport_delay());
  }
  if (delay > 0)
    fmt::print("Delay     {} cycles = {:.1f} ms from a viewpoint to its last element (worst)\n",
               delay, static_cast<double>(delay) * machine.clock_ns * 1e-6);
  fmt::print(
      "Overload  {} words saturated; {} items and {} faces dropped; {} lines overfull, {} late\n",
      overflows, items, faces, lines, late);
  if (extended > 0)
    fmt::print("Extended  {} pictures took frames longer than the machine's {} cycles\n", extended,
               machine.frame_cycles);
}

// Sums over the run.
void print_redone(const RunRecord& run) {
  Redone sum;
  for (const FrameRecord& frame : run.frames) {
    const Redone& r = *frame.stats.redone;
    sum.vertices += r.vertices;
    sum.vertices_redone += r.vertices_redone;
    sum.faces += r.faces;
    sum.faces_redone += r.faces_redone;
    sum.crossings += r.crossings;
    sum.crossings_redone += r.crossings_redone;
    sum.exact_tests += r.exact_tests;
  }
  fmt::print(
      "Redone    {} of {} vertices, {} of {} faces, {} of {} crossings and {} side tests exactly: "
      "{:.2g} %\n",
      sum.vertices_redone, sum.vertices, sum.faces_redone, sum.faces, sum.crossings_redone,
      sum.crossings, sum.exact_tests, 100 * sum.share());
}

void print_summary(const RunRecord& run, const std::filesystem::path& folder) {
  const Raster& raster = run.machine.raster;
  std::vector<double> times;
  std::uint64_t faces = 0, crossings = 0, faults = 0, certified = 0;
  for (const FrameRecord& frame : run.frames) {
    times.push_back(frame.stats.host_ms);
    faces = std::max(faces, frame.stats.faces);
    crossings = std::max(crossings, frame.stats.crossings);
    faults += frame.stats.faults;
    certified += frame.stats.certified ? 1 : 0;
  }
  fmt::print("Scene     {}: {} objects, {} ground faces\n", run.scene, run.database->object_count,
             run.database->ground.faces.size());
  fmt::print("Frames    {} of {} at {} x {}, {} numbers{}\n", run.frames.size(), run.frames_wanted,
             raster.width, raster.height, name_of(run.machine.number),
             run.interrupted ? " (interrupted)" : "");
  fmt::print("Frame     {:.2f} ms (median), up to {} faces and {} crossings\n", median(times),
             faces, crossings);
  fmt::print("Decisions {} listability faults, {} of {} frames certified\n", faults, certified,
             run.frames.size());
  if (run.machine.number == NumberType::kCertified) print_redone(run);
  if (run.machine.number == NumberType::kMachine) print_machine(run);
  if (numbers_saturate(*run.database))
    fmt::print("Numbers   65535 in ids-NNNN.pgm stands for that number and all above\n");
  for (const Notice& notice : run.database->report.notices)
    fmt::print("Notice    {} x {}\n", notice.count, notice.what);
  for (const std::string& line : fault_lines(run.frames)) fmt::print("Fault     {}\n", line);
  if (run.frames.empty()) return;
  const auto files = [&](const std::string& first, const std::string& last) {
    return (folder / first).string() + (first == last ? "" : " to " + last);
  };
  fmt::print("Pictures  {}\n", files(run.frames.front().picture, run.frames.back().picture));
  fmt::print("Objects   {}\n", files(run.frames.front().ids, run.frames.back().ids));
  fmt::print("Figures   {}\n", (folder / "stats.json").string());
}

void write_timeline(const RunRecord& run, const std::string& file) {
  std::vector<FrameTiming> timings;
  for (const FrameRecord& frame : run.frames) timings.push_back(*frame.stats.timing);
  if (!timings.empty()) write_file(file, timeline_svg(timings, run.machine.description.clock_ns));
}

// The fastest setting that keeps the budget on these frames takes the place of the knobs.
BudgetOutcome take_budget(const Options& options, const std::vector<FrameView>& views,
                          RunRecord& run) {
  BudgetRequest request{*options.max_error, run.database, views, {}, {}};
  // Rasters that no machine has are free to all others.
  MachineChoices choices = options.machine;
  if (choices.machine || options.max_error->cycles) choices.number = NumberType::kMachine;
  request.range.words = machine_options(choices, options.view.raster);
  request.range.words.eye_reach = eye_reach(views);
  request.range.machine_given = options.machine.machine.has_value();
  request.range.choices = has_choices(*run.database);
  // A few frames say little of the others where floats are known to fail.
  MachineOptions floats;
  floats.number = NumberType::kFloat;
  floats.raster = request.range.words.raster;
  request.range.floats =
      options.max_error->kind == Budget::Kind::kNone ||
      stability::check_envelope(*run.database, floats, views, false, stability::stored_envelopes())
          .inside();
  Progress progress("calibrating");
  request.progress = [&](double share) { progress.show(share); };
  BudgetOutcome outcome = settle_budget(request);
  run.machine = outcome.chosen.machine;
  run.levels = outcome.chosen.levels;
  run.budget = outcome.json;
  return outcome;
}

// Warns where the scene and its viewpoints are more than the numbers can be relied on for.
void check_numbers(const std::vector<FrameView>& views, RunRecord& run) {
  const stability::EnvelopeVerdict verdict = stability::check_envelope(
      *run.database, run.machine, views, !run.levels.functional(), stability::stored_envelopes());
  run.envelope = stability::envelope_verdict_json(verdict);
  if (!verdict.inside())
    fmt::print(stderr, "cigsim: warning: {}\n", stability::envelope_warning(verdict));
}

int run_command(const Options& options) {
  if (options.timeline && options.machine.levels.functional())
    throw UsageError("--timeline: the functional level knows no time; add --level timed");
  check_inputs(options);
  const std::optional<WaveRequest> wave = wave_request(options.wave, options.machine.levels);
  const std::vector<PathRow> path = load_path(options.view);
  PreparationChoices preparation = options.preparation;
  preparation.most_detailed = options.machine.detail == 0;
  const LoadedScene scene = load_scene(options.scene, preparation);
  const std::vector<FrameView> views = frame_views(options.view, path, scene.database);
  RunRecord run;
  run.scene = scene.name;
  run.database = &scene.database;
  run.machine = machine_options(options.machine, options.view.raster);
  run.machine.eye_reach = eye_reach(views);
  run.levels = options.machine.levels;
  run.repeat = options.repeat;
  run.frames_wanted = views.size();
  run.path = options.view.path;
  run.sun = options.preparation.sun;
  run.contact_tolerance = options.preparation.contact_tolerance;
  std::optional<BudgetOutcome> budget;
  if (options.max_error) budget = take_budget(options, views, run);
  check_numbers(views, run);
  make_folder(options.out);
  const int signal = run_frames(views, options.out, wave, run);
  if (options.timeline) write_timeline(run, *options.timeline);
  const std::string stats = dump(stats_json(run)) + "\n";
  write_file(std::filesystem::path(options.out) / "stats.json", stats);
  if (options.json)
    fmt::print("{}", stats);
  else
    print_summary(run, options.out);
  if (budget && !options.json)
    for (const std::string& line : budget->lines) fmt::print("Budget    {}\n", line);
  if (wave && !options.json) fmt::print("{}\n", view_command(*wave));
  if (signal != 0) return kSignalled + signal;
  return !budget || budget->kept ? 0 : kBroken;
}

void add_output_options(CLI::App& command, Options& o) {
  command
      .add_option_function<std::string>(
          "--repeat",
          [&o](const std::string& t) { o.repeat = parse_whole("--repeat", t, 1, kMostRepeats); },
          "Compute each frame N times; stats.json gives the median times")
      ->type_name("N")
      ->group("Output");
  command.add_option("--out", o.out, "Folder for pictures and figures. Default: out")
      ->type_name("DIR")
      ->group("Output");
  command
      .add_option_function<std::string>(
          "--timeline",
          [&o](const std::string& t) {
            check_ending("--timeline", t, {"svg"});
            o.timeline = t;
          },
          "Draw which stage works on which picture when (the first four)")
      ->type_name("FILE.svg")
      ->group("Output");
  command.add_flag("--json", o.json, "Print stats.json instead of the summary")->group("Output");
}

// After the options that it replaces.
void add_budget_option(CLI::App& command, Options& o) {
  CLI::Option* option =
      command
          .add_option_function<std::string>(
              "--max-error",
              [&o](const std::string& t) { o.max_error = parse_budget("--max-error", t); },
              "Instead of levels, numbers and the like: take the fastest setting that keeps this "
              "budget, as measured on a few frames of the run, and check it on others. elements: "
              "share of a frame that shows another object; cycles: share by which a frame's delay "
              "differs from the RTL's; colour: mean difference. none: the fastest; 0: proved exact")
          ->type_name("none|0|elements=S,cycles=S,colour=S")
          ->group("Machine");
  for (const char* knob : {"--level", "--number", "--priority", "--resolver", "--detail",
                           "--retrieval", "--coherence", "--timeline", "--wave"})
    option->excludes(command.get_option(knob));
}

}  // namespace

void add_run(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("run", "Render frames of a scene");
  command->footer(
      "Writes into DIR for each frame a picture (frame-0000.png) and the object number of every\n"
      "element (ids-0000.pgm), and the figures of the run (stats.json).\n"
      "\nExamples:\n"
      "  cigsim run                                      the built-in airfield\n"
      "  cigsim run --path builtin --frames 100          an approach to it\n"
      "  cigsim run city.obj --eye -50,-300,80 --look-at 0,0,0 --raster 640x480\n"
      "  cigsim run --number exact --repeat 5 --out exact\n"
      "  cigsim run --path builtin --max-error elements=0.1%     as fast as that allows\n");
  add_scene_option(*command, options->scene);
  add_view_options(*command, options->view);
  add_preparation_options(*command, options->preparation);
  add_machine_options(*command, options->machine);
  add_output_options(*command, *options);
  add_wave_options(*command, options->wave);
  add_budget_option(*command, *options);
  command->callback([options, &exit_code] { exit_code = run_command(*options); });
}

}  // namespace cigsim
