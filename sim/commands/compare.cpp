// SPDX-License-Identifier: MIT
// cigsim compare: RTL in lock-step with the clocked, timed and functional levels.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "models/environment/input_error.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/cosim/frames.hpp"
#include "sim/cosim/random_plan.hpp"
#include "sim/cosim/replay_file.hpp"
#include "sim/cosim/report.hpp"
#include "sim/cosim/reproduce.hpp"
#include "sim/cosim/so_vectors.hpp"
#include "sim/cosim/stuck_option.hpp"
#include "sim/machine_options.hpp"
#include "sim/program_pipe.hpp"
#include "sim/progress.hpp"
#include "sim/scene.hpp"
#include "sim/stats.hpp"
#include "sim/view.hpp"
#include "sim/wave/recording.hpp"
#include "sim/wave/wave_file.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
using namespace cosim;

constexpr std::uint64_t kMostVectors = 1'000'000'000'000;
constexpr std::uint64_t kVectorsAFrame = 3000;  // about the words of a random frame, thrice
constexpr std::uint64_t kMostRandomFrames = 100'000;
constexpr std::uint32_t kMostEngine = 256;  // objects, and planes
constexpr const char* kDefaultMachine = "asupt1975";

struct Options {
  std::optional<std::string> scene;
  ViewOptions view;
  MachineChoices machine;
  PreparationChoices preparation;
  std::vector<Stage> stages;
  std::uint64_t vectors = 100'000;
  std::optional<RtlVariant> engine;  // none: as the scene needs it
  std::uint32_t seed = 1;
  std::optional<StuckChoice> stuck;
  std::optional<std::string> wave;
  std::string out = "out";
  bool json = false;
};

// What came out, in the order in which it was compared.
struct Outcome {
  std::string scene;
  std::vector<Stage> stages;
  std::vector<RtlVariant> variants;
  std::optional<RtlLibrary> engine;  ///< none: the SO matrix is not compared
  std::size_t scene_frames = 0, random_frames = 0;
  FramesResult frames;
  std::optional<SoVectorResult> vectors;
  std::optional<std::string> replay, wave_command;
  bool reproduced = false;
};

void take_stages(const std::string& text, std::vector<Stage>& stages) {
  std::string_view rest = text;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    more = comma != std::string_view::npos;
    const Stage stage = parse_stage("--stage", rest.substr(0, comma));
    if (!exists(stage, Level::kRtl))
      throw UsageError(
          fmt::format("--stage: {} has no RTL in this version; cigsim levels shows which have",
                      name_of(stage)));
    if (std::find(stages.begin(), stages.end(), stage) == stages.end()) stages.push_back(stage);
    if (more) rest.remove_prefix(comma + 1);
  }
  std::sort(stages.begin(), stages.end());
}

ComparePlan scene_plan(const Options& options) {
  const std::vector<PathRow> path = load_path(options.view);
  LoadedScene scene = load_scene(options.scene, options.preparation);
  const std::vector<FrameView> views = frame_views(options.view, path, scene.database);
  MachineChoices choices = options.machine;
  if (!choices.machine) choices.machine = kDefaultMachine;
  choices.number = NumberType::kMachine;
  const MachineOptions machine = machine_options(choices, options.view.raster);
  ComparePlan plan;
  plan.name = scene.name;
  plan.databases.push_back(std::make_shared<Database>(std::move(scene.database)));
  for (const FrameView& view : views) plan.frames.push_back({0, view});
  plan.description = machine.description;
  plan.overload = machine.overload;
  plan.eye_reach = eye_reach(views);
  plan.stages = options.stages;
  plan.seed = options.seed;
  choose_variants(plan);
  return plan;
}

// The sizes that ship are large enough for random frames.
ComparePlan random_frames(const Options& options, OverloadPolicy policy) {
  const std::uint64_t frames =
      std::clamp<std::uint64_t>(options.vectors / kVectorsAFrame, 1, kMostRandomFrames);
  ComparePlan plan = random_plan(options.seed, policy, frames, options.stages);
  choose_variants(plan);
  for (RtlVariant& variant : plan.variants) variant = shipped_rtl(variant).value_or(variant);
  return plan;
}

bool compares(const Options& options, Stage stage) {
  return std::find(options.stages.begin(), options.stages.end(), stage) != options.stages.end();
}
bool compares_engine(const Options& options) {
  return compares(options, Stage::kPriorityProcessor) && options.vectors > 0;
}

