// SPDX-License-Identifier: MIT
// cigsim prepare: offline database development.
#include "models/database/prepare.hpp"

#include <fmt/format.h>

#include <memory>

#include "models/database/database_file.hpp"
#include "models/database/database_json.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/machine_options.hpp"
#include "sim/scene.hpp"
#include "sim/stability/envelope_check.hpp"
#include "sim/stability/envelope_table.hpp"
#include "sim/stats.hpp"
#include "sim/view.hpp"

namespace cigsim {
namespace {

struct Options {
  std::vector<std::string> inputs;
  std::string output;
  PreparationChoices preparation;
  bool json = false;
};

void check(const Options& options) {
  check_ending("-o", options.output, {"json", "cbor"});
  for (const std::string& input : options.inputs) {
    check_not_input("-o", options.output, input);
    if (is_database(input))
      throw UsageError(fmt::format("{} is prepared already; give it to cigsim run", input));
  }
}

using Verdicts = std::vector<stability::EnvelopeVerdict>;

// Of the formats that are known to have limits, in the scene's own view.
Verdicts envelope_verdicts(const Database& database) {
  const std::vector<FrameView> views = frame_views({}, {}, database);
  MachineOptions floats;
  floats.number = NumberType::kFloat;
  std::vector<MachineOptions> formats{floats};
  for (const std::string& machine : machine_presets()) {
    MachineChoices choices;
    choices.machine = machine;
    formats.push_back(machine_options(choices, {}));
  }
  Verdicts verdicts;
  for (const MachineOptions& format : formats)
    verdicts.push_back(
        stability::check_envelope(database, format, views, false, stability::stored_envelopes()));
  return verdicts;
}

void print_envelope(const Verdicts& verdicts) {
  for (const stability::EnvelopeVerdict& verdict : verdicts)
    fmt::print("{:<18}{:>12}  {}\n", "envelope", verdict.format,
               verdict.inside()
                   ? "inside, in the scene's own view"
                   : "outside: " + stability::excess_text(verdict.excesses.front(), ""));
}

void print_report(const PreparationReport& report, const Verdicts& verdicts,
                  const std::string& output) {
  const auto row = [](const char* name, std::uint64_t value, const char* meaning) {
    fmt::print("{:<18}{:>12}{}{}\n", name, value, *meaning == '\0' ? "" : "  ", meaning);
  };
  row("objects", report.objects, "");
  row("faces", report.faces, "");
  row("vertices", report.vertices, "");
  row("convex", report.convex_objects, "objects that are convex bodies");
  row("unclosed", report.unclosed_objects, "objects seen from both sides");
  row("items", report.items, "entries of the priority lists");
  row("pieces", report.pieces, "convex objects, and faces of the others, after the cuts");
  row("cuts", report.cuts, "times that a plane cut an item in two");
  row("planes", report.planes, "separation planes");
  row("groups", report.groups, "of the priority hierarchy, up to 64 members each");
  row("depth", report.depth, "planes above the deepest item");
  row("pairs", report.pairs, "TRUE/FALSE pairs over all groups");
  fmt::print("{:<18}{:>12.3f}  seconds\n", "time", report.seconds);
  print_envelope(verdicts);
  for (const Notice& notice : report.notices)
    fmt::print("{:<18}{:>12}  {}\n", "notice", notice.count, notice.what);
  fmt::print("Database in {}; look at it with: cigsim run {}\n", output, output);
}

int prepare_command(const Options& options) {
  check(options);
  std::vector<ReadResult> parts;
  for (const std::string& input : options.inputs) parts.push_back(read_environment(input));
  const Database database =
      prepare_scene(merge(std::move(parts)), options.inputs.front(), options.preparation);
  write_database(database, options.output);
  const Verdicts verdicts = envelope_verdicts(database);
  if (options.json) {
    nlohmann::ordered_json figures = report_to_json(database.report);
    figures["file"] = options.output;
    for (const stability::EnvelopeVerdict& verdict : verdicts)
      figures["envelope"].push_back(stability::envelope_verdict_json(verdict));
    fmt::print("{}\n", dump(figures));
  } else {
    print_report(database.report, verdicts, options.output);
  }
  return 0;
}

}  // namespace

void add_prepare(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("prepare", "Prepare a scene once, so that later runs start at once");
  command->footer(
      "Reads .json, .cbor, .cards, .deck, .obj, .ac, .gltf, .glb, .ply, .stl, .off and .3ds.\n"
      "Several inputs become one environment; objects are numbered in the order of the inputs.\n"
      "\nExamples:\n"
      "  cigsim prepare airport.obj -o airport.cbor\n"
      "  cigsim prepare town.json tower.ac --sun 225,45 -o scene.json\n"
      "  cigsim run scene.json\n");
  command->add_option("INPUT", options->inputs, "Scene files")->required()->type_name("...");
  command
      ->add_option("-o,--output", options->output,
                   "The prepared database; .json can be read by people, .cbor is smaller")
      ->type_name("DB")
      ->required();
  add_preparation_options(*command, options->preparation);
  command->add_flag("--json", options->json, "Print the report as JSON");
  command->callback([options, &exit_code] { exit_code = prepare_command(*options); });
}

}  // namespace cigsim
