// SPDX-License-Identifier: MIT
// cigsim experiment: measurements of the sources, repeated, and of this machine.
#include "sim/commands/experiment.hpp"

#include <fmt/format.h>

#include <limits>
#include <memory>

#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"

namespace cigsim {

void add_seed_option(CLI::App& command, std::uint64_t& seed) {
  command
      .add_option_function<std::string>(
          "--seed",
          [&seed](const std::string& text) {
            seed = parse_whole("--seed", text, 0, std::numeric_limits<std::uint64_t>::max());
          },
          "The same options and seed give the same figures, but for times and memory. Default: 1")
      ->type_name("S");
}

void add_experiment(CLI::App& program, int& exit_code) {
  const auto name = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand(
      "experiment", "Measure: what sources published, what economies save, how costs grow");
  command->footer(
      "Examples:\n"
      "  cigsim experiment economies --help               the options of one\n"
      "  cigsim experiment levine --cases 20 --only hull\n");
  add_experiment_levine(*command, exit_code);
  add_experiment_economies(*command, exit_code);
  add_experiment_growth(*command, exit_code);
  // Whatever is no experiment.
  command->add_option("NAME", *name, "The experiment")->type_name("");
  command->callback([command, name] {
    if (!command->get_subcommands().empty()) return;
    std::vector<std::string_view> names;
    for (const CLI::App* experiment : command->get_subcommands({}))
      names.push_back(experiment->get_name());
    fail_on_choice("NAME", *name, names);
  });
}

}  // namespace cigsim
