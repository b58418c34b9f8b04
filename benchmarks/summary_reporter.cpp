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
    const auto [least, most] =
        std::minmax_element(row.milliseconds.begin(), row.milliseconds.end());
    fmt::print("{:<28}{:>12.4f}{:>12.4f}{:>12.4f}{:>6}", name, middle(row.milliseconds), *least,
               *most, row.milliseconds.size());
    for (const auto& [counter, value] : row.counters)
      fmt::print("  {} {:.0f}", counter, static_cast<double>(value));
    fmt::print("\n");
  }
}

double SummaryReporter::median(const std::string& name) const {
  const auto row = rows_.find(name);
  return row == rows_.end() ? 0 : middle(row->second.milliseconds);
}

}  // namespace cigsim::benchmarks
