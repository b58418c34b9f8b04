// SPDX-License-Identifier: MIT
#include "sim/level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "sim/arguments.hpp"

namespace cigsim {
namespace {

Level parse_level(std::string_view text) {
  std::vector<std::string_view> names;
  for (const Level level : kAllLevels) {
    if (name_of(level) == text) return level;
    names.push_back(name_of(level));
  }
  fail_on_choice("--level", text, names);
}

bool any_stage_at(Level level) {
  return std::any_of(kAllStages.begin(), kAllStages.end(),
                     [level](Stage stage) { return exists(stage, level); });
}

[[noreturn]] void fail_on_missing(std::string_view what, Level level) {
  throw UsageError(
      fmt::format("--level: {} has no {} level in this version; cigsim levels shows what there is",
                  what, name_of(level)));
}

}  // namespace

std::string_view name_of(Stage stage) {
  switch (stage) {
    case Stage::kFrameCalculator:
      return "frame_calculator";
    case Stage::kPriorityProcessor:
      return "priority_processor";
    case Stage::kGeometryProcessor:
      return "geometry_processor";
    case Stage::kEdgeOrderer:
      return "edge_orderer";
    case Stage::kPriorityResolver:
      return "priority_resolver";
    case Stage::kVideoProcessor:
      break;
  }
  return "video_processor";
}

std::string_view name_of(Level level) {
  switch (level) {
    case Level::kFunctional:
      return "functional";
    case Level::kTimed:
      return "timed";
    case Level::kClocked:
      return "clocked";
    case Level::kRtl:
      break;
  }
  return "rtl";
}

Stage parse_stage(std::string_view what, std::string_view text) {
  std::vector<std::string_view> names;
  for (const Stage stage : kAllStages) {
    if (name_of(stage) == text) return stage;
    names.push_back(name_of(stage));
  }
  fail_on_choice(what, text, names);
}

bool exists(Stage stage, Level level) {
  switch (level) {
    case Level::kFunctional:
    case Level::kTimed:
      return true;
    case Level::kClocked:
      return stage != Stage::kFrameCalculator;
    case Level::kRtl:
      return stage == Stage::kPriorityProcessor || stage == Stage::kEdgeOrderer ||
             stage == Stage::kPriorityResolver;
  }
  return false;
}

LevelChoice LevelChoice::parse(const std::string& text) {
  LevelChoice choice;
  if (text.find('=') == std::string::npos) {
    const Level level = parse_level(text);
    if (!any_stage_at(level)) fail_on_missing("the machine", level);
    for (const Stage stage : kAllStages) {
      choice[stage] = level;
      while (!exists(stage, choice[stage]))
        choice[stage] = static_cast<Level>(static_cast<int>(choice[stage]) - 1);
    }
    return choice;
  }
  choice.levels_.fill(Level::kTimed);
  std::vector<Stage> named;
  std::string_view rest = text;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    more = comma != std::string_view::npos;
    const std::string_view part = rest.substr(0, comma);
    if (more) rest.remove_prefix(comma + 1);
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos)
      throw UsageError(
          fmt::format("--level: '{}' must be a level, or STAGE=LEVEL with commas", part));
    const Stage stage = parse_stage("--level", part.substr(0, equals));
    const Level level = parse_level(part.substr(equals + 1));
    if (level == Level::kFunctional)
      throw UsageError(
          fmt::format("--level: {}=functional knows no time and cannot stand beside stages that "
                      "do; take timed, or --level functional for all",
                      name_of(stage)));
    if (!exists(stage, level)) fail_on_missing(name_of(stage), level);
    if (std::find(named.begin(), named.end(), stage) != named.end())
      throw UsageError(fmt::format("--level: {} is named twice", name_of(stage)));
    named.push_back(stage);
    choice[stage] = level;
  }
  return choice;
}

std::string LevelChoice::text() const {
  for (const Level level : kAllLevels) {
    const auto nearest = [&](Stage stage) {
      Level at = level;
      while (!exists(stage, at)) at = static_cast<Level>(static_cast<int>(at) - 1);
      return at;
    };
    if (std::all_of(kAllStages.begin(), kAllStages.end(),
                    [&](Stage stage) { return (*this)[stage] == nearest(stage); }))
      return std::string(name_of(level));
  }
  std::string text;
  for (const Stage stage : kAllStages) {
    if ((*this)[stage] == Level::kTimed) continue;
    if (!text.empty()) text += ',';
    text += fmt::format("{}={}", name_of(stage), name_of((*this)[stage]));
  }
  return text;
}

}  // namespace cigsim
