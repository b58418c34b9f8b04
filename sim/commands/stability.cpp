// SPDX-License-Identifier: MIT
// cigsim stability: the machine's decisions at their extremes, in each number format, against exact
// arithmetic.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/commands/experiment.hpp"
#include "sim/commands/experiment_folder.hpp"
#include "sim/measure/host.hpp"
#include "sim/progress.hpp"
#include "sim/scene.hpp"
#include "sim/stability/parts.hpp"
#include "sim/stability/stability_report.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
using stability::Axis;
using stability::Decision;
using stability::Format;

constexpr std::uint64_t kMostTrials = 1'000'000, kTrials = 20;

struct Options {
  std::optional<std::string> scene, out;
  std::vector<std::string> decisions, formats, axes, parts;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> trials;
  bool search_envelope = false, json = false;
};

struct Part {
  std::string_view name;
  stability::PartResult (*measure)(const stability::PartOptions&);  ///< null: the decisions
  stability::WhyNot (*why_not)(const Format&, bool search);         ///< null: of all formats
};

constexpr std::string_view kDecisions = "decisions", kEnvelope = "envelope";

// In the order in which they are told.
const std::vector<Part>& all_parts() {
  using namespace stability;
  static const std::vector<Part> parts{{kDecisions, nullptr, nullptr},
                                       {kEnvelope, envelope_part, why_no_envelope},
                                       {"flicker", flicker_part, why_no_flicker},
                                       {"accumulation", accumulation_part, why_no_accumulation},
                                       {"published", published_part, why_no_published}};
  return parts;
}

// What the program found, one part after the other.
struct Found {
  Json json;
  std::string text;
  std::vector<Sheet> sheets;
};

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

// Those asked for, each once.
std::vector<Format> formats_of(const Options& options) {
  std::vector<Format> formats;
  for (const std::string& name : options.formats) {
    const Format format = stability::format_named(name);
    if (std::find(formats.begin(), formats.end(), format) == formats.end())
      formats.push_back(format);
  }
  return formats;
}

stability::SweepPlan plan_of(const Options& options, const std::vector<Format>& asked) {
  stability::SweepPlan plan;
  plan.decisions = chosen("--decision", stability::decisions(), options.decisions,
                          [](const Decision& d) { return std::string_view(d.name); });
  plan.axes = chosen("--axis", std::vector<Axis>(stability::kAxes.begin(), stability::kAxes.end()),
                     options.axes, [](Axis axis) { return stability::name_of(axis); });
  plan.formats = asked.empty() ? stability::usual_formats() : asked;
  plan.seed = options.seed;
  plan.trials = static_cast<std::uint32_t>(options.trials.value_or(kTrials));
  return plan;
}

stability::Material material_of(const Options& options, std::string& name) {
  if (!options.scene) return {};
  const LoadedScene scene = load_scene(*options.scene, {});
  name = scene.name;
  stability::Material material = stability::material_of(scene.database);
  if (material.triangles.empty())
    throw UsageError(fmt::format("SCENE: {} has no face that stands still", *options.scene));
  const double reach = stability::reach_of(material);
  if (!(reach <= stability::kMostReach))
    throw UsageError(fmt::format(
        "SCENE: {} has a coordinate of {:g}, and {:g} is the most that can be scaled to extremes; "
        "take a larger unit",
        *options.scene, reach, stability::kMostReach));
  return material;
}

// All of them, or with a scene, a decision or an axis the decisions alone, which only these choose.
std::vector<Part> parts_of(const Options& options) {
  const bool chosen_decisions =
      options.scene || !options.decisions.empty() || !options.axes.empty();
  std::vector<std::string> wanted = options.parts;
  if (wanted.empty() && chosen_decisions) wanted = {std::string(kDecisions)};
  if (wanted.empty() && options.search_envelope) wanted = {std::string(kEnvelope)};
  std::vector<Part> parts =
      chosen("--part", all_parts(), wanted, [](const Part& part) { return part.name; });
  const auto has = [&](std::string_view name) {
    return std::any_of(parts.begin(), parts.end(), [&](const Part& p) { return p.name == name; });
  };
  if (options.trials && !has(kDecisions))
    throw UsageError("--trials: is of the decisions; leave it out, or add --part decisions");
  if (chosen_decisions && !has(kDecisions))
    throw UsageError(
        "--part: SCENE, --decision and --axis choose decisions; leave them out, or add --part "
        "decisions");
  if (options.search_envelope && !has(kEnvelope))
    throw UsageError("--envelope: is not among the parts that were asked for; add --part envelope");
  return parts;
}

// A part that was asked for, with those of the formats asked for that it tells something of.
struct Task {
  Part part;
  std::vector<Format> formats;
};