// A fault where nothing is compared would not be found.
void check_stuck_is_compared(const Options& options) {
  if (!options.stuck) return;
  if (const auto* pins = std::get_if<std::pair<Stage, StuckBit>>(&*options.stuck)) {
    if (!compares(options, pins->first))
      throw UsageError(
          fmt::format("--stuck: {} is not compared; add it to --stage", name_of(pins->first)));
  } else if (!compares_engine(options)) {
    throw UsageError(
        "--stuck: so_engine is not compared; add priority_processor to --stage, and --vectors "
        "above 0");
  }
}

std::vector<ComparePlan> plans_of(const Options& options) {
  std::vector<ComparePlan> plans{scene_plan(options)};
  if (options.vectors > 0)
    for (const auto policy : {OverloadPolicy::kDrop, OverloadPolicy::kCut, OverloadPolicy::kExtend})
      plans.push_back(random_frames(options, policy));
  if (options.stuck)
    if (const auto* pins = std::get_if<std::pair<Stage, StuckBit>>(&*options.stuck))
      for (ComparePlan& plan : plans) plan.stuck = *pins;
  for (ComparePlan& plan : plans)
    for (RtlVariant& variant : plan.variants) variant = rtl_library(variant, say_on_stderr).variant;
  return plans;
}

SoVectorOptions engine_options(const Options& options, const RtlLibrary& library) {
  SoVectorOptions engine;
  engine.library = library.file;
  engine.objects = library.variant.parameters[0].value;
  engine.planes = library.variant.parameters[1].value;
  engine.vectors = options.vectors;
  engine.seed = options.seed;
  if (options.stuck)
    if (const auto* bit = std::get_if<SoStuckBit>(&*options.stuck)) engine.stuck = *bit;
  return engine;
}

// A wave of what is wrong, by a replay in a process of its own.
void show_mismatch(const std::filesystem::path& replay, const Mismatch& mismatch,
                   Outcome& outcome) {
  const char* ending = has_program("vcd2fst") ? ".fst" : ".vcd";
  const std::filesystem::path wave = std::filesystem::path(replay).replace_extension(ending);
  Pipe pipe({"/proc/self/exe", "replay", replay.string(), "--wave", wave.string(), "--json"},
            Pipe::End::kReads);
  char line[256];
  while (std::fgets(line, sizeof line, pipe.file()) != nullptr) {
  }
  pipe.finish();
  if (std::filesystem::exists(wave))
    outcome.wave_command = view_command({wave.string(), window_around(mismatch.cycle), {}, {}});
}

bool reproduce_frames(const std::vector<ComparePlan>& plans, const std::filesystem::path& file,
                      Outcome& outcome) {
  const Mismatch& mismatch = *outcome.frames.mismatch;
  // Of a broken contract the plan is not known: the first one that shows it again.
  const bool any = mismatch.stage == kAnyStage;
  bool seen = write_shortest_replay({plans[outcome.frames.plan], mismatch}, file);
  for (std::size_t p = 1; any && !seen && p < plans.size(); ++p)
    seen = write_shortest_replay({plans[p], mismatch}, file);
  if (seen) show_mismatch(file, std::get<FrameReplay>(read_replay(file)).mismatch, outcome);
  return seen;
}

bool reproduce_vector(const Options& options, const std::filesystem::path& file,
                      const Outcome& outcome) {
  const SoMismatch& mismatch = *outcome.vectors->mismatch;
  const SoVectorOptions engine = engine_options(options, *outcome.engine);
  write_replay(SoReplay{mismatch.inputs, options.seed, engine.stuck, summary(mismatch)}, file);
  return replay_so_case(engine, mismatch.inputs).mismatch.has_value();
}

// Where the folder cannot be written, the mismatch is told nevertheless.
void reproduce(const std::vector<ComparePlan>& plans, const Options& options, Outcome& outcome) {
  const std::filesystem::path file = std::filesystem::path(options.out) / "mismatch.json";
  try {
    std::filesystem::create_directories(options.out);
    outcome.reproduced = outcome.frames.mismatch ? reproduce_frames(plans, file, outcome)
                                                 : reproduce_vector(options, file, outcome);
    outcome.replay = file.string();
  } catch (const std::exception& error) {
    say_on_stderr(fmt::format("cigsim: no replay file: {}", error.what()));
  }
}

// The command that shows the stages' RTL at work on the scene.
std::string wave_run(const std::vector<Stage>& stages, const Options& options) {
  std::vector<std::string> levels;
  for (const Stage stage : stages) levels.push_back(fmt::format("{}=rtl", name_of(stage)));
  std::string command = "cigsim run";
  if (options.scene) command += " " + shell_word(*options.scene);
  command += " --machine " + shell_word(options.machine.machine.value_or(kDefaultMachine));
  if (const auto& raster = options.view.raster)
    command += fmt::format(" --raster {}x{}", raster->width, raster->height);
  return command +
         fmt::format(" --level {} --wave rtl.vcd --wave-cycles 0:20000", fmt::join(levels, ","));
}

