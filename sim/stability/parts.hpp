// SPDX-License-Identifier: MIT
// What `cigsim stability` measures beside single decisions: the envelope of each format, paths of
// the smallest steps, edges stepped over a whole raster, and the thresholds of Stump's program.
// Each as JSON, as a table, and as plots.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/drawing/gnuplot.hpp"
#include "sim/stability/decision.hpp"

namespace cigsim::stability {

struct PartOptions {
  std::uint64_t seed = 1;
  std::vector<Format> formats;  ///< that it tells something of; none: the part's own
  /// Of the envelope: search it, in some minutes; else the one that the program carries is told.
  bool search = false;
  std::function<void(double)> progress;  ///< is told the share that is done
};

struct PartResult {
  std::string name;             ///< of the key in JSON
  nlohmann::ordered_json json;  ///< docs/schemas/stability.schema.json has the keys
  std::string text;             ///< a table, its last line ended
  Sheet sheet;                  ///< NAME.svg
};

/// Why a part tells nothing of a format; none: it does.
using WhyNot = std::optional<std::string>;
WhyNot why_no_envelope(const Format& format, bool search);
WhyNot why_no_flicker(const Format& format, bool search);
WhyNot why_no_accumulation(const Format& format, bool search);
WhyNot why_no_published(const Format& format, bool search);

PartResult envelope_part(const PartOptions& options);
PartResult flicker_part(const PartOptions& options);
PartResult accumulation_part(const PartOptions& options);
PartResult published_part(const PartOptions& options);

}  // namespace cigsim::stability
