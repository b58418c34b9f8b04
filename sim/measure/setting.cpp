// SPDX-License-Identifier: MIT
#include "sim/measure/setting.hpp"

#include <algorithm>
#include <utility>

#include "sim/rtl/library.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

Json formats_json(const WordFormats& formats) {
  return {{"coordinate_bits", formats.coordinate_bits},
          {"direction_fraction", formats.direction_fraction},
          {"quotient_fraction", formats.quotient_fraction},
          {"raster_fraction", formats.raster_fraction}};
}

}  // namespace

Json setting_json(const Setting& setting) {
  const MachineOptions& m = setting.machine;
  const bool words = m.number == NumberType::kMachine;
  return {{"level", setting.levels.text()},
          {"number", name_of(m.number)},
          {"detail", m.detail == 0 ? Json("most") : Json(m.detail)},
          {"raster", {m.raster.width, m.raster.height}},
          {"priority", name_of(m.priority)},
          {"resolver", name_of(m.resolver)},
          {"retrieval", words ? Json() : Json(m.retrieval)},
          {"coherence", words ? Json() : Json(m.coherence)},
          {"machine", words ? Json(m.description.name) : Json()},
          {"overload", words ? Json(name_of(m.overload)) : Json()},
          {"formats", words ? formats_json(m.description.formats) : Json()}};
}

Setting at_level(const Setting& setting, Level level) {
  Setting result = setting;
  result.levels = LevelChoice::parse(std::string(name_of(level)));
  result.name = name_of(level);
  return result;
}

bool has_choices(const Database& database) {
  return std::any_of(
      database.systems.begin(), database.systems.end(),
      [](const PreparedSystem& system) { return !system.hierarchy.choices.empty(); });
}

std::map<Stage, std::filesystem::path> rtl_libraries(const Setting& setting,
                                                     const Database& database) {
  std::map<Stage, std::filesystem::path> found;
  for (const Stage stage : kAllStages)
    if (setting.levels[stage] == Level::kRtl)
      found[stage] =
          rtl_library(rtl_variant(stage, RtlNeeds::of(database), setting.machine.description),
                      say_on_stderr)
              .file;
  return found;
}

PipelineOptions pipeline_options(const Setting& setting,
                                 std::map<Stage, std::filesystem::path> libraries) {
  PipelineOptions options;
  options.description = setting.machine.description;
  options.overload = setting.machine.overload;
  options.eye_reach = setting.machine.eye_reach;
  options.detail = setting.machine.detail;
  options.levels = setting.levels;
  options.libraries = std::move(libraries);
  return options;
}

}  // namespace cigsim