// What was asked for and cannot be told goes to `left_out`, but a part that was named and tells of
// nothing that was asked for is refused.
std::vector<Task> tasks_of(const Options& options, const std::vector<Format>& asked,
                           std::vector<std::string>& left_out) {
  const auto is_named = [&](const Part& part) {
    return (part.name == kEnvelope && options.search_envelope) ||
           std::find(options.parts.begin(), options.parts.end(), part.name) != options.parts.end();
  };
  std::vector<Task> tasks;
  for (const Part& part : parts_of(options)) {
    Task task{part, {}};
    for (const Format& format : asked) {
      const stability::WhyNot why =
          part.why_not ? part.why_not(format, options.search_envelope) : stability::WhyNot();
      if (why)
        left_out.push_back(fmt::format("{} of {}: {}", part.name, format.name, *why));
      else
        task.formats.push_back(format);
    }
    const bool nothing = !asked.empty() && task.formats.empty();
    if (nothing && is_named(part)) throw UsageError("--format: no " + left_out.back());
    if (!nothing) tasks.push_back(std::move(task));
  }
  return tasks;
}

// A decision that is driven along none of the axes would be told as never wrong.
void check_axes(const stability::SweepPlan& plan) {
  for (const Decision& decision : plan.decisions) {
    if (std::any_of(plan.axes.begin(), plan.axes.end(), [&](Axis axis) {
          return std::find(decision.axes.begin(), decision.axes.end(), axis) != decision.axes.end();
        }))
      continue;
    std::string axes;
    for (const Axis axis : decision.axes)
      axes += fmt::format("{}{}", axes.empty() ? "" : ", ", stability::name_of(axis));
    throw UsageError(
        fmt::format("--axis: {} is not driven along it; it has {}", decision.name, axes));
  }
}

void find_decisions(const stability::SweepPlan& plan, const stability::Material& material,
                    Found& found) {
  const stability::Sweep sweep = stability::sweep(plan, material);
  found.json.update(stability::sweep_json(plan, sweep));
  found.text += stability::sweep_text(plan, sweep);
  for (Sheet& map : stability::sweep_maps(plan, sweep)) found.sheets.push_back(std::move(map));
}

void find_part(const Part& part, const stability::PartOptions& options, Found& found) {
  stability::PartResult result = part.measure(options);
  found.json[result.name] = std::move(result.json);
  if (!found.text.empty()) found.text += "\n";
  found.text += result.text;
  found.sheets.push_back(std::move(result.sheet));
}

Found find(const stability::SweepPlan& plan, const std::vector<Task>& tasks,
           const stability::Material& material, const Options& options) {
  Found found;
  for (const Task& task : tasks) {
    Progress progress{std::string(task.part.name)};
    const auto show = [&](double share) { progress.show(share); };
    if (task.part.measure == nullptr) {
      stability::SweepPlan told = plan;
      told.progress = show;
      find_decisions(told, material, found);
    } else {
      find_part(task.part, {options.seed, task.formats, options.search_envelope, show}, found);
    }
  }
  return found;
}

int run(const Options& options) {
  const std::vector<Format> asked = formats_of(options);
  const stability::SweepPlan plan = plan_of(options, asked);
  std::vector<std::string> left_out;
  const std::vector<Task> tasks = tasks_of(options, asked, left_out);
  if (!options.decisions.empty()) check_axes(plan);
  std::string scene;
  const stability::Material material = material_of(options, scene);
  ExperimentFolder folder(options.out, "stability");
  const Found found = find(plan, tasks, material, options);
  Json json{{"experiment", "stability"},
            {"seed", options.seed},
            {"versions", versions_json()},
            {"host", host_json()},
            {"scene", options.scene ? Json(scene) : Json()},
            {"left_out", left_out}};
  json.update(found.json);
  folder.write(json, found.sheets);
  if (options.json) {
    fmt::print("{}\n", dump(json));
  } else {
    fmt::print("{}", found.text);
    for (const std::string& what : left_out) fmt::print("Left out: {}\n", what);
  }
  folder.tell(options.json);
  return 0;
}

void add_choices(CLI::App& command, Options& options) {
  command
      .add_option(
          "--part", options.parts,
          "Only this part (may be given several times): decisions; envelope, the limits within "
          "which each format is right; flicker on paths of the "
          "smallest steps; accumulation of slopes over thousands of lines; published, the "
          "thresholds of Stump's program. Default: all, or the decisions alone with SCENE, "
          "--decision or --axis")
      ->type_name("NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_flag("--envelope", options.search_envelope,
                   "Search the envelope anew, in some minutes, instead of telling the one that the "
                   "program carries; alone, this part only");
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
                  "places. Default: the first five, and nasa1968. What a part cannot tell of a "
                  "format is left out, with the reason")
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
  add_seed_option(*command, options->seed);
  command
      ->add_option_function<std::string>(
          "--trials",
          [options](const std::string& text) {
            options->trials = parse_whole("--trials", text, 1, kMostTrials);
          },
          "Instances of each decision at each value. Default: 20")
      ->type_name("N");
  command
      ->add_option(
          "--out", options->out,
          "Write stability.json, heat maps and plots into this folder, in place of those of an "
          "earlier run")
      ->type_name("DIR");
  command->add_flag("--json", options->json, "Print everything as JSON");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace cigsim
