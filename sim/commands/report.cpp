// SPDX-License-Identifier: MIT
// cigsim report: a run or an experiment as one page of HTML.
#include "sim/report/report.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/progress.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

constexpr std::uint64_t kMostFrames = 1000;

struct Options {
  std::string folder;
  std::optional<std::string> file;
  std::size_t frames = 12;
  bool no_difference = false, json = false;
};

void print(const Report& report, const std::string& file) {
  if (report.frames_of > 0)
    fmt::print("Run         {} of {} frames\n", report.frames, report.frames_of);
  if (report.experiments + report.drawings > 0)
    fmt::print("Experiments {}, with {} drawing{}\n", report.experiments, report.drawings,
               report.drawings == 1 ? "" : "s");
  for (const std::string& note : report.notes) fmt::print("Note        {}\n", note);
  fmt::print("Page        {}, {:.1f} MB\n", file, static_cast<double>(report.bytes) * 1e-6);
}

int report_command(const Options& options) {
  Progress progress("reporting");
  ReportOptions report;
  report.folder = options.folder;
  report.file = options.file ? std::filesystem::path(*options.file)
                             : std::filesystem::path(options.folder) / "report.html";
  report.run.frames = options.frames;
  report.run.difference = !options.no_difference;
  report.run.progress = [&](double share) { progress.show(share); };
  const Report made = write_report(report);
  const std::string file = report.file.string();
  if (options.json)
    fmt::print("{}\n", dump({{"page", file},
                             {"bytes", made.bytes},
                             {"frames", made.frames},
                             {"frames_of_run", made.frames_of},
                             {"experiments", made.experiments},
                             {"drawings", made.drawings},
                             {"notes", made.notes}}));
  else
    print(made, file);
  return 0;
}

}  // namespace

void add_report(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("report", "A run or an experiment as one page of HTML");
  command->footer(
      "DIR is what cigsim run, tradeoff, stability or experiment has written with --out DIR. The\n"
      "page needs no network and no other file. Of a run it holds pictures and how they differ\n"
      "from the exact ones, times of the stages, crossings by line, and what pierces the element\n"
      "that is clicked; for these the scene is read and the frames are computed again.\n"
      "\nExamples:\n"
      "  cigsim report out                               writes out/report.html\n"
      "  cigsim report out -o approach.html --frames 30  more frames in the page\n"
      "  cigsim report levine                            of cigsim experiment levine --out "
      "levine\n");
  command->add_option("DIR", options->folder, "Folder of a run or an experiment")
      ->required()
      ->type_name("");
  command
      ->add_option_function<std::string>(
          "-o,--output",
          [options](const std::string& text) {
            check_ending("-o", text, {"html", "htm"});
            options->file = text;
          },
          "The page. Default: DIR/report.html")
      ->type_name("FILE.html");
  command
      ->add_option_function<std::string>(
          "--frames",
          [options](const std::string& text) {
            options->frames = parse_whole("--frames", text, 1, kMostFrames);
          },
          "So many frames at most, spread over the run. Default: 12")
      ->type_name("N");
  command->add_flag("--no-difference", options->no_difference,
                    "Do not compare with exact pictures, which take long to compute");
  command->add_flag("--json", options->json, "Print what was written as JSON");
  command->callback([options, &exit_code] { exit_code = report_command(*options); });
}

}  // namespace cigsim
