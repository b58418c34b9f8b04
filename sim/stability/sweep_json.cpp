// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "sim/stability/stability_report.hpp"

namespace cigsim::stability {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::kFloat:
      return "float";
    case Arithmetic::kDouble:
      return "double";
    case Arithmetic::kCertified:
      return "certified";
    case Arithmetic::kMachine:
      return "machine";
    case Arithmetic::kExact:
      break;
  }
  return "exact";
}

Json format_json(const Format& format) {
  Json out{{"name", format.name}, {"arithmetic", name_of(format.arithmetic)}, {"words", nullptr}};
  const WordFormats& words = format.machine.formats;
  if (format.arithmetic == Arithmetic::kMachine)
    out["words"] = {{"coordinate_bits", words.coordinate_bits},
                    {"direction_fraction", words.direction_fraction},
                    {"quotient_fraction", words.quotient_fraction},
                    {"raster_fraction", words.raster_fraction},
                    {"hither", format.machine.hither}};
  return out;
}

Json vector_json(const Vec3& v) { return Json{v.x, v.y, v.z}; }

Json view_json(const ViewTransform& view) {
  Json rotation = Json::array();
  for (const Vec3& row : view.rotation.row) rotation.push_back(vector_json(row));
  return {{"eye", vector_json(view.eye)},
          {"rotation", rotation},
          {"focal", view.focal},
          {"raster", {view.raster.width, view.raster.height}}};
}

Json instance_json(const Instance& instance) {
  Json points = Json::array(), planes = Json::array(), spheres = Json::array();
  for (const Vec3& p : instance.points) points.push_back(vector_json(p));
  for (const PlaneDefinition& d : instance.planes)
    planes.push_back({{"point", vector_json(d.p)},
                      {"u", {vector_json(d.u0), vector_json(d.u1)}},
                      {"v", {vector_json(d.v0), vector_json(d.v1)}}});
  for (const Sphere& s : instance.spheres)
    spheres.push_back({{"centre", vector_json(s.centre)}, {"radius", s.radius}});
  return {{"points", points},
          {"planes", planes},
          {"spheres", spheres},
          {"view", view_json(instance.view)}};
}

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json failure_json(double value, const Failure& failure) {
  return {{"value", value},
          {"seed", fmt::format("{:#018x}", failure.seed)},
          {"error", optional_json(failure.outcome.error)},
          {"bound", optional_json(failure.outcome.bound)},
          {"instance", instance_json(failure.instance)}};
}

// A format along an axis: a list for each figure, an entry for each value.
Json along_axis(const Sweep& sweep, std::size_t decision, std::size_t format, Axis axis,
                const std::string& name) {
  Json out{{"format", name}};
  for (const char* key : {"posed", "wrong", "doubtful", "worst_error", "claims", "broken",
                          "largest_bound", "worst_ratio"})
    out[key] = Json::array();
  const Cell* broken = nullptr;
  for (const Cell& cell : sweep.cells) {
    if (cell.decision != decision || cell.format != format || cell.axis != axis) continue;
    out["posed"].push_back(cell.posed);
    out["wrong"].push_back(cell.wrong);
    out["doubtful"].push_back(cell.doubtful);
    out["worst_error"].push_back(cell.worst_error);
    out["claims"].push_back(cell.claims);
    out["broken"].push_back(cell.broken);
    out["largest_bound"].push_back(cell.largest_bound);
    out["worst_ratio"].push_back(cell.worst_ratio);
    if (cell.first_broken && broken == nullptr) broken = &cell;
  }
  const Cell* first = first_failure(sweep, decision, format, axis);
  out["first_failure"] = first ? failure_json(first->value, *first->first) : Json();
  out["first_broken"] = broken ? failure_json(broken->value, *broken->first_broken) : Json();
  return out;
}

Json summary_json(const Summary& s, const std::string& name) {
  Json out{{"format", name},
           {"posed", s.posed},
           {"wrong", s.wrong},
           {"doubtful", s.doubtful},
           {"worst", nullptr},
           {"worst_error", s.worst_error},
           {"claims", s.claims},
           {"broken", s.broken},
           {"largest_bound", s.largest_bound},
           {"worst_ratio", s.worst_ratio}};
  if (s.worst)
    out["worst"] = {{"axis", stability::name_of(s.worst->axis)},
                    {"value", s.worst->value},
                    {"share", s.worst_share()}};
  return out;
}

Json decision_json(const SweepPlan& plan, const Sweep& sweep, std::size_t d) {
  const Decision& decision = plan.decisions[d];
  const std::size_t formats = decision.shared ? 1 : plan.formats.size();
  const auto name = [&](std::size_t f) {
    return decision.shared ? std::string("any") : plan.formats[f].name;
  };
  Json summaries = Json::array(), axes = Json::array();
  for (std::size_t f = 0; f < formats; ++f)
    summaries.push_back(summary_json(summary(sweep, d, f), name(f)));
  for (const Axis axis : plan.axes) {
    if (std::find(decision.axes.begin(), decision.axes.end(), axis) == decision.axes.end())
      continue;
    Json each = Json::array();
    for (std::size_t f = 0; f < formats; ++f)
      each.push_back(along_axis(sweep, d, f, axis, name(f)));
    axes.push_back({{"axis", stability::name_of(axis)},
                    {"meaning", meaning_of(axis)},
                    {"values", values_of(axis)},
                    {"formats", std::move(each)}});
  }
  return {{"name", decision.name},           {"what", decision.what},
          {"unit", decision.unit},           {"shared", decision.shared},
          {"formats", std::move(summaries)}, {"axes", std::move(axes)}};
}

}  // namespace

Json sweep_json(const SweepPlan& plan, const Sweep& sweep) {
  Json formats = Json::array(), decisions = Json::array();
  for (const Format& format : plan.formats) formats.push_back(format_json(format));
  for (std::size_t d = 0; d < plan.decisions.size(); ++d)
    decisions.push_back(decision_json(plan, sweep, d));
  return {{"trials", plan.trials},
          {"formats", std::move(formats)},
          {"decisions", std::move(decisions)}};
}

}  // namespace cigsim::stability
