// SPDX-License-Identifier: MIT
// What `cigsim stability` measures beside single decisions: the envelope of each format, paths of
// the smallest steps, edges stepped over a whole raster, and the thresholds of Stump's program.
// Each as JSON, as a table, and as plots.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/stability/decision.hpp"

namespace cigsim::stability {

struct PartOptions {
  std::uint64_t seed = 1;
  /// Published thresholds have formats of their own.
  std::vector<Format> formats;
  /// Of the envelope: search it, in a minute or two; else the one that the program carries is told,
  /// of whatever formats.
  bool search = false;
  std::function<void(double)> progress;  ///< is told the share that is done
};

inline constexpr const char* kEnvelopeTable = "envelope.json";

struct PartResult {
  std::string name;             ///< of the key in JSON and of the plots' file
  nlohmann::ordered_json json;  ///< docs/schemas/stability.schema.json has the keys
  std::string text;             ///< a table, its last line ended
  /// Draws NAME.svg into a folder, and of a searched envelope writes kEnvelopeTable, the table that
  /// the program carries. Returns the files. Throws as write_plots(), write_heat_maps() and
  /// write_file() do.
  std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)> draw;
};

PartResult envelope_part(const PartOptions& options);
PartResult flicker_part(const PartOptions& options);
PartResult accumulation_part(const PartOptions& options);
PartResult published_part(const PartOptions& options);

}  // namespace cigsim::stability
