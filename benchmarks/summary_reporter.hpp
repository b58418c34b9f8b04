// SPDX-License-Identifier: MIT
// Google Benchmark's runs as one table: median, extremes and counters of each benchmark.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cigsim::benchmarks {

class SummaryReporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

  struct Times {
    double median, least, most;  ///< milliseconds
  };
  /// Nothing when the benchmark did not run.
  std::optional<Times> times(const std::string& name) const;

 private:
  struct Row {
    std::vector<double> milliseconds;
    benchmark::UserCounters counters;
  };
  std::vector<std::string> order_;
  std::map<std::string, Row> rows_;
};

}  // namespace cigsim::benchmarks
