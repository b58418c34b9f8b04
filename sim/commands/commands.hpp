// SPDX-License-Identifier: MIT
// The subcommands of cigsim, one file each.
#pragma once

#include <CLI/CLI.hpp>

namespace cigsim {

/// Each adds its subcommand. When it is given, it runs while the command line is parsed and leaves
/// the program's exit code in `exit_code`; it throws UsageError and InputError.
void add_run(CLI::App& program, int& exit_code);
void add_prepare(CLI::App& program, int& exit_code);
void add_requirements(CLI::App& program, int& exit_code);
void add_gates(CLI::App& program, int& exit_code);
void add_generate(CLI::App& program, int& exit_code);
void add_levels(CLI::App& program, int& exit_code);
void add_machines(CLI::App& program, int& exit_code);
void add_assemble(CLI::App& program, int& exit_code);
void add_compare(CLI::App& program, int& exit_code);
void add_replay(CLI::App& program, int& exit_code);
void add_hull(CLI::App& program, int& exit_code);
void add_sphere(CLI::App& program, int& exit_code);
void add_compare_algorithms(CLI::App& program, int& exit_code);
void add_sorts(CLI::App& program, int& exit_code);
void add_clip(CLI::App& program, int& exit_code);
void add_hidden_line(CLI::App& program, int& exit_code);
void add_bsp(CLI::App& program, int& exit_code);
void add_separate(CLI::App& program, int& exit_code);
void add_listable(CLI::App& program, int& exit_code);
void add_cards(CLI::App& program, int& exit_code);
void add_experiment(CLI::App& program, int& exit_code);
void add_report(CLI::App& program, int& exit_code);
void add_stability(CLI::App& program, int& exit_code);
void add_tradeoff(CLI::App& program, int& exit_code);
void add_wave_picture(CLI::App& program, int& exit_code);

}  // namespace cigsim
