// SPDX-License-Identifier: MIT
#include "sim/stats.hpp"

#include <fmt/format.h>
#include <gmp.h>
#include <png.h>

#include <algorithm>
#include <numeric>

#include "models/database/database_json.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

constexpr double StageTimes::*kStages[] = {
    &StageTimes::frame_calculator, &StageTimes::geometry_processor, &StageTimes::priority_processor,
    &StageTimes::edge_orderer,     &StageTimes::priority_resolver,  &StageTimes::video_processor};
constexpr Stage kStageOf[] = {Stage::kFrameCalculator,   Stage::kGeometryProcessor,
                              Stage::kPriorityProcessor, Stage::kEdgeOrderer,
                              Stage::kPriorityResolver,  Stage::kVideoProcessor};

Json options_json(const RunRecord& run) {
  Json out{{"number", name_of(run.machine.number)},
           {"priority", name_of(run.machine.priority)},
           {"resolver", name_of(run.machine.resolver)},
           {"overload", name_of(run.machine.overload)},
           {"raster", {run.machine.raster.width, run.machine.raster.height}},
           {"frames", run.frames_wanted},
           {"repeat", run.repeat},
           {"detail", run.machine.detail == 0 ? Json("most") : Json(run.machine.detail)}};
  const bool words = run.machine.number == NumberType::kMachine;
  out["retrieval"] = words ? Json() : Json(run.machine.retrieval);
  out["coherence"] = words ? Json() : Json(run.machine.coherence);
  out["path"] = run.path ? Json(*run.path) : Json();
  out["sun"] = run.sun ? Json::array({run.sun->azimuth, run.sun->elevation}) : Json();
  out["contact_tolerance"] = run.contact_tolerance ? Json(*run.contact_tolerance) : Json();
  out["eye_reach"] = run.machine.eye_reach;
  return out;
}

Json view_json(const Viewpoint& viewpoint) {
  const Placement& eye = viewpoint.eye;
  return {{"eye", {eye.position.x, eye.position.y, eye.position.z}},
          {"attitude", {eye.heading, eye.pitch, eye.roll}},
          {"fov", viewpoint.fov}};
}

Json cycles_json(const std::optional<FrameTiming>& timing) {
  if (!timing) return {{"total", 0}};
  Json out{{"total", timing->transport_delay()}};
  for (const Stage stage : kAllStages) {
    const Activity& activity = timing->activity[static_cast<std::size_t>(stage)];
    out[std::string(name_of(stage))] = activity.finish - activity.start + 1;
  }
  return out;
}

Json timing_json(const std::optional<FrameTiming>& timing) {
  if (!timing) return nullptr;
  Json stages = Json::object();
  for (const Stage stage : kAllStages) {
    const Activity& a = timing->activity[static_cast<std::size_t>(stage)];
    stages[std::string(name_of(stage))] = {
        {"start", a.start}, {"finish", a.finish},   {"busy", a.busy()},
        {"idle", a.idle},   {"stalled", a.stalled}, {"utilisation", timing->utilisation(stage)}};
  }
  return {{"input", timing->input},
          {"first_element", timing->first_element},
          {"last_element", timing->last_element},
          {"transport_delay", timing->transport_delay()},
          {"frame_periods", timing->period},
          {"frames_extended", timing->extended},
          {"stages", std::move(stages)}};
}

Json overload_json(const std::optional<Overload>& overload) {
  if (!overload) return nullptr;
  Json overflows = Json::object();
  for (const Stage stage : kAllStages)
    overflows[std::string(name_of(stage))] = overload->overflows[static_cast<std::size_t>(stage)];
  return {{"overflows", std::move(overflows)},
          {"dropped_items", overload->dropped_items},
          {"dropped_faces", overload->dropped_faces},
          {"dropped_crossings", overload->dropped_crossings},
          {"overfull_lines", overload->overfull_lines},
          {"late_lines", overload->late_lines},
          {"worst_lateness", overload->worst_lateness}};
}

Json listability_json(const std::vector<ListabilityFault>& faults) {
  Json out = Json::array();
  for (const ListabilityFault& fault : faults)
    out.push_back({{"group", fault.group},
                   {"objects", fault.members},
                   {"circuit", fault.circuit},
                   {"unresolved", fault.unresolved}});
  return out;
}

// Null in numbers that are not certified.
Json redone_json(const std::optional<Redone>& redone) {
  if (!redone) return nullptr;
  return {{"vertices", redone->vertices},
          {"vertices_redone", redone->vertices_redone},
          {"faces", redone->faces},
          {"faces_redone", redone->faces_redone},
          {"edges", redone->edges},
          {"crossings", redone->crossings},
          {"crossings_redone", redone->crossings_redone},
          {"exact_tests", redone->exact_tests},
          {"share", redone->share()}};
}

// Null in a frame without choices.
Json detail_json(const std::vector<std::uint32_t>& counts) {
  if (counts.empty()) return nullptr;
  return {{"choices", std::accumulate(counts.begin(), counts.end(), std::uint64_t{0})},
          {"descriptions", counts}};
}

Json machine_to_json(const RunRecord& run) {
  if (run.machine.number != NumberType::kMachine) return nullptr;
  return Json::parse(machine_json(run.machine.description));
}

Json frame_json(const FrameRecord& frame, std::size_t number) {
  const FrameStats& stats = frame.stats;
  Json stages = Json::object();
  for (std::size_t i = 0; i < std::size(kStages); ++i)
    stages[std::string(name_of(kStageOf[i]))] = stats.stages.*kStages[i];
  return {{"frame", number},
          {"position", frame.view.position},
          {"view", view_json(frame.view.viewpoint)},
          {"picture", frame.picture},
          {"ids", frame.ids},
          {"host_ms", stats.host_ms},
          {"stages", std::move(stages)},
          {"cycles", cycles_json(stats.timing)},
          {"timing", timing_json(stats.timing)},
          {"active_items", stats.active_items},
          {"faces", stats.faces},
          {"edges", stats.edges},
          {"crossings", stats.crossings},
          {"worst_line_crossings", stats.worst_line_crossings},
          {"worst_line", stats.worst_line},
          {"spans", stats.spans},
          {"detail", detail_json(stats.detail)},
          {"overload", overload_json(stats.overload)},
          {"faults", stats.faults},
          {"listability", listability_json(stats.listability)},
          {"ordered_groups", stats.ordered_groups},
          {"reused_groups", stats.reused_groups},
          {"tested_planes", stats.tested_planes},
          {"exact_tests", stats.exact_tests},
          {"certified", stats.certified},
          {"redone", redone_json(stats.redone)}};
}

}  // namespace

const char* version() { return CIGSIM_VERSION; }

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
    case NumberType::kMachine:
      return "machine";
    case NumberType::kCertified:
      return "certified";
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
  return {{"level", run.levels.text()},
          {"scene", run.scene},
          {"options", options_json(run)},
          {"seed", nullptr},
          {"machine", machine_to_json(run)},
          {"envelope", run.envelope},
          {"versions", versions_json()},
          {"budget", run.budget},
          {"interrupted", run.interrupted},
          {"ids_saturate", numbers_saturate(*run.database)},
          {"preparation", report_to_json(run.database->report)},
          {"frames", std::move(frames)}};
}

}  // namespace cigsim
