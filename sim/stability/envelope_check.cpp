// SPDX-License-Identifier: MIT
#include "sim/stability/envelope_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "models/frame_calculator/functional.hpp"
#include "models/priority_processor/functional.hpp"

namespace cigsim::stability {
namespace {

using Json = nlohmann::ordered_json;

// Frames that are looked at, and faces in all of them together.
constexpr std::size_t kMostFrames = 10'000, kMostFaces = 4'000'000;

bool nowhere_wider(const MachineDescription& row, const MachineDescription& machine) {
  const WordFormats &a = row.formats, &b = machine.formats;
  // The hither distance as a share of the coordinate word's range.
  return a.coordinate_bits <= b.coordinate_bits && a.direction_fraction <= b.direction_fraction &&
         a.quotient_fraction <= b.quotient_fraction && a.raster_fraction <= b.raster_fraction &&
         std::ldexp(row.hither, -a.coordinate_bits) >=
             std::ldexp(machine.hither, -b.coordinate_bits);
}

bool is_of(const Envelope& envelope, const MachineOptions& options) {
  switch (options.number) {
    case NumberType::kFloat:
      return envelope.format.arithmetic == Arithmetic::kFloat;
    case NumberType::kDouble:
      return envelope.format.arithmetic == Arithmetic::kDouble;
    case NumberType::kMachine:
      return envelope.format.arithmetic == Arithmetic::kMachine &&
             nowhere_wider(envelope.format.machine, options.description);
    default:
      return false;
  }
}

// Of several that apply (on machine words) the machine's own, else the widest.
const Envelope* envelope_of(const MachineOptions& options, const std::vector<Envelope>& all) {
  const Envelope* best = nullptr;
  for (const Envelope& e : all) {
    if (!is_of(e, options)) continue;
    if (options.number == NumberType::kMachine && e.format.name == options.description.name)
      return &e;
    if (!best || nowhere_wider(best->format.machine, e.format.machine)) best = &e;
  }
  return best;
}

// The value that a frame may go to; nothing: any.
std::optional<double> allowed(const EnvelopeLimit& limit, const QuantityName& quantity) {
  if (!limit.failure) return std::nullopt;
  if (!limit.value) return quantity.least ? HUGE_VAL : 0;
  if (quantity.quantity == Quantity::kLines) return limit.value;
  return quantity.least ? *limit.value * kReserve : *limit.value / kReserve;
}

bool beyond(double value, double limit, bool least) {
  return least ? value < limit : value > limit;
}

bool has_limits(const Envelope& envelope) {
  return std::any_of(envelope.limits.begin(), envelope.limits.end(),
                     [](const EnvelopeLimit& limit) { return limit.failure.has_value(); });
}

struct Measured {
  std::size_t frame = 0;
  Measures measures;
};

// 0 .. count - 1 in an order whose beginnings are spread evenly: the first, then ever finer halves.
std::vector<std::size_t> spread_order(std::size_t count) {
  if (count == 0) return {};
  std::vector<std::size_t> order{0};
  for (std::size_t step = std::bit_ceil(count) / 2; step > 0; step /= 2)
    for (std::size_t f = step; f < count; f += 2 * step) order.push_back(f);
  return order;
}

// Frames spread over the run, as many as their faces allow.
std::vector<Measured> measure_frames(const Database& database, const MachineOptions& options,
                                     const std::vector<FrameView>& views) {
  std::vector<Measured> out;
  const frame_calculator::Functional calculator(database, options.detail);
  priority_processor::Functional<double> priority(PriorityMethod::kCounters);
  ActiveEnvironment active;
  FaceSet moving;
  PriorityList list;
  std::size_t faces = 0;
  for (const std::size_t f : spread_order(views.size())) {
    if (out.size() == kMostFrames || faces > kMostFaces) break;
    calculator.compute(views[f].viewpoint, options.raster, views[f].position, active, moving);
    priority.compute(database.systems[0].hierarchy, database.systems[0].set, active,
                     database.ground, list);
    out.push_back({f, measures_of(database, active, moving, list.items)});
    faces += 1 + database.ground.faces.size() + moving.faces.size();
    for (const ItemRef& ref : list.items)
      if (ref.set == SetId::kStatic) faces += database.systems[0].set.items[ref.item].face_count;
  }
  std::sort(out.begin(), out.end(),
            [](const Measured& a, const Measured& b) { return a.frame < b.frame; });
  return out;
}

std::vector<Excess> excesses(const Envelope& envelope, const std::vector<Measured>& frames) {
  std::vector<Excess> out;
  for (const QuantityName& quantity : quantity_names()) {
    const auto limit = allowed(envelope.limit(quantity.quantity), quantity);
    if (!limit) continue;
    std::optional<Excess> worst;
    for (const Measured& frame : frames) {
      const double value = frame.measures.*quantity.field;
      if (beyond(value, worst ? worst->value : *limit, quantity.least))
        worst = Excess{quantity.quantity, value, *limit, frame.frame};
    }
    if (worst) out.push_back(*worst);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Excess& a, const Excess& b) { return a.times() > b.times(); });
  return out;
}

// The first format that holds the frames: words on words, else doubles, else certified ones.
std::optional<std::string> find_other(const std::vector<Measured>& frames, bool words,
                                      bool words_only, const std::vector<Envelope>& all) {
  const auto holds = [&](const Envelope& e) { return excesses(e, frames).empty(); };
  if (words)
    for (const Envelope& e : all)
      if (e.format.arithmetic == Arithmetic::kMachine && holds(e))
        return "--machine " + e.format.name;
  if (words_only) return std::nullopt;
  for (const Envelope& e : all)
    if (e.format.arithmetic == Arithmetic::kDouble && holds(e)) return "--number double";
  return "--number certified";
}

const QuantityName& named(Quantity q) { return quantity_names()[static_cast<std::size_t>(q)]; }

}  // namespace

