// SPDX-License-Identifier: MIT
// cigsim listable: proves a scene's priorities, or shows an eyepoint from which they fail.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "models/database/prepare.hpp"
#include "models/database/separation_planes/separation_scene.hpp"
#include "models/environment/input_error.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/listability_proof.hpp"
#include "sim/scene.hpp"
#include "sim/separation_input.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::optional<std::string> scene;
  std::optional<std::string> eye;
  PreparationChoices preparation;
  bool json = false;
};

// A deck brings no table; the separation program makes one.
LoadedScene load_deck(const Options& options) {
  const SeparationInput input = read_separation_input(*options.scene);
  try {
    const auto result = separation_planes::separate(input.deck);
    const ReadResult scene{separation_planes::with_table(input.scene, result), input.notices};
    return {*options.scene, prepare_scene(scene, *options.scene, options.preparation),
            std::nullopt};
  } catch (const separation_planes::NotApart& reason) {
    throw InputError(*options.scene, 0, reason.what());
  } catch (const separation_planes::NotToBeSplit& reason) {
    throw InputError(*options.scene, 0, reason.what());
  }
}

std::string eye_text(const EyeReport& report, const std::string& eye) {
  std::vector<std::string> sides;
  for (const bool eye_true : report.eye_true) sides.push_back(eye_true ? "TRUE" : "FALSE");
  return fmt::format("From {}: the counts are {} ({}); the planes' sides {}\n", eye,
                     fmt::join(report.counts, " "), report.unique ? "unique" : "NOT UNIQUE",
                     fmt::join(sides, " "));
}

int listable(const Options& options) {
  std::optional<Vec3> eye;
  if (options.eye) eye = parse_vector("--eye", *options.eye);
  const LoadedScene scene = options.scene && is_deck(*options.scene)
                                ? load_deck(options)
                                : load_scene(options.scene, options.preparation);
  const SceneProof proof = prove_scene(
      scene.database,
      options.preparation.contact_tolerance.value_or(PrepareOptions{}.contact_tolerance));
  if (options.json) {
    Json figures = to_json(proof, scene.database);
    figures["scene"] = scene.name;
    if (eye) {
      const EyeReport report = look_from(scene.database, *eye);
      figures["from_eye"] = {{"eye", {eye->x, eye->y, eye->z}},
                             {"counts", report.counts},
                             {"eye_true", report.eye_true},
                             {"unique", report.unique}};
    }
    fmt::print("{}\n", dump(figures));
  } else {
    fmt::print("{}", proof_report(proof, scene.database, scene.name));
    if (eye) fmt::print("{}", eye_text(look_from(scene.database, *eye), *options.eye));
  }
  return proof.listable() ? 0 : 1;
}

}  // namespace

void add_listable(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "listable", "Prove that priorities are unique from every eyepoint, or show where not");
  command->footer(
      "Examples:\n"
      "  cigsim listable scenes/stump-not-listable.json   a table that has no order\n"
      "  cigsim listable scenes/stump-case-3.deck         the table found for a deck\n"
      "  cigsim listable                                  every group of the airfield\n"
      "\nExit code 1: not listable, or an object lies on the wrong side of a plane.\n");
  add_scene_option(*command, options->scene);
  command->add_option("--eye", options->eye, "Tell the counts of the first group from here too")
      ->type_name("X,Y,Z");
  add_preparation_options(*command, options->preparation);
  command->add_flag("--json", options->json, "Print the proof as JSON");
  command->callback([options, &exit_code] { exit_code = listable(*options); });
}

}  // namespace cigsim
