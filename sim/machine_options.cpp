// SPDX-License-Identifier: MIT
#include "sim/machine_options.hpp"

#include <fmt/format.h>

#include "sim/arguments.hpp"

namespace cigsim {
namespace {

constexpr const char* kDefaultMachine = "unlimited";

// Machine words, unless only doubles and their like were asked for.
bool on_machine_words(const MachineChoices& choices) {
  if (choices.number) return *choices.number == NumberType::kMachine;
  return !choices.levels.functional() || choices.machine.has_value();
}

void check(const MachineChoices& choices, bool words) {
  if (!choices.levels.functional() && !words)
    throw UsageError(
        "--number: stages that know time compute on machine words; take --number "
        "machine, or --level functional");
  if (choices.machine && !words)
    throw UsageError("--machine: a machine computes on machine words; take --number machine");
  if (choices.overload && !words)
    throw UsageError("--overload: only a machine has memories to overflow; take --machine");
  if (!words) return;
  if (choices.retrieval)
    throw UsageError(
        "--retrieval: a machine's memories and words hold what is in view; take --number double");
  if (choices.coherence)
    throw UsageError(
        "--coherence: the machine's own priority processor orders every group in every frame; take "
        "--number double");
  if (choices.priority != PriorityMethod::kCounters)
    throw UsageError("--priority: the machine's own priority processor has counters");
  if (choices.resolver.value_or(ResolverMethod::kActiveList) != ResolverMethod::kActiveList)
    throw UsageError("--resolver: the machine's own resolver is the active list");
}

MachineDescription description(const MachineChoices& choices, const std::optional<Raster>& raster) {
  MachineDescription machine = load_machine(choices.machine.value_or(kDefaultMachine));
  if (!raster) return machine;
  try {
    return with_raster(machine, *raster);
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("--raster: {}", error.what()));
  }
}

}  // namespace

MachineOptions machine_options(const MachineChoices& choices, const std::optional<Raster>& raster) {
  const bool words = on_machine_words(choices);
  check(choices, words);
  MachineOptions options;
  options.number = words ? NumberType::kMachine : choices.number.value_or(NumberType::kDouble);
  options.priority = choices.priority;
  options.detail = choices.detail;
  options.retrieval = choices.retrieval.value_or(true);
  options.coherence = choices.coherence.value_or(true);
  options.resolver =
      words ? ResolverMethod::kActiveList : choices.resolver.value_or(ResolverMethod::kAuto);
  options.raster = raster.value_or(options.raster);
  if (!words) return options;
  options.description = description(choices, raster);
  options.raster = options.description.raster;
  options.overload = choices.overload.value_or(options.overload);
  return options;
}

namespace {

double parse_detail(const std::string& text) {
  double scale = 0;
  if (text != "most" && (!to_number(text, scale) || !(scale > 0)))
    throw UsageError(
        fmt::format("--detail: '{}' is neither a number above 0 nor the word most", text));
  return scale;
}

bool parse_switch(const char* option, const std::string& text) {
  return parse_choice<bool>(option, text, {{"on", true}, {"off", false}});
}

// An option of the group of the machine's.
template <class Take>
void add(CLI::App& command, const char* name, const char* form, Take take, const char* help) {
  command.add_option_function<std::string>(name, take, help)->type_name(form)->group("Machine");
}

}  // namespace

void add_description_options(CLI::App& command, MachineChoices& o) {
  using Text = std::string;
  add(
      command, "--machine", "PRESET|FILE", [&o](const Text& t) { o.machine = t; },
      "The machine: nasa1968, asupt1975, unlimited (default where one is needed), or a description "
      "of your own; cigsim machines shows them");
  add(
      command, "--overload", "drop|cut|extend",
      [&o](const Text& t) {
        o.overload = parse_choice<OverloadPolicy>("--overload", t,
                                                  {{"drop", OverloadPolicy::kDrop},
                                                   {"cut", OverloadPolicy::kCut},
                                                   {"extend", OverloadPolicy::kExtend}});
      },
      "When a frame is more than the machine holds: drop what has the lowest priority (default), "
      "cut the rest of the line, or take longer (a reconstruction)");
}

void add_machine_options(CLI::App& command, MachineChoices& o) {
  using Text = std::string;
  add_description_options(command, o);
  add(
      command, "--level", "LEVEL|STAGE=LEVEL,...",
      [&o](const Text& t) { o.levels = LevelChoice::parse(t); },
      "functional (default), timed, clocked, or rtl; or a level for some stages, the others timed. "
      "cigsim levels shows which there are");
  add(
      command, "--number", "float|double|certified|machine|exact",
      [&o](const Text& t) {
        o.number = parse_choice<NumberType>("--number", t,
                                            {{"float", NumberType::kFloat},
                                             {"double", NumberType::kDouble},
                                             {"certified", NumberType::kCertified},
                                             {"machine", NumberType::kMachine},
                                             {"exact", NumberType::kExact}});
      },
      "Numbers to compute with. float: single precision; double: right but for samples on edges "
      "(default); certified: doubles that are certain of every decision or make it again exactly; "
      "machine: the machine's own words (default with --machine, and at the levels that know "
      "time); exact: rationals, without rounding throughout");
  add(
      command, "--priority", "counters|so",
      [&o](const Text& t) {
        o.priority = parse_choice<PriorityMethod>(
            "--priority", t,
            {{"counters", PriorityMethod::kCounters}, {"so", PriorityMethod::kSoMatrix}});
      },
      "Priority from a counter per object (default) or from the separating-object matrix");
  add(
      command, "--resolver", "auto|painter|coverage|active-list",
      [&o](const Text& t) {
        o.resolver = parse_choice<ResolverMethod>("--resolver", t,
                                                  {{"auto", ResolverMethod::kAuto},
                                                   {"painter", ResolverMethod::kPainter},
                                                   {"coverage", ResolverMethod::kCoverage},
                                                   {"active-list", ResolverMethod::kActiveList}});
      },
      "Faces painted from the lowest priority up, spans from a coverage mask, or spans from the "
      "machine's own active list (the only one on machine words); auto (default) takes the cheaper "
      "of the first two");
  add(
      command, "--detail", "SCALE|most", [&o](const Text& t) { o.detail = parse_detail(t); },
      "Multiply the thresholds of levels of detail: 2 shows less detailed descriptions up to twice "
      "their size, 0.5 up to half; most takes the most detailed ones throughout. Default: 1");
  add(
      command, "--retrieval", "on|off",
      [&o](const Text& t) { o.retrieval = parse_switch("--retrieval", t); },
      "Leave out early what is out of view, by spheres against the pyramid of vision (default), or "
      "take everything through the machine; not on machine words");
  add(
      command, "--coherence", "on|off",
      [&o](const Text& t) { o.coherence = parse_switch("--coherence", t); },
      "Keep priorities from frame to frame while the eyepoint crosses no plane (default), or work "
      "them out in every frame; the same pictures. Not on machine words");
}

}  // namespace cigsim