double Excess::times() const { return named(quantity).least ? limit / value : value / limit; }

EnvelopeVerdict check_envelope(const Database& database, const MachineOptions& options,
                               const std::vector<FrameView>& views, bool words_only,
                               const std::vector<Envelope>& envelopes) {
  EnvelopeVerdict verdict;
  if (options.number == NumberType::kExact || options.number == NumberType::kCertified) {
    verdict.known = true;
    verdict.format = options.number == NumberType::kExact ? "exact" : "certified";
    return verdict;
  }
  const Envelope* envelope = envelope_of(options, envelopes);
  if (!envelope) return verdict;
  verdict.known = true;
  verdict.format = envelope->format.name;
  if (!has_limits(*envelope) || views.empty()) return verdict;
  const std::vector<Measured> frames = measure_frames(database, options, views);
  verdict.frames_checked = frames.size();
  for (const Measured& frame : frames) {
    if (!verdict.measures) verdict.measures = frame.measures;
    *verdict.measures |= frame.measures;
  }
  verdict.excesses = excesses(*envelope, frames);
  if (!verdict.inside())
    verdict.will_do =
        find_other(frames, options.number == NumberType::kMachine, words_only, envelopes);
  return verdict;
}

std::string excess_text(const Excess& excess, std::string_view where) {
  const QuantityName& quantity = named(excess.quantity);
  return fmt::format("{} {:.3g}{}, {} {:.3g}, {:.3g} times beyond ({})", quantity.name,
                     excess.value, where, quantity.least ? "not below" : "not above", excess.limit,
                     excess.times(), quantity.what);
}

std::string envelope_warning(const EnvelopeVerdict& verdict) {
  if (verdict.inside()) return "";
  std::string text = fmt::format("outside the envelope of {}: ", verdict.format);
  bool first = true;
  for (const Excess& e : verdict.excesses) {
    text += (first ? "" : "; ") + excess_text(e, fmt::format(" in frame {}", e.frame));
    first = false;
  }
  text += "; decisions and pictures may be wrong; ";
  text += verdict.will_do ? *verdict.will_do + " will do"
                          : std::string(
                                "no machine's words will do, --level functional with "
                                "--number double will");
  return text;
}

Json envelope_verdict_json(const EnvelopeVerdict& verdict) {
  // JSON knows no infinity.
  const auto finite = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  Json measures, excesses = Json::array();
  if (verdict.measures) {
    measures = Json::object();
    for (const QuantityName& q : quantity_names())
      measures[q.name] = finite((*verdict.measures).*q.field);
  }
  for (const Excess& e : verdict.excesses)
    excesses.push_back({{"quantity", named(e.quantity).name},
                        {"value", finite(e.value)},
                        {"limit", finite(e.limit)},
                        {"frame", e.frame}});
  return {{"known", verdict.known},
          {"format", verdict.known ? Json(verdict.format) : Json()},
          {"inside", verdict.inside()},
          {"frames_checked", verdict.frames_checked},
          {"measures", std::move(measures)},
          {"excesses", std::move(excesses)},
          {"will_do", verdict.will_do ? Json(*verdict.will_do) : Json()}};
}

}  // namespace cigsim::stability
