// SPDX-License-Identifier: MIT
// The cigsim command: its subcommands, and what becomes of their errors.
//
// Exit codes: 0 success, 1 a comparison or check failed, 2 unusable input or wrong usage, with one
// line on standard error.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/commands/help.hpp"
#include "sim/stats.hpp"

namespace {

constexpr int kUnusable = 2;

int fail(std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  fmt::print(stderr, "cigsim: {}\n", message);
  return kUnusable;
}

std::string name_of_given(const CLI::App& program) {
  std::string name = "cigsim";
  for (const CLI::App* app = &program; !app->get_subcommands().empty();) {
    app = app->get_subcommands().front();
    name += " " + app->get_name();
  }
  return name;
}

// What a parse error says, in our words where the parser's do not tell the cause.
std::string cause(const CLI::App& program, const CLI::ParseError& error, int argc, char** argv) {
  if (!program.get_subcommands().empty()) return error.what();
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  const std::string known = fmt::format("choose from {}", fmt::join(names, ", "));
  if (argc < 2) return "a command is missing; " + known;
  return fmt::format("'{}' is no command; {}", argv[1], known);
}

int parse_and_run(CLI::App& program, int argc, char** argv, const int& exit_code) {
  try {
    program.parse(argc, argv);
    return exit_code;
  } catch (const CLI::CallForVersion& request) {
    fmt::print("{}\n", request.what());
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", program.help());
  } catch (const CLI::ParseError& error) {
    return fail(fmt::format("{}; see {} --help", cause(program, error, argc, argv),
                            name_of_given(program)));
  } catch (const cigsim::UsageError& error) {
    return fail(fmt::format("{}; see {} --help", error.what(), name_of_given(program)));
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory; try a smaller scene or raster");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  // A file beyond the allowed size is an error of writing, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App program(
      "Emulator of a Computer Image Generator of the 1970s: a scene goes in, frames come out");
  program.name("cigsim");
  program.set_version_flag("--version", std::string("cigsim ") + cigsim::version());
  program.formatter(std::make_shared<cigsim::HelpFormatter>());
  program.require_subcommand(1);
  program.footer(
      "Start with:\n"
      "  cigsim run                  renders the built-in airfield into the folder out\n"
      "  cigsim COMMAND --help       tells about a command, with examples\n"
      "\nExit code: 0 success, 1 a check failed, 2 unusable input or wrong usage.\n");
  int exit_code = 0;
  cigsim::add_run(program, exit_code);
  cigsim::add_prepare(program, exit_code);
  cigsim::add_requirements(program, exit_code);
  cigsim::add_gates(program, exit_code);
  cigsim::add_generate(program, exit_code);
  cigsim::add_levels(program, exit_code);
  cigsim::add_machines(program, exit_code);
  cigsim::add_assemble(program, exit_code);
  cigsim::add_compare(program, exit_code);
  cigsim::add_replay(program, exit_code);
  cigsim::add_hull(program, exit_code);
  cigsim::add_sphere(program, exit_code);
  cigsim::add_compare_algorithms(program, exit_code);
  cigsim::add_sorts(program, exit_code);
  cigsim::add_clip(program, exit_code);
  cigsim::add_hidden_line(program, exit_code);
  cigsim::add_bsp(program, exit_code);
  cigsim::add_separate(program, exit_code);
  cigsim::add_listable(program, exit_code);
  cigsim::add_cards(program, exit_code);
  cigsim::add_experiment(program, exit_code);
  cigsim::add_report(program, exit_code);
  cigsim::add_stability(program, exit_code);
  cigsim::add_tradeoff(program, exit_code);
  cigsim::add_wave_picture(program, exit_code);
  const int result = parse_and_run(program, argc, argv, exit_code);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    return fail("standard output cannot be written");
  return result;
}
