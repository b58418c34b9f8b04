// SPDX-License-Identifier: MIT
// The figures of a run, as written to stats.json.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/functional_machine.hpp"
#include "sim/level.hpp"
#include "sim/view.hpp"

namespace cigsim {

/// The program's own version.
const char* version();

/// That, the compiler's and the libraries'.
nlohmann::ordered_json versions_json();

/// Middle value (mean of the two middle ones); 0 without values.
double median(std::vector<double> values);

/// The same frame computed several times: its counts, and medians of its times.
FrameStats median_times(const std::vector<FrameStats>& repeats);

struct FrameRecord {
  FrameView view;
  FrameStats stats;
  std::string picture, ids;  ///< file names, beside stats.json
};

struct RunRecord {
  std::string scene;
  const Database* database = nullptr;
  MachineOptions machine;
  LevelChoice levels;
  std::size_t repeat = 1, frames_wanted = 0;
  std::optional<std::string> path;
  std::optional<Sun> sun;
  std::optional<double> contact_tolerance;
  nlohmann::ordered_json envelope = {};  ///< of stability::envelope_verdict_json()
  bool interrupted = false;
  nlohmann::ordered_json budget;  ///< BudgetOutcome::json; null without --max-error
  std::vector<FrameRecord> frames;
};

/// Indented text; bytes that are not UTF-8 are replaced.
std::string dump(const nlohmann::ordered_json& value);

const char* name_of(NumberType number);
const char* name_of(PriorityMethod method);
const char* name_of(ResolverMethod method);

/// True when object numbers go beyond what ids-NNNN.pgm can hold.
bool numbers_saturate(const Database& database);

/// docs/user-guide.md lists the fields.
nlohmann::ordered_json stats_json(const RunRecord& run);

}  // namespace cigsim
