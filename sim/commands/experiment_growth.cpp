// SPDX-License-Identifier: MIT
// cigsim experiment growth: cost curves and their exponents.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "sim/arguments.hpp"
#include "sim/commands/experiment.hpp"
#include "sim/commands/experiment_folder.hpp"
#include "sim/experiments/growth_json.hpp"
#include "sim/progress.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

struct Options {
  GrowthOptions growth;
  std::optional<std::string> out;
  bool json = false;
};

// Times of small sizes say nothing of how they grow.
std::string verdict(const GrowthCurve& curve, bool quick) {
  if (curve.fit().points < 2) return "no trend";
  if (curve.as_expected()) return "as expected";
  return quick && curve.timed ? "too small to tell" : "DIFFERS";
}

void print_curve(const GrowthCurve& curve, bool quick) {
  const GrowthPoint &first = curve.points.front(), &last = curve.points.back();
  fmt::print("  {:<26}{:>12.4g}{:>12.4g}{:>12.4g}{:>12.4g}{:>8.2f}{:>14}  {}\n", curve.quantity,
             first.x, first.y.median, last.x, last.y.median, curve.fit().exponent,
             fmt::format("{:.2f} to {:.2f}", curve.expected.low, curve.expected.high),
             verdict(curve, quick));
}

void print(const GrowthResults& results) {
  std::string sweep;
  for (const GrowthCurve& curve : results.curves) {
    if (curve.sweep != sweep)
      fmt::print("{}\n  {:<26}{:>12}{:>12}{:>12}{:>12}{:>8}{:>14}\n", curve.sweep, "", "least",
                 "there", "most", "there", "x^", "expected");
    sweep = curve.sweep;
    print_curve(curve, results.options.quick);
  }
  fmt::print("Floors\n");
  for (const GrowthCurve& curve : results.curves)
    fmt::print("  {:<34}{:<26}{}\n", curve.sweep, curve.quantity, curve.why);
  for (const GrowthCurve& curve : results.curves)
    if (!curve.holds())
      fmt::print("NOT AS EXPECTED, though only counted: {}, {}\n", curve.sweep, curve.quantity);
  if (!results.same_pictures)
    fmt::print("PICTURES DIFFER with the number of objects out of view\n");
}

int run(const Options& options) {
  ExperimentFolder folder(options.out, "growth");
  GrowthResults results;
  {
    Progress progress("growth");
    GrowthOptions growth = options.growth;
    growth.progress = [&](double share, const std::string&) { progress.show(share); };
    results = run_growth(growth);
    results.options = options.growth;
  }
  const nlohmann::ordered_json json = growth_json(results);
  folder.write(json, {growth_sheet(results)});
  if (options.json)
    fmt::print("{}\n", dump(json));
  else
    print(results);
  folder.tell(options.json);
  return results.good() ? 0 : 1;
}

}  // namespace

void add_experiment_growth(CLI::App& experiment, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = experiment.add_subcommand(
      "growth", "What a frame costs against objects, planes, edges and elements, with exponents");
  command->footer(
      "Exponents are fitted through the four largest sizes. Exit code 1 when what is counted, not\n"
      "timed, does not grow as expected, or objects out of view change the picture.\n"
      "\nExamples:\n"
      "  cigsim experiment growth --out growth            up to a million objects: some minutes, 5 "
      "GiB\n"
      "  cigsim experiment growth --objects 100000\n"
      "  cigsim experiment growth --quick\n");
  command
      ->add_option_function<std::string>(
          "--objects",
          [options](const std::string& text) {
            options->growth.most_objects =
                static_cast<std::uint32_t>(parse_whole("--objects", text, 1000, 1000000));
          },
          "Most objects out of view, from 1000; those in view end at a tenth. Default: 1000000")
      ->type_name("N");
  command->add_flag("--quick", options->growth.quick, "Small sizes and few rounds: a quick look")
      ->excludes("--objects");
  add_seed_option(*command, options->growth.seed);
  command
      ->add_option("--out", options->out,
                   "Write growth.json and growth.svg into this folder (gnuplot draws it)")
      ->type_name("DIR");
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace cigsim