void print_outcome(const Outcome& o, const Options& options) {
  std::vector<std::string_view> stages;
  for (const Stage stage : o.stages) stages.push_back(name_of(stage));
  fmt::print("Compare   {}: {} in RTL beside clocked, timed and functional\n", o.scene,
             fmt::join(stages, ", "));
  std::vector<std::string> variants;
  for (const RtlVariant& variant : o.variants) variants.push_back(variant.name());
  fmt::print("RTL       {}\n", fmt::join(variants, ", "));
  fmt::print("Frames    {} of the scene, {} random; {} of {} pictures compared, {} elements\n",
             o.scene_frames, o.random_frames, o.frames.pictures, o.frames.frames,
             o.frames.elements);
  fmt::print("Words     {} on the links, in value and cycle\n", o.frames.words);
  std::uint64_t cycles = static_cast<std::uint64_t>(o.frames.cycles);
  double seconds = o.frames.seconds;
  if (o.vectors) {
    fmt::print("Vectors   {} of {}, {} pairs, seed {}\n", o.vectors->vectors,
               o.engine->variant.name(), o.vectors->pairs, options.seed);
    cycles += o.vectors->cycles;
    seconds += o.vectors->seconds;
  }
  fmt::print("Cycles    {} with all output pins compared, in {:.2f} s: {:.0f} kHz\n", cycles,
             seconds, static_cast<double>(cycles) / seconds * 1e-3);
}

void print_result(const Outcome& o, const Options& options) {
  std::vector<std::string> lines;
  if (o.frames.mismatch) lines = mismatch_lines(*o.frames.mismatch);
  if (o.vectors && o.vectors->mismatch) lines = mismatch_lines(*o.vectors->mismatch);
  for (const std::string& line : lines) fmt::print("{}\n", line);
  if (o.replay)
    fmt::print("Replay    cigsim replay {}{}\n", *o.replay,
               o.reproduced ? "" : "   (it was not seen again)");
  fmt::print("Result    {}\n", lines.empty() ? "0 mismatches" : "1 mismatch, the first");
  if (o.wave_command) {
    fmt::print("{}\n", *o.wave_command);
    return;
  }
  fmt::print("{}\n", wave_run(o.stages, options));
}

Json json_of(const Outcome& o) {
  Json json{{"scene", o.scene},
            {"frames", o.frames.frames},
            {"pictures", o.frames.pictures},
            {"elements", o.frames.elements},
            {"words", o.frames.words},
            {"cycles", o.frames.cycles},
            {"seconds", o.frames.seconds}};
  for (const Stage stage : o.stages) json["stages"].push_back(name_of(stage));
  for (const RtlVariant& variant : o.variants) json["rtl"].push_back(variant.name());
  if (o.vectors)
    json["so_matrix"] = {{"vectors", o.vectors->vectors},
                         {"pairs", o.vectors->pairs},
                         {"cycles", o.vectors->cycles},
                         {"seconds", o.vectors->seconds}};
  json["mismatches"] = o.frames.mismatch || (o.vectors && o.vectors->mismatch) ? 1 : 0;
  if (o.frames.mismatch) json["mismatch"] = mismatch_json(*o.frames.mismatch);
  if (o.vectors && o.vectors->mismatch)
    json["mismatch"] = {{"stage", "priority_processor"},
                        {"summary", summary(*o.vectors->mismatch)}};
  if (o.replay) json["replay"] = *o.replay;
  return json;
}

