// SPDX-License-Identifier: MIT
// The envelope as `cigsim stability` tells it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/environment/write.hpp"
#include "sim/drawing/plot.hpp"
#include "sim/stability/envelope_table.hpp"
#include "sim/stability/parts.hpp"

namespace cigsim::stability {
namespace {

std::string limit_text(const EnvelopeLimit& limit, bool least) {
  if (!limit.searched) return "-";
  const char* sign = least ? ">" : "<";
  if (!limit.failure) return fmt::format("({}{:.2g})", sign, limit.reached);
  return limit.value ? fmt::format("{}{:.2g}", sign, *limit.value) : std::string("none");
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
      predicted += fmt::format("{:>12}", formula ? fmt::format("{:.2g}", *formula) : "");
      any = any || formula;
    }
    if (any) text += fmt::format("  {:<12}{}\n", "  by formula", predicted);
  }
  for (const QuantityName& q : quantity_names()) text += fmt::format("  {}: {}\n", q.name, q.what);
  text += "  in brackets: the furthest that was looked at, and nothing was wrong\n";
  return text;
}

// A plot a quantity: a bar a format, its limit in powers of two; where there is none, how far was
// looked.
std::vector<Plot> plots(const std::vector<Envelope>& envelopes) {
  std::vector<Plot> out;
  for (const QuantityName& q : quantity_names()) {
    Plot plot;
    plot.title = q.name;
    plot.x_label = "format";
    plot.y_label = q.least ? "least, 2^-y" : "most, 2^y";
    Curve limits{"limit", {}, CurveStyle::kMarks},
        open{"none found so far", {}, CurveStyle::kMarks};
    Curve formulas{"formula", {}, CurveStyle::kMarks};
    double x = 1;
    for (const Envelope& e : envelopes) {
      const EnvelopeLimit& limit = e.limit(q.quantity);
      const auto put = [&](Curve& curve, double value) {
        const double power = std::log2(value);
        if (value > 0) curve.points.push_back({x, q.least ? -power : power});
      };
      if (limit.failure && limit.value) put(limits, *limit.value);
      if (limit.searched && !limit.failure) put(open, limit.reached);
      if (limit.predicted) put(formulas, *limit.predicted);
      plot.notes.push_back(fmt::format("{}: {}", x, e.format.name));
      ++x;
    }
    plot.curves = {std::move(limits), std::move(open), std::move(formulas)};
    out.push_back(std::move(plot));
  }
  return out;
}

// The searched ones, and others that were asked for.
std::vector<Format> formats_for(const std::vector<Format>& asked) {
  std::vector<Format> formats = searched_formats();
  for (const Format& format : asked)
    if (format.arithmetic != Arithmetic::kExact &&
        std::none_of(formats.begin(), formats.end(),
                     [&](const Format& f) { return same_numbers(f, format); }))
      formats.push_back(format);
  return formats;
}

}  // namespace

PartResult envelope_part(const PartOptions& options) {
  std::vector<Envelope> envelopes;
  std::uint64_t seed = options.seed;
  if (options.search) {
    EnvelopeOptions search;
    search.seed = options.seed;
    search.formats = formats_for(options.formats);
    search.progress = options.progress;
    envelopes = search_envelope(search);
  } else {
    envelopes = stored_envelopes();
    seed = kStoredSeed;
  }
  const nlohmann::ordered_json json = envelope_json(envelopes, seed);
  return {"envelope", json, table(envelopes, options.search),
          [envelopes, json, searched = options.search](const std::filesystem::path& folder) {
            std::vector<std::filesystem::path> files{folder / "envelope.svg"};
            write_plots(plots(envelopes), 3, files[0]);
            if (searched) {
              files.push_back(folder / kEnvelopeTable);
              write_file(files[1], json.dump(1) + "\n");
            }
            return files;
          }};
}

}  // namespace cigsim::stability
