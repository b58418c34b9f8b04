// SPDX-License-Identifier: MIT
// cigsim levels: which stage exists at which level.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "sim/commands/commands.hpp"
#include "sim/level.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

void print_table() {
  fmt::print("{:<20}", "stage");
  for (const Level level : kAllLevels) fmt::print("{:<12}", name_of(level));
  fmt::print("\n");
  for (const Stage stage : kAllStages) {
    fmt::print("{:<20}", name_of(stage));
    for (const Level level : kAllLevels) fmt::print("{:<12}", exists(stage, level) ? "yes" : "-");
    fmt::print("\n");
  }
}

void print_json() {
  nlohmann::ordered_json table = nlohmann::ordered_json::object();
  for (const Stage stage : kAllStages) {
    nlohmann::ordered_json levels = nlohmann::ordered_json::array();
    for (const Level level : kAllLevels)
      if (exists(stage, level)) levels.push_back(name_of(level));
    table[std::string(name_of(stage))] = std::move(levels);
  }
  fmt::print("{}\n", dump(table));
}

}  // namespace

void add_levels(CLI::App& program, int& exit_code) {
  const auto json = std::make_shared<bool>(false);
  CLI::App* command =
      program.add_subcommand("levels", "Show which stage exists at which level of fidelity");
  command->footer(
      "functional  results without time\n"
      "timed       exact cycles by arithmetic on transactions, without a clock\n"
      "clocked     cycle by cycle, with pins and waves\n"
      "rtl         SystemVerilog\n"
      "\nExamples:\n"
      "  cigsim run --level timed\n"
      "  cigsim run --level geometry_processor=clocked,priority_resolver=clocked\n");
  command->add_flag("--json", *json, "Print JSON instead of the table");
  command->callback([json, &exit_code] {
    if (*json)
      print_json();
    else
      print_table();
    exit_code = 0;
  });
}

}  // namespace cigsim
