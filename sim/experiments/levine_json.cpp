// SPDX-License-Identifier: MIT
#include "sim/experiments/levine_json.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json fit_json(std::span<const Vec2> points) {
  const PowerFit fit = power_fit(points);
  if (fit.points < 2) return nullptr;
  return {{"exponent", fit.exponent}, {"log10_factor", fit.intercept}, {"points", fit.points}};
}

Json hull_set(const HullDataSet& set) {
  Json out{{"points", set.points}, {"cases", set.tests.size()}};
  for (const NamedHullQuantity& q : kHullQuantities) {
    const auto& values = set.*q.values;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    out[q.key] = {{"mean", mean(values)}, {"least", *least}, {"most", *most}};
  }
  out["seconds"] = set.seconds;
  return out;
}

Json hull_json(const std::vector<HullCurve>& curves) {
  Json list = Json::array();
  for (const HullCurve& curve : curves) {
    Json sets = Json::array(), fits = Json::object();
    for (const HullDataSet& set : curve.sets) sets.push_back(hull_set(set));
    for (const NamedHullQuantity& q : kHullQuantities)
      fits[q.key] = fit_json(averages(curve, q.values));
    list.push_back({{"distribution", name_of(curve.distribution)},
                    {"fits", std::move(fits)},
                    {"sets", std::move(sets)}});
  }
  return list;
}

Json shares_json(const std::vector<double>& values) {
  Json out = Json::object();
  for (const double share : kSphereShares)
    out[std::to_string(std::lround(share * 100))] =
        values.empty() ? Json(nullptr) : number(percentile(values, share));
  return out;
}

Json sphere_set(const SphereDataSet& set) {
  Json out{{"points", set.points}, {"cases", set.tests.size()}, {"given_up", set.given_up}};
  for (const NamedSphereQuantity& q : kSphereQuantities) out[q.key] = shares_json(set.*q.values);
  out["spheres_by_points"] = {{"2", set.types[2]}, {"3", set.types[3]}, {"4", set.types[4]}};
  out["seconds"] = set.seconds;
  return out;
}

Json sphere_json(const std::vector<SphereCurve>& curves) {
  Json list = Json::array();
  for (const SphereCurve& curve : curves) {
    Json sets = Json::array(), fits = Json::object();
    for (const SphereDataSet& set : curve.sets) sets.push_back(sphere_set(set));
    for (const NamedSphereQuantity& q : kSphereQuantities)
      for (const double share : kSphereShares)
        fits[q.key][std::to_string(std::lround(share * 100))] =
            fit_json(percentiles(curve, q.values, share));
    list.push_back({{"distribution", name_of(curve.distribution)},
                    {"fits", std::move(fits)},
                    {"sets", std::move(sets)}});
  }
  return list;
}

Json frames_json(const std::vector<HiddenLineFrame>& frames) {
  Json out = Json::object();
  for (const NamedCounter& c : kHiddenLineCounters) {
    Json& values = out[c.key] = Json::array();
    for (const HiddenLineFrame& frame : frames) values.push_back(frame.counters.*c.value);
  }
  Json& times = out["ms"] = Json::array();
  for (const HiddenLineFrame& frame : frames) times.push_back(frame.ms);
  return out;
}

Json hidden_line_json(const std::vector<HiddenLineDataSet>& sets) {
  Json list = Json::array();
  for (const HiddenLineDataSet& set : sets) {
    Json averages = Json::object();
    for (const NamedCounter& c : kHiddenLineCounters) averages[c.key] = average(set, c.value);
    averages["ms"] = average_ms(set);
    list.push_back({{"name", set.name},
                    {"objects", set.objects},
                    {"edges", set.edges},
                    {"averages", std::move(averages)},
                    {"yaw", frames_json(set.yaw)},
                    {"pitch", frames_json(set.pitch)}});
  }
  return list;
}

}  // namespace

Json levine_json(const LevineResults& results) {
  Json findings = Json::array();
  for (const Finding& f : levine_findings(results))
    findings.push_back({{"what", f.what},
                        {"published", f.published},
                        {"ours", number(f.ours)},
                        {"agrees", f.agrees()},
                        {"timed", f.timed}});
  Json out{{"experiment", "levine"},
           {"cases", results.options.cases},
           {"seed", results.options.seed},
           {"findings", std::move(findings)}};
  if (!results.hull.empty()) out["hull"] = hull_json(results.hull);
  if (!results.sphere.empty()) out["sphere"] = sphere_json(results.sphere);
  if (!results.hidden_line.empty()) out["hidden_line"] = hidden_line_json(results.hidden_line);
  return out;
}

}  // namespace cigsim
