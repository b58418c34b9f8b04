// SPDX-License-Identifier: MIT
// cigsim separate: Stump's separation program (1986), as published and improved.
#include <fmt/format.h>

#include <memory>

#include "models/database/prepare.hpp"
#include "models/database/separation_planes/separation_scene.hpp"
#include "models/environment/write.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/separation_input.hpp"
#include "sim/separation_text.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using namespace separation_planes;
using Json = nlohmann::ordered_json;

struct Options {
  std::string deck, output;
  bool as_published = false, json = false;
};

constexpr const char* kNotFound = "SEPARATION PLANES COULD NOT BE FOUND.";

// The scene with its table, when it prepares; nothing is written otherwise.
void write_scene(const Options& options, const Environment& scene) {
  if (options.output.empty()) return;
  PrepareOptions check;
  check.file = options.output;
  prepare(scene, check);
  write_environment(scene, options.output);
}

void print(const Options& options, Json figures, const std::string& report) {
  if (options.json) {
    figures["deck"] = options.deck;
    if (!options.output.empty()) figures["file"] = options.output;
    fmt::print("{}\n", dump(figures));
    return;
  }
  fmt::print("{}", report);
  if (!options.output.empty())
    fmt::print(stderr, "Scene with its table in {}; prove it with: cigsim listable {}\n",
               options.output, options.output);
}

int as_published(const Options& options, const SeparationInput& input) {
  check_published_limits(input.deck, options.deck);
  const PublishedTable table = PublishedProgram(input.deck, options.deck).run();
  if (table.found) write_scene(options, with_table(input.scene, table));
  print(options, to_json(table), published_report(table));
  return table.found ? 0 : 1;
}

int not_found(const Options& options, const std::string& why) {
  if (options.json) {
    fmt::print(
        "{}\n",
        dump(Json{{"rule", "exact"}, {"found", false}, {"reason", why}, {"deck", options.deck}}));
  } else {
    fmt::print("{}\n", kNotFound);
    fmt::print(stderr, "cigsim: {}: {}\n", options.deck, why);
  }
  return 1;
}

int improved(const Options& options, const SeparationInput& input) {
  try {
    const SeparationResult result = separate(input.deck);
    write_scene(options, with_table(input.scene, result));
    print(options, to_json(result), separation_report(result));
    return result.proof.listable ? 0 : 1;
  } catch (const NotApart& reason) {
    return not_found(options, reason.what());
  } catch (const NotToBeSplit& reason) {
    return not_found(options, reason.what());
  }
}

int separate_command(const Options& options) {
  if (!options.output.empty()) {
    check_ending("-o", options.output, {"json", "cbor"});
    check_not_input("-o", options.output, options.deck);
  }
  const SeparationInput input = read_separation_input(options.deck);
  for (const Notice& notice : input.notices)
    fmt::print(stderr, "notice: {} {}\n", notice.count, notice.what);
  return options.as_published ? as_published(options, input) : improved(options, input);
}

}  // namespace

void add_separate(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "separate", "Find separation planes between objects, as Stump's program of 1986");
  command->footer(
      "Examples:\n"
      "  cigsim separate scenes/stump-case-2.deck --as-published   his report of test case two\n"
      "  cigsim separate scenes/stump-case-3.deck                  the fewest planes, proved\n"
      "  cigsim separate town.json -o town-table.json              a scene with its table\n"
      "\nExit code 1: no separation planes can be found.\n");
  command->add_option("DECK", options->deck, "A deck of cards (.deck), or another scene file")
      ->required()
      ->type_name("");
  command->add_flag("--as-published", options->as_published,
                    "His rule as it stands, with its tolerance of 0.001, its limits and its report "
                    "line for line");
  command
      ->add_option("-o,--output", options->output,
                   "Write the scene with its table of planes (.json, .cbor)")
      ->type_name("FILE");
  command->add_flag("--json", options->json, "Print the planes and figures as JSON");
  command->callback([options, &exit_code] { exit_code = separate_command(*options); });
}

}  // namespace cigsim
