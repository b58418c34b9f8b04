// SPDX-License-Identifier: MIT
#include "sim/separation_text.hpp"

#include <fmt/format.h>

#include "models/database/separation_planes/separation_scene.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
using namespace separation_planes;

constexpr const char* kRow = "{:<28}{}\n";

std::string plane_lines(const ResultPlane& plane, std::size_t number) {
  const UnitPlane unit = unit_plane(plane.plane);
  std::string out = fmt::format("FOR PLANE NUMBER{:3} ({})\n", number, text_of(plane.origin));
  out += fmt::format("THE UNIT NORMAL IS: {:.6g} {:.6g} {:.6g}\n", unit.normal.x, unit.normal.y,
                     unit.normal.z);
  out += fmt::format("AND THE DIRECTED DISTANCE IS: {:.6g}\n", unit.distance);
  out +=
      fmt::format("{:<43}{:<10}{}\n", "THE TRUE/FALSE PAIRS FOR THIS PLANE ARE:", "TRUE", "FALSE");
  out += fmt::format("{:43}{:<10}{}\n", "", "-----", "-----");
  for (const ObjectPair& pair : plane.pairs)
    out += fmt::format("{:43}{:4}{:6}{:4}\n", "", pair.true_object, "", pair.false_object);
  return out;
}

std::string least_text(const LeastPlanes& least, std::size_t planes) {
  const std::string over = least.all_planes ? "of any planes" : "on planes of faces and S cards";
  const char* why = least.by_pockets ? "each object needs a pocket of its own"
                                     : "every two objects need a plane between them";
  if (least.any_table == planes)
    return fmt::format("{} planes, proved: no table {} has fewer ({})", planes,
                       least.by_pockets ? "of any planes" : over, why);
  if (least.division == planes)
    return fmt::format("{} planes, proved: no division {} has fewer; no table has fewer than {}",
                       planes, over, least.any_table);
  return fmt::format("{} planes found, not proved: no division {} has fewer than {}", planes, over,
                     least.division);
}

std::string proof_text(const listability::Proof& proof) {
  if (proof.listable)
    return fmt::format("from every eyepoint, proved ({} triples of objects)", proof.triples);
  return "NOT PROVED";
}

Json json_of(const UnitPlane& plane) {
  return {{"normal", {plane.normal.x, plane.normal.y, plane.normal.z}},
          {"distance", plane.distance}};
}

Json json_of(const std::vector<ObjectPair>& pairs) {
  Json out = Json::array();
  for (const ObjectPair& pair : pairs) out.push_back({pair.true_object, pair.false_object});
  return out;
}

}  // namespace

std::string separation_report(const SeparationResult& result) {
  std::string out =
      fmt::format("NUMBER OF SEPARATION PLANES REQUIRED = {:3}\n\n", result.planes.size());
  for (std::size_t p = 0; p < result.planes.size(); ++p)
    out += plane_lines(result.planes[p], p + 1);
  out += "NORMAL TERMINATION\n\n";
  for (const ResultSplit& split : result.splits)
    out += fmt::format(kRow, "Split",
                       fmt::format("object {} at plane {}: its TRUE part becomes object {}",
                                   split.object, split.plane, split.true_part));
  if (result.pair_by_pair)
    out += fmt::format(kRow, "Planes a pair",
                       "no plane divides some set of objects; its pairs have planes of their own");
  out += fmt::format(
      kRow, "By the published rule",
      result.published ? fmt::format("{} planes", *result.published) : "none can be found");
  out += fmt::format(kRow, "By the exact rule", fmt::format("{} planes", result.greedy));
  if (result.least)
    out += fmt::format(kRow, "Fewest", least_text(*result.least, result.planes.size()));
  return out + fmt::format(kRow, "Listable", proof_text(result.proof));
}

Json to_json(const SeparationResult& result) {
  Json out{{"rule", "exact"}, {"found", true}};
  out["planes"] = Json::array();
  for (const ResultPlane& plane : result.planes) {
    Json row = json_of(unit_plane(plane.plane));
    row["from"] = text_of(plane.origin);
    row["pairs"] = json_of(plane.pairs);
    out["planes"].push_back(std::move(row));
  }
  out["splits"] = Json::array();
  for (const ResultSplit& split : result.splits)
    out["splits"].push_back(
        {{"object", split.object}, {"true_part", split.true_part}, {"plane", split.plane}});
  out["planes_a_pair"] = result.pair_by_pair;
  out["published_planes"] = result.published ? Json(*result.published) : Json(nullptr);
  out["greedy_planes"] = result.greedy;
  if (result.least) {
    const LeastPlanes& least = *result.least;
    out["least"] = {{"any_table", least.any_table},
                    {"division", least.division},
                    {"proved", least.division == result.planes.size()},
                    {"over_all_planes", least.all_planes || least.by_pockets},
                    {"candidates", least.candidates},
                    {"different", least.different}};
  }
  out["listable"] = result.proof.listable;
  return out;
}

Json to_json(const PublishedTable& table) {
  Json out{{"rule", "published"}, {"found", table.found}, {"candidates", table.candidates}};
  out["planes"] = Json::array();
  for (const ChosenPlane& plane : table.planes) {
    Json row = json_of(plane.plane);
    row["candidate"] = plane.candidate + 1;
    row["pairs"] = json_of(plane.pairs);
    out["planes"].push_back(std::move(row));
  }
  return out;
}

}  // namespace cigsim
