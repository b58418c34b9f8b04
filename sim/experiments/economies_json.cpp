// SPDX-License-Identifier: MIT
#include "sim/experiments/economies_json.hpp"

#include <algorithm>

#include "sim/measure/host.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

Json sides(const Spread& with, const Spread& without) {
  return {{"with", spread_json(with)}, {"without", spread_json(without)}};
}

Json economy_json(const EconomyResult& r) {
  Json counts = Json::array();
  for (const EconomyCount& c : r.counts)
    counts.push_back({{"what", c.what}, {"with", c.with}, {"without", c.without}});
  const auto& stage = r.economy.stage;
  return {{"name", r.economy.name},
          {"with", r.economy.with},
          {"without", r.economy.without},
          {"frames", r.frames},
          {"same_pictures_required", r.economy.same_pictures},
          {"same_cycles_required", r.economy.same_cycles},
          {"elements", r.elements},
          {"differing", r.differing},
          {"wrong_rounds", r.wrong_rounds()},
          {"holds", r.holds()},
          {"counts", counts},
          {"stage", stage ? Json(name_of(stage->first)) : Json()},
          {"host",
           {{"frame_ms", sides(r.with.frame_ms, r.without.frame_ms)},
            {"memory_mib", sides(r.with.memory_mib, r.without.memory_mib)},
            {"stage_ms", stage ? sides(r.with.stage_ms, r.without.stage_ms) : Json()},
            {"saved", r.saved()}}}};
}

Json so_json(const SoSteps& so) {
  return {
      {"frames", so.frames},
      {"groups", so.groups},
      {"groups_left_out", so.groups_left_out},
      {"why_not", so.why_not().empty() ? Json() : Json(so.why_not())},
      {"pairs", so.pairs},
      {"full_cycles", so.full_cycles},
      {"first_cycles", so.first.cycles},
      {"crossings", so.update.crossings},
      {"crossed_pairs", so.update.pairs},
      {"update_cycles", so.update.cycles},
      {"row_cycles", so.row_cycles},
      {"wrong_rows", so.wrong_rows},
      {"host", {{"full_ms", spread_json(so.full_ms)}, {"update_ms", spread_json(so.update_ms)}}}};
}

Json rtl_json(const RtlSize& rtl) {
  const auto side = [](const RtlSizeSide& s) {
    return Json{
        {"build_s", s.build_s}, {"library_mib", s.library_mib}, {"row_us", spread_json(s.row_us)}};
  };
  return {{"sized", rtl.sized.variant.name()},
          {"fixed", rtl.fixed.variant.name()},
          {"golden", rtl.golden},
          {"host", {{"sized", side(rtl.sized)}, {"fixed", side(rtl.fixed)}}}};
}

std::uint64_t choices_of(const Database& database) {
  std::uint64_t sum = 0;
  for (const PreparedSystem& system : database.systems) sum += system.hierarchy.choices.size();
  return sum;
}

Json scene_json(const EconomyReport& report) {
  const EconomyScene& scene = report.economies.scene;
  const Database& d = *scene.database;
  Json economies = Json::array();
  for (const EconomyResult& r : report.economies.results) economies.push_back(economy_json(r));
  return {{"scene", scene.name},
          {"objects", d.object_count},
          {"items", d.systems[0].set.items.size()},
          {"planes", d.systems[0].hierarchy.planes.size()},
          {"groups", d.systems[0].hierarchy.groups.size()},
          {"moving_models", d.systems.size() - 1},
          {"ground_faces", d.ground.faces.size()},
          {"choices", choices_of(d)},
          {"holds", report.holds()},
          {"economies", economies},
          {"so", so_json(report.economies.so)},
          {"rtl", report.rtl ? rtl_json(*report.rtl) : Json()}};
}

}  // namespace

std::span<const char* const> attributes_of_no_machine() {
  static constexpr const char* kNone[] = {"fading", "smooth shading", "lights", "smoothing"};
  return kNone;
}

Json economies_json(const std::vector<EconomyReport>& reports, const EconomyOptions& options) {
  Json scenes = Json::array(), none = Json::array();
  for (const EconomyReport& report : reports) scenes.push_back(scene_json(report));
  for (const char* attribute : attributes_of_no_machine()) none.push_back(attribute);
  return {{"experiment", "economies"},
          {"seed", options.seed},
          {"frames", options.frames},
          {"rounds", options.rounds},
          {"raster", {options.raster.width, options.raster.height}},
          {"versions", versions_json()},
          {"host", host_json()},
          {"holds", std::all_of(reports.begin(), reports.end(),
                                [](const EconomyReport& r) { return r.holds(); })},
          {"attributes_of_no_machine", none},
          {"scenes", scenes}};
}

}  // namespace cigsim