int compare_command(const Options& options) {
  check_stuck_is_compared(options);
  const std::vector<ComparePlan> plans = plans_of(options);
  Outcome outcome;
  outcome.scene = plans.front().name;
  outcome.stages = options.stages;
  outcome.variants = plans.front().variants;
  if (compares_engine(options))
    outcome.engine = rtl_library(
        options.engine.value_or(so_engine_variant(RtlNeeds::of(*plans.front().databases.front()))),
        say_on_stderr);
  if (options.stuck)
    if (const auto* bit = std::get_if<SoStuckBit>(&*options.stuck))
      check_stuck(*bit, outcome.engine->variant.parameters[0].value);
  outcome.scene_frames = plans.front().frames.size();
  for (std::size_t p = 1; p < plans.size(); ++p) outcome.random_frames += plans[p].frames.size();
  {
    Progress progress("comparing");
    FramesOptions run{
        .say = say_on_stderr, .wave = {}, .progress = [&](double share) { progress.show(share); }};
    if (options.wave) run.wave = WaveRequest{*options.wave, {}, options.stages, {}};
    outcome.frames = compare_frames(plans, run);
  }
  if (outcome.engine && !outcome.frames.mismatch) {
    Progress progress("SO matrix");
    SoVectorOptions engine = engine_options(options, *outcome.engine);
    engine.progress = [&](std::uint64_t vectors) {
      progress.show(static_cast<double>(vectors) / static_cast<double>(options.vectors));
      return true;
    };
    outcome.vectors = run_so_vectors(engine);
  }
  const bool equal = !outcome.frames.mismatch && !(outcome.vectors && outcome.vectors->mismatch);
  if (!equal) reproduce(plans, options, outcome);
  if (options.wave && equal)
    outcome.wave_command = view_command({*options.wave, {}, options.stages, {}});
  if (options.json) {
    fmt::print("{}\n", dump(json_of(outcome)));
  } else {
    print_outcome(outcome, options);
    print_result(outcome, options);
  }
  return equal ? 0 : 1;
}

void add_compare_options(CLI::App& command, Options& o) {
  using Text = std::string;
  const auto add = [&](const char* name, const char* form, auto take, const char* help) {
    return command.add_option_function<Text>(name, take, help)
        ->type_name(form)
        ->group("Comparison");
  };
  add(
      "--stage", "STAGE[,STAGE...]", [&o](const Text& t) { take_stages(t, o.stages); },
      "The stages whose RTL is compared: priority_processor, edge_orderer, priority_resolver")
      ->required();
  add(
      "--vectors", "N",
      [&o](const Text& t) { o.vectors = parse_whole("--vectors", t, 0, kMostVectors); },
      "Random vectors after the scene's frames: rows of the SO matrix, and about as many words "
      "through the stages. Default: 100000");
  add(
      "--so-size", "OBJECTSxPLANES",
      [&o](const Text& t) {
        const std::size_t by = std::min(t.find('x'), t.size());
        const auto size = [&](const Text& part) {
          return static_cast<std::uint32_t>(parse_whole("--so-size", part, 2, kMostEngine));
        };
        o.engine =
            so_engine_variant(size(t.substr(0, by)), size(t.substr(std::min(by + 1, t.size()))));
      },
      "Size of the SO matrix for the vectors, at most 256x256. Default: as the scene's groups "
      "need");
  add(
      "--seed", "S",
      [&o](const Text& t) {
        o.seed = static_cast<std::uint32_t>(parse_whole("--seed", t, 1, 0x7fffffff));
      },
      "Of the vectors, and of registers that have no reset. Default: 1");
  add(
      "--stuck", "STAGE.PINS.FIELD:BIT=0|1", [&o](const Text& t) { o.stuck = parse_stuck(t); },
      "A fault on purpose: this bit of the RTL's output pins is stuck, such as "
      "priority_resolver.spans.first:3=1");
  add(
      "--wave", "FILE.vcd|.fst",
      [&o](const Text& t) {
        check_ending("--wave", t, {"vcd", "fst"});
        check_wave_file("--wave", t, "vcd2fst");
        o.wave = t;
      },
      "Record the scene's frames, RTL and clocked twins side by side");
  command.add_option("--out", o.out, "Folder for the replay file and its wave. Default: out")
      ->type_name("DIR")
      ->group("Comparison");
  command.add_flag("--json", o.json, "Print the figures as JSON")->group("Comparison");
}

}  // namespace

void add_compare(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "compare", "Run RTL in lock-step with the models, on a scene and on random vectors");
  command->footer(
      "Every output pin is compared with the clocked level in every cycle, every word with the\n"
      "timed level in value and cycle, every picture with the functional level. At the first\n"
      "difference: a report, a replay file and a wave around it, and exit code 1.\n"
      "\nExamples:\n"
      "  cigsim compare --stage priority_resolver\n"
      "  cigsim compare --stage priority_processor,edge_orderer --path builtin --frames 10\n"
      "  cigsim compare --stage priority_resolver --stuck priority_resolver.spans.first:3=1\n");
  add_scene_option(*command, options->scene);
  add_compare_options(*command, *options);
  add_view_options(*command, options->view);
  add_preparation_options(*command, options->preparation);
  add_description_options(*command, options->machine);
  command->callback([options, &exit_code] { exit_code = compare_command(*options); });
}

}  // namespace cigsim
