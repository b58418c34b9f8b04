// SPDX-License-Identifier: MIT
// The experiments of `cigsim experiment`, one file each, and the options that they share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace cigsim {

/// Each adds its subcommand to `experiment`, as those of commands.hpp.
void add_experiment_levine(CLI::App& experiment, int& exit_code);
void add_experiment_economies(CLI::App& experiment, int& exit_code);
void add_experiment_growth(CLI::App& experiment, int& exit_code);

/// --seed S.
void add_seed_option(CLI::App& command, std::uint64_t& seed);

}  // namespace cigsim
