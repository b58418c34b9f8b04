// SPDX-License-Identifier: MIT
// The envelope as `cigsim stability` tells it.
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "sim/drawing/plot.hpp"
#include "sim/stability/envelope_table.hpp"
#include "sim/stability/parts.hpp"

namespace cigsim::stability {
namespace {

// Numbers of lines are whole.
std::string number_text(double value) {
  const bool whole = value == std::floor(value) && value < 1e6;
  return whole ? fmt::format("{:.0f}", value) : fmt::format("{:.2g}", value);
}

std::string limit_text(const EnvelopeLimit& limit, bool least) {
  if (!limit.searched) return "-";
  const char* sign = least ? ">" : "<";
  if (!limit.failure) return fmt::format("({}{})", sign, number_text(limit.reached));
  return limit.value ? fmt::format("{}{}", sign, number_text(*limit.value)) : "none";
}

std::string table(const std::vector<Envelope>& envelopes, bool searched) {
  std::string text =
      fmt::format("Envelope ({}): up to where no decision is wrong, others benign\n  {:<12}",
                  searched ? "searched now" : "as the program carries it", "");
  for (const QuantityName& q : quantity_names()) text += fmt::format("{:>12}", q.name);
  text += "  frames, wrong\n";
  for (const Envelope& e : envelopes) {
    text += fmt::format("  {:<12}", e.format.name);
    for (const QuantityName& q : quantity_names())
      text += fmt::format("{:>12}", limit_text(e.limit(q.quantity), q.least));
    text += fmt::format("  {}, {}\n", e.frames, e.wrong);
    std::string predicted;
    bool any = false;
    for (const QuantityName& q : quantity_names()) {
      const auto& formula = e.limit(q.quantity).predicted;
      predicted += fmt::format("{:>12}", formula ? number_text(*formula) : "");
      any = any || formula;
    }
    if (!any) continue;
    predicted.erase(predicted.find_last_not_of(' ') + 1);
    text += fmt::format("  {:<12}{}\n", "  by formula", predicted);
  }
  for (const QuantityName& q : quantity_names()) text += fmt::format("  {}: {}\n", q.name, q.what);
  text += "  in brackets: the furthest that was looked at, and nothing was wrong\n";
  return text;
}

// A plot a quantity: a row a format, its limit in powers of two; where there is none, how far was
// looked.
std::vector<Plot> plots(const std::vector<Envelope>& envelopes) {
  std::vector<Plot> out;
  for (const QuantityName& q : quantity_names()) {
    Plot plot;
    plot.title = q.name;
    plot.x_label = q.least ? "least, 2^-x" : "most, 2^x";
    Curve limits{"limit", {}, CurveStyle::kMarks},
        open{"none found so far", {}, CurveStyle::kMarks};
    Curve formulas{"formula", {}, CurveStyle::kMarks};
    std::string without;
    for (const Envelope& e : envelopes) {
      const EnvelopeLimit& limit = e.limit(q.quantity);
      const auto put = [&](Curve& curve, double value) {
        const double power = std::log2(value);
        if (std::isfinite(power))
          curve.points.push_back({q.least ? -power : power, static_cast<double>(plot.rows.size())});
        else
          without += fmt::format("{}{}", without.empty() ? "" : ", ", e.format.name);
      };
      if (limit.failure && limit.value) put(limits, *limit.value);
      if (limit.searched && !limit.failure) put(open, limit.reached);
      if (limit.predicted) put(formulas, *limit.predicted);
      plot.rows.push_back(e.format.name);
    }
    if (!without.empty())
      plot.notes.push_back(
          fmt::format("{}: none found, {}", without, q.least ? "down to 0" : "however large"));
    plot.curves = {std::move(limits), std::move(open), std::move(formulas)};
    out.push_back(std::move(plot));
  }
  return out;
}

std::vector<Envelope> searched(const PartOptions& options) {
  EnvelopeOptions search;
  search.seed = options.seed;
  search.formats = options.formats.empty() ? searched_formats() : options.formats;
  search.progress = options.progress;
  return search_envelope(search);
}

// Of the same numbers, under the format's name.
std::optional<Envelope> carried(const Format& format) {
  for (const Envelope& e : stored_envelopes()) {
    if (!same_numbers(format, e.format)) continue;
    Envelope named = e;
    named.format.name = format.name;
    return named;
  }
  return {};
}

std::vector<Envelope> carried(const std::vector<Format>& asked) {
  if (asked.empty()) return stored_envelopes();
  std::vector<Envelope> envelopes;
  for (const Format& format : asked)
    if (std::optional<Envelope> envelope = carried(format))
      envelopes.push_back(std::move(*envelope));
  return envelopes;
}

}  // namespace

WhyNot why_no_envelope(const Format& format, bool search) {
  if (format.arithmetic == Arithmetic::kExact) return "it has no limits";
  if (search || carried(format)) return {};
  return "the program carries none; add --envelope to search it";
}

PartResult envelope_part(const PartOptions& options) {
  const std::vector<Envelope> envelopes =
      options.search ? searched(options) : carried(options.formats);
  return {"envelope",
          envelope_json(envelopes, options.search ? options.seed : kStoredSeed),
          table(envelopes, options.search),
          {"envelope.svg", plot_script(plots(envelopes), 3)}};
}

}  // namespace cigsim::stability
