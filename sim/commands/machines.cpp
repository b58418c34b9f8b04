// SPDX-License-Identifier: MIT
// cigsim machines: the machines that there are, and every figure of one.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "models/machine/description.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"

namespace cigsim {
namespace {

struct Options {
  std::optional<std::string> machine;
  bool json = false;
};

void print_presets() {
  for (const std::string& name : machine_presets())
    fmt::print("{:<12}{}\n", name, machine_preset(name).title);
}

void print_machine(const MachineDescription& machine) {
  fmt::print("{}: {}\n", machine.name, machine.title);
  for (const MachineFigure& figure : machine_figures(machine))
    fmt::print("  {:<28}{:>12} {:<18}{:<16}{}\n", figure.name, figure.value, figure.unit,
               name_of(figure.provenance.standing), figure.provenance.source);
  if (const Cycle blanking = machine.vertical_blanking(); blanking > 0)
    fmt::print("Of a frame, {} cycles are vertical blanking.\n", blanking);
  for (const std::string& notice : machine_notices(machine)) fmt::print("Notice: {}.\n", notice);
}

int machines(const Options& options) {
  if (!options.machine) {
    if (options.json) throw UsageError("--json needs the name or file of a machine");
    print_presets();
    return 0;
  }
  const MachineDescription machine = load_machine(*options.machine);
  if (options.json)
    fmt::print("{}", machine_json(machine));
  else
    print_machine(machine);
  return 0;
}

}  // namespace

void add_machines(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("machines", "List the machines, or tell all figures of one");
  command->footer(
      "Examples:\n"
      "  cigsim machines                                 the presets\n"
      "  cigsim machines asupt1975                       its figures with standing and source\n"
      "  cigsim machines asupt1975 --json >mine.json     to be edited and passed back\n");
  command->add_option("MACHINE", options->machine, "A preset, or a machine description in JSON")
      ->type_name("");
  command->add_flag("--json", options->json, "Print the description as its JSON file");
  command->callback([options, &exit_code] { exit_code = machines(*options); });
}

}  // namespace cigsim
