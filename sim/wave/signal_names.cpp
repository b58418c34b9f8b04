// SPDX-License-Identifier: MIT
#include "sim/wave/signal_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace cigsim {
namespace {

constexpr std::size_t kShown = 4;

std::string_view last_part(std::string_view name) { return name.substr(name.rfind('.') + 1); }

// Characters to put in, take out or replace to make `b` of `a` (Levenshtein).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

bool fits(const WaveSignal& signal, std::string_view name) {
  const auto ends_with = [&](std::string_view whole) {
    return whole.ends_with(name) &&
           (whole.size() == name.size() || whole[whole.size() - name.size() - 1] == '.');
  };
  return ends_with(signal.name) || (!signal.range.empty() && ends_with(signal.name + signal.range));
}

bool same(const WaveSignal& a, const WaveSignal& b) {
  return a.name == b.name && a.range == b.range;
}

}  // namespace

std::size_t SignalNames::find(std::string_view name) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    const WaveSignal& signal = signals_[i];
    if (signal.name == name || (!signal.range.empty() && signal.name + signal.range == name))
      return i;
    if (!fits(signal, name)) continue;
    if (found.empty() || !same(signals_[found.front()], signal)) found.push_back(i);
  }
  if (found.size() == 1) return found.front();
  std::vector<std::string_view> names;
  for (const std::size_t i : found)
    if (names.size() < kShown) names.push_back(signals_[i].name);
  if (!found.empty())
    throw std::invalid_argument(
        fmt::format("{} signals are called '{}', such as {}; name more of one's scopes",
                    found.size(), name, fmt::join(names, ", ")));
  throw std::invalid_argument(
      fmt::format("there is no signal '{}'; near it are {}", name, fmt::join(nearest(name), ", ")));
}

// By the last part first, then by the whole.
std::vector<std::string_view> SignalNames::nearest(std::string_view name) const {
  name = name.substr(0, name.find('['));
  struct Candidate {
    std::size_t part, whole;
    std::string_view name;
    auto operator<=>(const Candidate&) const = default;
  };
  std::vector<Candidate> candidates;
  for (const WaveSignal& signal : signals_)
    candidates.push_back({distance(last_part(name), last_part(signal.name)),
                          distance(name, signal.name), signal.name});
  std::sort(candidates.begin(), candidates.end());
  std::vector<std::string_view> names;
  for (const Candidate& candidate : candidates)
    if (names.size() < kShown && (names.empty() || names.back() != candidate.name))
      names.push_back(candidate.name);
  return names;
}

}  // namespace cigsim
