// SPDX-License-Identifier: MIT
#include "sim/stability/envelope_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace cigsim::stability {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }
// JSON knows no infinity; of these figures none is infinite but in one way.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }
double or_infinite(const Json& value) {
  return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
}
std::optional<double> or_nothing(const Json& value) {
  if (value.is_null()) return std::nullopt;
  return value.get<double>();
}

Json words_json(const Format& format) {
  if (format.arithmetic != Arithmetic::kMachine) return nullptr;
  const WordFormats& words = format.machine.formats;
  return {{"coordinate_bits", words.coordinate_bits},
          {"direction_fraction", words.direction_fraction},
          {"quotient_fraction", words.quotient_fraction},
          {"raster_fraction", words.raster_fraction},
          {"hither", format.machine.hither}};
}

Json failure_json(const std::optional<EnvelopeFailure>& failure) {
  if (!failure) return nullptr;
  return {{"world", failure->world},
          {"axis", failure->axis},
          {"step", failure->step},
          {"view", failure->view},
          {"value", finite(failure->value)},
          {"elements", failure->faults.elements},
          {"away_from_edges", failure->faults.away_from_edges},
          {"priorities", failure->faults.priorities},
          {"facings", failure->faults.facings}};
}

Json limit_json(const EnvelopeLimit& limit, const QuantityName& quantity) {
  return {{"quantity", quantity.name},
          {"sense", quantity.least ? "least" : "most"},
          {"searched", limit.searched},
          {"limit", or_null(limit.failure ? limit.value : std::nullopt)},
          {"reached", finite(limit.reached)},
          {"predicted", or_null(limit.predicted)},
          {"failure", failure_json(limit.failure)}};
}

Format format_from(const Json& row) {
  Format format;
  format.name = row.at("format");
  if (format.name == "float") format.arithmetic = Arithmetic::kFloat;
  if (format.name == "certified") format.arithmetic = Arithmetic::kCertified;
  if (format.name == "exact") format.arithmetic = Arithmetic::kExact;
  const Json& words = row.at("words");
  if (words.is_null()) return format;
  format.arithmetic = Arithmetic::kMachine;
  format.machine.name = format.name;
  format.machine.formats = {words.at("coordinate_bits"), words.at("direction_fraction"),
                            words.at("quotient_fraction"), words.at("raster_fraction")};
  format.machine.hither = words.at("hither");
  return format;
}

EnvelopeLimit limit_from(const Json& row) {
  EnvelopeLimit limit;
  limit.searched = row.at("searched");
  limit.value = or_nothing(row.at("limit"));
  limit.reached = or_infinite(row.at("reached"));
  limit.predicted = or_nothing(row.at("predicted"));
  const Json& failure = row.at("failure");
  if (failure.is_null()) return limit;
  EnvelopeFailure& from = limit.failure.emplace();
  from.world = failure.at("world");
  from.axis = failure.at("axis");
  from.step = failure.at("step");
  from.view = failure.at("view");
  from.value = or_infinite(failure.at("value"));
  from.faults.elements = failure.at("elements");
  from.faults.away_from_edges = failure.at("away_from_edges");
  from.faults.priorities = failure.at("priorities");
  from.faults.facings = failure.at("facings");
  return limit;
}

}  // namespace

Json envelope_json(const std::vector<Envelope>& envelopes, std::uint64_t seed) {
  Json formats = Json::array();
  for (const Envelope& envelope : envelopes) {
    Json limits = Json::array();
    for (const QuantityName& quantity : quantity_names())
      limits.push_back(limit_json(envelope.limit(quantity.quantity), quantity));
    formats.push_back({{"format", envelope.format.name},
                       {"words", words_json(envelope.format)},
                       {"frames", envelope.frames},
                       {"wrong", envelope.wrong},
                       {"limits", std::move(limits)}});
  }
  return {{"seed", seed}, {"formats", std::move(formats)}};
}

std::vector<Envelope> envelopes_from_json(const Json& table) {
  std::vector<Envelope> envelopes;
  for (const Json& row : table.at("formats")) {
    Envelope& envelope = envelopes.emplace_back();
    envelope.format = format_from(row);
    envelope.frames = row.at("frames");
    envelope.wrong = row.at("wrong");
    for (const Json& limit : row.at("limits")) {
      const auto& names = quantity_names();
      const auto quantity = std::find_if(names.begin(), names.end(), [&](const QuantityName& q) {
        return limit.at("quantity") == q.name;
      });
      if (quantity == names.end()) throw std::invalid_argument("an envelope's unknown quantity");
      envelope.limits[static_cast<std::size_t>(quantity->quantity)] = limit_from(limit);
    }
  }
  return envelopes;
}

const std::vector<Envelope>& stored_envelopes() {
  static const std::vector<Envelope> stored =
      envelopes_from_json(Json::parse(embedded_text(embedded_envelope(), "envelope.json")));
  return stored;
}

}  // namespace cigsim::stability
