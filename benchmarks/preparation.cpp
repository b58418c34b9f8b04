// SPDX-License-Identifier: MIT
// Time and memory of preparation: preparation [KIND OBJECTS ...]; see docs/performance.md.
#include <fmt/core.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"

namespace cigsim::benchmarks {
namespace {

struct Case {
  std::string kind;
  std::uint32_t objects;
};

void print_case(const Case& c) {
  const PreparationReport report = prepare(generate_environment(c.kind, {c.objects, 1})).report;
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  fmt::print("{:<10}{:>10}{:>10.3f}{:>10}{:>10}{:>10}{:>14.3f}{:>10}{:>8}\n", c.kind,
             report.objects, report.seconds, usage.ru_maxrss / 1024, report.items, report.cuts,
             static_cast<double>(report.pieces) / static_cast<double>(report.objects),
             report.planes, report.depth);
}

/// Each case is a process of its own, since the peak of memory is a process's.
bool measure(const Case& c) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) return false;
  if (child == 0) {
    int status = 0;
    try {
      print_case(c);
    } catch (const std::exception& error) {
      fmt::print(stderr, "{} {}: {}\n", c.kind, c.objects, error.what());
      status = 1;
    }
    std::fflush(stdout);
    _exit(status);
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

int run(const std::vector<Case>& cases) {
  fmt::print("{:<10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>14}{:>10}{:>8}\n", "kind", "objects",
             "seconds", "peak MiB", "items", "cuts", "pieces/solid", "planes", "depth");
  bool good = true;
  for (const Case& c : cases) good = measure(c) && good;
  return good ? 0 : 1;
}

}  // namespace
}  // namespace cigsim::benchmarks

int main(int argc, char** argv) {
  std::vector<cigsim::benchmarks::Case> cases;
  try {
    if (argc % 2 == 0) throw std::invalid_argument("a kind without a number");
    for (int k = 1; k < argc; k += 2)
      cases.push_back({argv[k], static_cast<std::uint32_t>(std::stoul(argv[k + 1]))});
  } catch (const std::logic_error&) {
    fmt::print(stderr, "preparation [KIND OBJECTS ...]: kinds of `cigsim generate`\n");
    return 2;
  }
  if (cases.empty())
    cases = {{"city", 1000}, {"city", 10'000}, {"city", 100'000}, {"brushes", 5000}};
  return cigsim::benchmarks::run(cases);
}
