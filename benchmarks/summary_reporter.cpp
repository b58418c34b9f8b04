// SPDX-License-Identifier: MIT
#include "benchmarks/summary_reporter.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace cigsim::benchmarks {
namespace {

double middle(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

}  // namespace

bool SummaryReporter::ReportContext(const Context& context) {
  PrintBasicContext(&GetErrorStream(), context);
  return true;
}

void SummaryReporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
    const std::string& name = run.run_name.function_name;
    if (!rows_.contains(name)) order_.push_back(name);
    Row& row = rows_[name];
    row.milliseconds.push_back(1e3 * run.real_accumulated_time /
                               static_cast<double>(run.iterations));
    row.counters = run.counters;
  }
}

void SummaryReporter::Finalize() {
  fmt::print("\n{:<28}{:>12}{:>12}{:>12}{:>6}\n", "benchmark", "median ms", "least ms", "most ms",
             "runs");
  for (const std::string& name : order_) {
    const Row& row = rows_.at(name);
    const Times figures = *times(name);
    fmt::print("{:<28}{:>12.4f}{:>12.4f}{:>12.4f}{:>6}", name, figures.median, figures.least,
               figures.most, row.milliseconds.size());
    for (const auto& [counter, value] : row.counters)
      fmt::print("  {} {:.0f}", counter, static_cast<double>(value));
    fmt::print("\n");
  }
}

std::optional<SummaryReporter::Times> SummaryReporter::times(const std::string& name) const {
  const auto row = rows_.find(name);
  if (row == rows_.end()) return std::nullopt;
  const std::vector<double>& all = row->second.milliseconds;
  const auto [least, most] = std::minmax_element(all.begin(), all.end());
  return Times{middle(all), *least, *most};
}

}  // namespace cigsim::benchmarks
