// SPDX-License-Identifier: MIT
#include "models/machine/description.hpp"

#include <stdexcept>

#include "models/machine/description_json.hpp"
#include "models/machine/figures.hpp"
#include "models/machine/presets.hpp"

namespace cigsim {
namespace {

std::string cycles_of(Cycle cycles, const char* what) {
  return std::to_string(cycles) + " cycles a " + what;
}

}  // namespace

const std::vector<std::string>& machine_presets() {
  static const std::vector<std::string> names{"nasa1968", "asupt1975", "unlimited"};
  return names;
}

MachineDescription machine_preset(std::string_view name) {
  std::string known;
  for (const std::string& preset : machine_presets()) {
    const std::string file = preset + ".json";
    if (preset == name) return parse_machine(embedded_text(embedded_presets(), file), file);
    known += (known.empty() ? "" : ", ") + preset;
  }
  throw std::invalid_argument("there is no machine \"" + std::string(name) +
                              "\"; the presets are " + known);
}

std::vector<MachineFigure> machine_figures(const MachineDescription& machine) {
  std::vector<MachineFigure> figures;
  for_each_figure(machine, [&](const FigureKind& kind, const auto& field) {
    const auto at = machine.provenance.find(kind.name);
    figures.push_back({kind.name, kind.unit, static_cast<double>(field),
                       at == machine.provenance.end() ? Provenance{} : at->second});
  });
  return figures;
}

std::string machine_contradiction(const MachineDescription& machine) {
  const Cycle lines = machine.line_cycles * machine.raster.height;
  if (machine.frame_cycles > 0 && lines > machine.frame_cycles)
    return std::to_string(machine.raster.height) + " lines of " +
           std::to_string(machine.line_cycles) + " cycles take " + std::to_string(lines) +
           " cycles, but a frame has " + std::to_string(machine.frame_cycles) +
           "; shorten line_cycles, take fewer lines or lengthen frame_cycles";
  const Cycle elements = machine.line_cycles * static_cast<Cycle>(machine.elements_per_cycle);
  if (machine.line_cycles > 0 && elements < machine.raster.width)
    return "a line of " + std::to_string(machine.line_cycles) + " cycles shows " +
           std::to_string(elements) + " elements at " + std::to_string(machine.elements_per_cycle) +
           " a cycle, but the raster is " + std::to_string(machine.raster.width) +
           " wide; raise elements_per_cycle or line_cycles, or narrow the raster";
  if (machine.frame_cycles > 0 && machine.deadline_margin >= machine.frame_cycles)
    return "a deadline_margin of " + std::to_string(machine.deadline_margin) +
           " cycles leaves nothing of a frame of " + std::to_string(machine.frame_cycles) +
           "; shorten deadline_margin or lengthen frame_cycles";
  return {};
}

std::vector<std::string> machine_notices(const MachineDescription& machine) {
  std::vector<std::string> notices;
  const Cycle words = static_cast<Cycle>(machine.crossing_capacity) + 1;
  if (machine.line_cycles > 0 && machine.crossing_capacity > 0 && words > machine.line_cycles)
    notices.push_back("a line of " + std::to_string(machine.crossing_capacity) +
                      " crossings and its end take " + std::to_string(words) +
                      " cycles, more than " + cycles_of(machine.line_cycles, "line") +
                      "; full lines are shown late");
  return notices;
}

MachineDescription with_raster(const MachineDescription& machine, const Raster& raster) {
  MachineDescription result = machine;
  result.raster = raster;
  const std::string size = std::to_string(raster.width) + " x " + std::to_string(raster.height);
  for (const char* name : {"raster.width", "raster.height"})
    result.provenance[name] = {Standing::kReconstruction,
                               "asked for in place of the machine's own"};
  for_each_figure(result, [&](const FigureKind& kind, const auto& field) {
    const std::string name = kind.name;
    if (name.starts_with("raster.") && !(field >= kind.low && field <= kind.high))
      throw std::invalid_argument("a raster of " + size + " is out of range: lines and elements " +
                                  "must lie between 1 and " +
                                  std::to_string(static_cast<int>(kind.high)));
  });
  const Cycle lines = machine.line_cycles * raster.height;
  if (machine.frame_cycles > 0 && lines > machine.frame_cycles) {
    result.line_cycles = machine.frame_cycles / raster.height;
    result.provenance["line_cycles"] = {Standing::kDerived,
                                        std::to_string(machine.frame_cycles) + " / " +
                                            std::to_string(raster.height) + ", rounded down"};
    if (result.line_cycles == 0)
      throw std::invalid_argument("a raster of " + size + " does not fit the machine " +
                                  machine.name + ": a frame has fewer cycles than lines");
  }
  if (const std::string fault = machine_contradiction(result); !fault.empty())
    throw std::invalid_argument("a raster of " + size + " does not fit the machine " +
                                machine.name + ": " + fault);
  return result;
}

std::string_view name_of(Standing standing) {
  switch (standing) {
    case Standing::kPublished:
      return "published";
    case Standing::kRecalled:
      return "recalled";
    case Standing::kDerived:
      return "derived";
    default:
      return "reconstruction";
  }
}

std::string_view name_of(OverloadPolicy policy) {
  switch (policy) {
    case OverloadPolicy::kDrop:
      return "drop";
    case OverloadPolicy::kCut:
      return "cut";
    default:
      return "extend";
  }
}

}  // namespace cigsim
