// SPDX-License-Identifier: MIT
#include "sim/stats.hpp"

#include <fmt/format.h>
#include <gmp.h>
#include <png.h>

#include <algorithm>

#include "models/database/database_json.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

constexpr double StageTimes::*kStages[] = {
    &StageTimes::frame_calculator, &StageTimes::geometry_processor, &StageTimes::priority_processor,
    &StageTimes::edge_orderer,     &StageTimes::priority_resolver,  &StageTimes::video_processor};
constexpr const char* kStageNames[] = {"frame_calculator",   "geometry_processor",
                                       "priority_processor", "edge_orderer",
                                       "priority_resolver",  "video_processor"};

Json versions_json() {
  return {{"cigsim", version()},
          {"compiler", __VERSION__},
          {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100,
                              FMT_VERSION % 100)},
          {"gmp", gmp_version},
          {"libpng", png_get_libpng_ver(nullptr)},
          {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                        NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)}};
}

Json options_json(const RunRecord& run) {
  Json out{{"number", name_of(run.machine.number)},
           {"priority", name_of(run.machine.priority)},
           {"resolver", name_of(run.machine.resolver)},
           {"raster", {run.machine.raster.width, run.machine.raster.height}},
           {"frames", run.frames_wanted},
           {"repeat", run.repeat}};
  out["path"] = run.path ? Json(*run.path) : Json();
  out["sun"] = run.sun ? Json::array({run.sun->azimuth, run.sun->elevation}) : Json();
  return out;
}

Json view_json(const Viewpoint& viewpoint) {
  const Placement& eye = viewpoint.eye;
  return {{"eye", {eye.position.x, eye.position.y, eye.position.z}},
          {"attitude", {eye.heading, eye.pitch, eye.roll}},
          {"fov", viewpoint.fov}};
}

Json frame_json(const FrameRecord& frame, std::size_t number) {
  const FrameStats& stats = frame.stats;
  Json stages = Json::object();
  for (std::size_t i = 0; i < std::size(kStages); ++i)
    stages[kStageNames[i]] = stats.stages.*kStages[i];
  return {{"frame", number},
          {"position", frame.view.position},
          {"view", view_json(frame.view.viewpoint)},
          {"picture", frame.picture},
          {"ids", frame.ids},
          {"host_ms", stats.host_ms},
          {"stages", std::move(stages)},
          {"cycles", {{"total", 0}}},
          {"active_items", stats.active_items},
          {"faces", stats.faces},
          {"edges", stats.edges},
          {"crossings", stats.crossings},
          {"worst_line_crossings", stats.worst_line_crossings},
          {"spans", stats.spans},
          {"faults", stats.faults},
          {"exact_tests", stats.exact_tests},
          {"certified", stats.certified}};
}

}  // namespace

const char* version() { return CIGSIM_VERSION; }

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

FrameStats median_times(const std::vector<FrameStats>& repeats) {
  FrameStats result = repeats.back();
  const auto middle = [&](auto time_of) {
    std::vector<double> times;
    for (const FrameStats& stats : repeats) times.push_back(time_of(stats));
    return median(std::move(times));
  };
  result.host_ms = middle([](const FrameStats& s) { return s.host_ms; });
  for (const auto stage : kStages)
    result.stages.*stage = middle([stage](const FrameStats& s) { return s.stages.*stage; });
  return result;
}

std::string dump(const Json& value) {
  return value.dump(2, ' ', false, Json::error_handler_t::replace);
}

const char* name_of(NumberType number) {
  switch (number) {
    case NumberType::kFloat:
      return "float";
    case NumberType::kDouble:
      return "double";
    case NumberType::kExact:
      break;
  }
  return "exact";
}

const char* name_of(PriorityMethod method) {
  return method == PriorityMethod::kCounters ? "counters" : "so";
}

const char* name_of(ResolverMethod method) {
  switch (method) {
    case ResolverMethod::kAuto:
      return "auto";
    case ResolverMethod::kPainter:
      return "painter";
    case ResolverMethod::kCoverage:
      return "coverage";
    case ResolverMethod::kActiveList:
      break;
  }
  return "active-list";
}

bool numbers_saturate(const Database& database) {
  return database.object_count + database.ground.faces.size() > 65535;
}

Json stats_json(const RunRecord& run) {
  Json frames = Json::array();
  for (std::size_t i = 0; i < run.frames.size(); ++i)
    frames.push_back(frame_json(run.frames[i], i));
  return {{"level", "functional"},
          {"scene", run.scene},
          {"options", options_json(run)},
          {"seed", nullptr},
          {"machine", nullptr},
          {"versions", versions_json()},
          {"interrupted", run.interrupted},
          {"ids_saturate", numbers_saturate(*run.database)},
          {"preparation", report_to_json(run.database->report)},
          {"frames", std::move(frames)}};
}

}  // namespace cigsim
