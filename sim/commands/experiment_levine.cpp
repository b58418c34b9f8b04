// SPDX-License-Identifier: MIT
// cigsim experiment levine: his measurements, repeated.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>

#include "models/environment/read.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/experiment.hpp"
#include "sim/commands/experiment_folder.hpp"
#include "sim/embedded.hpp"
#include "sim/experiments/levine_json.hpp"
#include "sim/experiments/levine_plots.hpp"
#include "sim/progress.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

enum class Part { kHull, kSphere, kHiddenLine };

struct Options {
  ExperimentOptions experiment;
  std::optional<Part> only;
  std::optional<std::string> out;
  bool json = false;
};

LevineResults measure(const Options& options) {
  LevineResults results;
  results.options = options.experiment;
  const auto wanted = [&](Part part) { return !options.only || *options.only == part; };
  const auto with_bar = [&](const char* label, auto run) {
    Progress progress(label);
    ExperimentOptions experiment = options.experiment;
    experiment.progress = [&](double share) { progress.show(share); };
    return run(experiment);
  };
  if (wanted(Part::kHull)) results.hull = with_bar("hulls", run_hull_experiment);
  if (wanted(Part::kSphere)) results.sphere = with_bar("spheres", run_sphere_experiment);
  if (wanted(Part::kHiddenLine))
    results.hidden_line = with_bar("hidden lines", [](const ExperimentOptions& experiment) {
      const auto city = embedded_text(embedded_scenes(), "levine-city.json");
      return run_hidden_line_experiment(experiment, parse_json(city, "the city").environment);
    });
  return results;
}

void print_hull(const std::vector<HullCurve>& curves) {
  fmt::print("Hull: averages at the most points, and exponents over the last four sizes\n");
  fmt::print("  {:<12}{:>6}", "", "NPTS");
  for (const NamedHullQuantity& q : kHullQuantities) fmt::print("{:>12}{:>7}", q.letters, "x^");
  for (const HullCurve& curve : curves) {
    fmt::print("\n  {:<12}{:>6}", name_of(curve.distribution), curve.sets.back().points);
    for (const NamedHullQuantity& q : kHullQuantities) {
      const std::vector<Vec2> points = averages(curve, q.values);
      fmt::print("{:>12.5g}{:>7.2f}", points.back().y, power_fit(points).exponent);
    }
  }
  fmt::print("\n");
}

void print_sphere(const std::vector<SphereCurve>& curves) {
  fmt::print("Sphere: half of the cases at the most points do not exceed\n");
  fmt::print("  {:<12}{:>6}", "", "NPTS");
  for (const NamedSphereQuantity& q : kSphereQuantities) fmt::print("{:>10}", q.letters);
  fmt::print("{:>10}{:>16}", "given up", "2, 3, 4 points");
  for (const SphereCurve& curve : curves) {
    const SphereDataSet& last = curve.sets.back();
    fmt::print("\n  {:<12}{:>6}", name_of(curve.distribution), last.points);
    for (const NamedSphereQuantity& q : kSphereQuantities) {
      const auto& values = last.*q.values;
      if (values.empty() || !std::isfinite(percentile(values, 0.5)))
        fmt::print("{:>10}", "–");
      else
        fmt::print("{:>10.4g}", percentile(values, 0.5));
    }
    fmt::print("{:>10}{:>16}", last.given_up,
               fmt::format("{}, {}, {}", last.types[2], last.types[3], last.types[4]));
  }
  fmt::print("\n");
}

void print_hidden_line(const std::vector<HiddenLineDataSet>& sets) {
  fmt::print("Hidden lines: averages of a frame over yaw and pitch\n  {:<16}{:>6}", "", "edges");
  for (const NamedCounter& c : kHiddenLineCounters) fmt::print("{:>8}", c.letters);
  fmt::print("{:>8}", "ms");
  for (const HiddenLineDataSet& set : sets) {
    fmt::print("\n  {:<16}{:>6}", set.name, set.edges);
    for (const NamedCounter& c : kHiddenLineCounters) fmt::print("{:>8.1f}", average(set, c.value));
    fmt::print("{:>8.3f}", average_ms(set));
  }
  fmt::print("\n");
}

void print_findings(const LevineResults& results) {
  fmt::print("Published, and ours\n");
  for (const Finding& f : levine_findings(results))
    fmt::print("  {:<60}{:>16}{:>10.3g}  {}\n", f.what, f.published, f.ours,
               f.agrees() ? "agrees" : "differs");
}

void print(const LevineResults& results) {
  fmt::print("Levine 1975, {} cases a data set, seed {}\n", results.options.cases,
             results.options.seed);
  if (!results.hull.empty()) print_hull(results.hull);
  if (!results.sphere.empty()) print_sphere(results.sphere);
  if (!results.hidden_line.empty()) print_hidden_line(results.hidden_line);
  print_findings(results);
}

int run(const Options& options) {
  ExperimentFolder folder(options.out, "levine");
  const LevineResults results = measure(options);
  const nlohmann::ordered_json json = levine_json(results);
  folder.write(json, levine_sheets(results));
  if (options.json)
    fmt::print("{}\n", dump(json));
  else
    print(results);
  folder.tell(options.json);
  return 0;
}

}  // namespace

void add_experiment_levine(CLI::App& experiment, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = experiment.add_subcommand(
      "levine", "Hull, sphere and hidden lines (Levine 1975, app. I to III), beside his figures");
  command->footer(
      "Examples:\n"
      "  cigsim experiment levine --out levine            all of it, in about a minute\n"
      "  cigsim experiment levine --cases 20 --only hull\n");
  command
      ->add_option_function<std::string>(
          "--cases",
          [options](const std::string& text) {
            options->experiment.cases =
                static_cast<std::uint32_t>(parse_whole("--cases", text, 1, 100000));
          },
          "Random cases of each data set. Default: 500, as published")
      ->type_name("N");
  add_seed_option(*command, options->experiment.seed);
  command
      ->add_option_function<std::string>(
          "--only",
          [options](const std::string& text) {
            options->only = parse_choice<Part>("--only", text,
                                               {{"hull", Part::kHull},
                                                {"sphere", Part::kSphere},
                                                {"hidden-line", Part::kHiddenLine}});
          },
          "One part alone")
      ->type_name("hull|sphere|hidden-line");
  command
      ->add_option("--out", options->out,
                   "Write levine.json and the graphs as SVG into this folder (gnuplot draws them)")
      ->type_name("DIR");
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace cigsim
