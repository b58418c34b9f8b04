// SPDX-License-Identifier: MIT
#include "sim/listability.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cigsim {
namespace {

constexpr std::size_t kMostLines = 8;

std::string text_of(const ListabilityFault& fault) {
  if (!fault.circuit.empty())
    return fmt::format("objects {} -> {}: each precedes the next", fmt::join(fault.circuit, " -> "),
                       fault.circuit.front());
  std::vector<std::string> pairs;
  for (const auto& [a, b] : fault.unresolved) pairs.push_back(fmt::format("{}, {}", a, b));
  return fmt::format("{} {} {} not resolved by any plane", pairs.size() == 1 ? "pair" : "pairs",
                     fmt::join(pairs, "; "), pairs.size() == 1 ? "is" : "are");
}

}  // namespace

std::vector<std::string> fault_lines(const std::vector<FrameRecord>& frames) {
  struct Met {
    std::string text;
    std::size_t first, count;
  };
  std::vector<Met> met;
  for (std::size_t f = 0; f < frames.size(); ++f)
    for (const ListabilityFault& fault : frames[f].stats.listability) {
      const std::string text = text_of(fault);
      const auto at =
          std::find_if(met.begin(), met.end(), [&](const Met& m) { return m.text == text; });
      if (at == met.end())
        met.push_back({text, f, 1});
      else
        ++at->count;
    }
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(met.size(), kMostLines); ++i)
    lines.push_back(fmt::format("{} (in {} of {} frames, first in frame {})", met[i].text,
                                met[i].count, frames.size(), met[i].first));
  if (met.size() > kMostLines)
    lines.push_back(fmt::format("{} more in stats.json", met.size() - kMostLines));
  return lines;
}

}  // namespace cigsim
