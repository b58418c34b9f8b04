// SPDX-License-Identifier: MIT
// cigsim generate: seeded scenes.
#include "models/environment/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "models/environment/text_file.hpp"
#include "models/environment/write.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

constexpr std::uint64_t kMostObjects = 10000000;

struct Options {
  std::string kind, output;
  GenerateOptions generate;
  bool json = false;
};

void check(const Options& options) {
  std::vector<std::string_view> names;
  for (const GenerateKind& kind : generate_kinds()) names.push_back(kind.name);
  if (std::find(names.begin(), names.end(), options.kind) == names.end())
    fail_on_choice("KIND", options.kind, names);
  check_ending("-o", options.output, {"json", "cbor", "obj"});
}

int generate(const Options& options) {
  check(options);
  Environment environment = generate_environment(options.kind, options.generate);
  const bool obj = lower_ending(options.output) == "obj";
  if (obj) environment.ground.clear();  // which OBJ cannot hold
  write_environment(environment, options.output);
  std::size_t faces = 0;
  for (const Object& object : environment.objects) faces += object.faces.size();
  if (options.json) {
    const nlohmann::ordered_json figures{{"file", options.output},
                                         {"kind", options.kind},
                                         {"seed", options.generate.seed},
                                         {"objects", environment.objects.size()},
                                         {"faces", faces},
                                         {"ground_faces", environment.ground.size()}};
    fmt::print("{}\n", dump(figures));
  } else {
    fmt::print("{}: {} objects, {} faces, {} ground faces ({}, seed {})\n", options.output,
               environment.objects.size(), faces, environment.ground.size(), options.kind,
               options.generate.seed);
    if (obj) fmt::print("OBJ holds objects alone; ground and view need .json or .cbor\n");
  }
  return 0;
}

std::string footer() {
  std::string text = "Kinds:\n";
  for (const GenerateKind& kind : generate_kinds())
    text += fmt::format("  {:<14}{}\n", kind.name, kind.description);
  return text +
         "\nExamples:\n"
         "  cigsim generate city --objects 500 -o city.json\n"
         "  cigsim run city.json --out pictures\n";
}

}  // namespace

void add_generate(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("generate", "Make a scene of any size from a kind and a seed");
  command->footer(footer());
  command->add_option("KIND", options->kind, "What to make; the kinds are listed below")
      ->required()
      ->type_name("");
  command
      ->add_option_function<std::string>(
          "--objects",
          [options](const std::string& text) {
            options->generate.objects =
                static_cast<std::uint32_t>(parse_whole("--objects", text, 1, kMostObjects));
          },
          "How many objects. Default: " + std::to_string(options->generate.objects))
      ->type_name("N");
  command
      ->add_option_function<std::string>(
          "--seed",
          [options](const std::string& text) {
            options->generate.seed =
                parse_whole("--seed", text, 0, std::numeric_limits<std::uint64_t>::max());
          },
          "The same kind, number and seed give the same scene everywhere. Default: 1")
      ->type_name("S");
  command
      ->add_option("-o,--output", options->output,
                   "The scene file; its ending chooses JSON, CBOR or OBJ")
      ->type_name("FILE")
      ->required();
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command->callback([options, &exit_code] { exit_code = generate(*options); });
}

}  // namespace cigsim
