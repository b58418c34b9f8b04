// SPDX-License-Identifier: MIT
// The experiments of `cigsim experiment`, one file each, and the options that they share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cigsim {

/// Each adds its subcommand to `experiment`, as those of commands.hpp.
void add_experiment_levine(CLI::App& experiment, int& exit_code);
void add_experiment_economies(CLI::App& experiment, int& exit_code);
void add_experiment_growth(CLI::App& experiment, int& exit_code);

/// --seed S.
void add_seed_option(CLI::App& command, std::uint64_t& seed);

/// Makes the folder of --out. Throws UsageError where that is impossible, or gnuplot is missing,
/// which draws what goes into it.
void make_out_folder(const std::string& folder);

/// Removes those of the named files that stand in the folder of --out: what an earlier run of the
/// same command wrote and this one may not write again, so that a folder never mixes two. Throws
/// InputError, naming the file, where that is impossible.
void remove_earlier(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace cigsim
