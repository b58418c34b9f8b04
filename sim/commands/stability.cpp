// SPDX-License-Identifier: MIT
// cigsim stability: the machine's decisions at their extremes, in each number format, against exact
// arithmetic.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>

#include "models/environment/write.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/drawing/gnuplot.hpp"
#include "sim/measure/host.hpp"
#include "sim/progress.hpp"
#include "sim/scene.hpp"
#include "sim/stability/stability_report.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
using stability::Axis;
using stability::Decision;
using stability::Format;

constexpr std::uint64_t kMostTrials = 1'000'000;

struct Options {
  std::optional<std::string> scene, out;
  std::vector<std::string> decisions, formats, axes;
  std::uint64_t seed = 1, trials = 20;
  bool json = false;
};

void make_folder(const std::string& folder) {
  if (!can_plot())
    throw UsageError(
        "--out: heat maps cannot be drawn without gnuplot; install Debian's package gnuplot-nox, "
        "or leave out --out");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw UsageError(fmt::format("--out: {} cannot be made a folder; name another", folder));
}

// Those of `all` that were named, in the order of `all`; all when none was.
template <class T, class NameOf>
std::vector<T> chosen(std::string_view what, const std::vector<T>& all,
                      const std::vector<std::string>& wanted, NameOf name_of) {
  if (wanted.empty()) return all;
  std::vector<std::string_view> names;
  for (const T& each : all) names.push_back(name_of(each));
  for (const std::string& name : wanted)
    if (std::find(names.begin(), names.end(), name) == names.end())
      fail_on_choice(what, name, names);
  std::vector<T> out;
  for (const T& each : all)
    if (std::find(wanted.begin(), wanted.end(), name_of(each)) != wanted.end()) out.push_back(each);
  return out;
}

std::vector<Format> formats_of(const Options& options) {
  if (options.formats.empty()) return stability::usual_formats();
  std::vector<Format> formats;
  for (const std::string& name : options.formats) {
    const Format format = stability::format_named(name);
    if (std::find(formats.begin(), formats.end(), format) == formats.end())
      formats.push_back(format);
  }
  return formats;
}

stability::SweepPlan plan_of(const Options& options) {
  stability::SweepPlan plan;
  plan.decisions = chosen("--decision", stability::decisions(), options.decisions,
                          [](const Decision& d) { return std::string_view(d.name); });
  plan.axes = chosen("--axis", std::vector<Axis>(stability::kAxes.begin(), stability::kAxes.end()),
                     options.axes, [](Axis axis) { return stability::name_of(axis); });
  plan.formats = formats_of(options);
  plan.seed = options.seed;
  plan.trials = static_cast<std::uint32_t>(options.trials);
  return plan;
}

stability::Material material_of(const Options& options, std::string& name) {
  if (!options.scene) return {};
  const LoadedScene scene = load_scene(*options.scene, {});
  name = scene.name;
  stability::Material material = stability::material_of(scene.database);
  if (material.triangles.empty())
    throw UsageError(fmt::format("SCENE: {} has no face that stands still", *options.scene));
  return material;
}

int run(const Options& options) {
  stability::SweepPlan plan = plan_of(options);
  std::string scene;
  const stability::Material material = material_of(options, scene);
  if (options.out) make_folder(*options.out);
  Progress progress("decisions");
  plan.progress = [&](double share) { progress.show(share); };
  const stability::Sweep sweep = stability::sweep(plan, material);

  Json json{{"experiment", "stability"},
            {"seed", options.seed},
            {"versions", versions_json()},
            {"host", host_json()},
            {"scene", options.scene ? Json(scene) : Json()}};
  json.update(stability::sweep_json(plan, sweep));
  std::vector<std::filesystem::path> files;
  if (options.out) {
    files = stability::write_sweep_maps(plan, sweep, *options.out);
    files.push_back(std::filesystem::path(*options.out) / "stability.json");
    write_file(files.back(), dump(json) + "\n");
  }
  if (options.json) {
    fmt::print("{}\n", dump(json));
    return 0;
  }
  fmt::print("{}", stability::sweep_text(plan, sweep));
  for (const std::filesystem::path& file : files) fmt::print("{} written\n", file.string());
  return 0;
}

void add_choices(CLI::App& command, Options& options) {
  command
      .add_option("--decision", options.decisions,
                  "Only this decision (may be given several times): convexity, hull, sphere, "
                  "retrieval, side, listability, facing, hither, pyramid, projection, edge, "
                  "crossing-order")
      ->type_name("NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      .add_option("--format", options.formats,
                  "Only this format (may be given several times): float, double, certified, exact, "
                  "machine, a machine's preset or file, or words of these widths: machine:C,D,Q,R "
                  "for coordinate bits and the fraction bits of directions, quotients and raster "
                  "places. Default: the first five, and nasa1968")
      ->type_name("NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      .add_option("--axis", options.axes,
                  "Only along this axis (may be given several times): scale, offset, near, "
                  "parallel, sliver, edge-on, fov, distance, mixed")
      ->type_name("NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace

void add_stability(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "stability", "Drive the machine's decisions to their extremes, in every number format");
  command->footer(
      "Each decision is put to the machine's own code and judged in rational arithmetic.\n"
      "\nExamples:\n"
      "  cigsim stability --out stability                 all of it, with heat maps\n"
      "  cigsim stability airfield.json --format float    a scene's own planes and faces\n"
      "  cigsim stability --decision side --format machine:24,22,16,12 --json\n");
  command
      ->add_option("SCENE", options->scene,
                   "Scene file or prepared database, whose faces, planes, bodies and eyepoint are "
                   "then taken. Default: things at random")
      ->type_name("");
  add_choices(*command, *options);
  command
      ->add_option_function<std::string>(
          "--seed",
          [options](const std::string& text) {
            options->seed =
                parse_whole("--seed", text, 0, std::numeric_limits<std::uint64_t>::max());
          },
          "Other instances for another seed. Default: 1")
      ->type_name("S");
  command
      ->add_option_function<std::string>(
          "--trials",
          [options](const std::string& text) {
            options->trials = parse_whole("--trials", text, 1, kMostTrials);
          },
          "Instances of each decision at each value. Default: 20")
      ->type_name("N");
  command->add_option("--out", options->out, "Write stability.json and heat maps into this folder")
      ->type_name("DIR");
  command->add_flag("--json", options->json, "Print everything as JSON");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace cigsim
