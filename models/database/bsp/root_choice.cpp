// SPDX-License-Identifier: MIT
#include "models/database/bsp/root_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "models/database/bsp/conflicts.hpp"
#include "models/database/sweep.hpp"

namespace cigsim {
namespace {

using Items = std::vector<std::uint32_t>;

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();
constexpr std::size_t kPublishedCandidates = 128, kCostCandidates = 64;
// Polygons of a list on which rule kCost rates its candidates, and the best candidates that it then
// rates on the whole list.
constexpr std::size_t kProbe = 256, kFinalists = 8;
// Lists longer than this are worth a plane without a polygon.
constexpr std::size_t kDividedSize = 64;
// Eighths of the polygons' ends at which such planes are tried.
constexpr std::size_t kShares[] = {3, 4, 5};

std::uint64_t imbalance(const SideCounts& c) {
  return c.positive > c.negative ? c.positive - c.negative : c.negative - c.positive;
}

struct Rated {
  std::uint32_t plane;
  SideCounts counts;
  double cost = 0;
};

bool cheaper(const Rated& a, const Rated& b) { return a.cost < b.cost; }

// Cost of a root: its splits and those to be expected below it. A list of n polygons is taken to
// grow by k n^1.5, between n log n (polygons much smaller than their region, which planes soon
// part) and n^2 (polygons that reach across it), where k is a few times the least share of a list
// that a candidate splits: nothing where polygons can be parted freely, so that splits alone count
// there. The exponent and the factor are measured (docs/sources/fuchs-kedem-naylor.md).
void set_costs(std::vector<Rated>& rated, std::size_t size) {
  constexpr double kExponent = 1.5, kFactor = 4, kEven = 1e-3;
  const double n = static_cast<double>(size);
  double least = n;
  for (const Rated& r : rated) least = std::min(least, static_cast<double>(r.counts.split));
  // The smallest weight breaks ties for the more even parts.
  const double k = kFactor * least / n + kEven / std::log2(n + 2);
  for (Rated& r : rated) {
    const double split = static_cast<double>(r.counts.split);
    const double a = static_cast<double>(r.counts.positive) + split;
    const double b = static_cast<double>(r.counts.negative) + split;
    r.cost = split + k * (std::pow(a, kExponent) + std::pow(b, kExponent));
  }
}

}  // namespace

// A subset of `count`, every one equally likely (Floyd's draw), in the order of the list.
Items RootChooser::sampled(const Items& items, std::size_t count) {
  if (items.size() <= count) return items;
  Items chosen;
  for (std::size_t j = items.size() - count; j < items.size(); ++j) {
    const std::uint32_t at = random_.below(j + 1);
    const auto place = std::lower_bound(chosen.begin(), chosen.end(), at);
    if (place != chosen.end() && *place == at)
      chosen.push_back(static_cast<std::uint32_t>(j));
    else
      chosen.insert(place, at);
  }
  for (std::uint32_t& i : chosen) i = items[i];
  return chosen;
}

Items RootChooser::candidates(const Items& items) {
  const std::size_t own = options_.rule == BspRule::kCost ? kCostCandidates : kPublishedCandidates;
  return sampled(items, options_.candidates > 0 ? options_.candidates : own);
}

SideCounts RootChooser::count(std::uint32_t plane, const Items& items,
                              std::uint64_t most_splits) const {
  SideCounts c;
  for (const std::uint32_t i : items) {
    switch (set_.classify(set_.planes[plane], set_.items[i], plane)) {
      case 1:
        ++c.positive;
        break;
      case -1:
        ++c.negative;
        break;
      case 0:
        ++c.in_plane;
        break;
      default:
        if (++c.split > most_splits) return c;
    }
  }
  return c;
}

std::uint32_t RootChooser::choose(const Items& items) {
  if (items.size() > 1) {
    if (options_.rule == BspRule::kFewestSplits) return fewest_splits(items);
    if (options_.rule == BspRule::kConflicts) return most_conflicts(items);
    if (options_.rule == BspRule::kCost) return least_cost(items);
  }
  return plane_of(items[0]);
}

// The source leaves ties open: they go to the more even parts, then to the first.
std::uint32_t RootChooser::fewest_splits(const Items& items) {
  std::uint64_t splits = kNoLimit, uneven = kNoLimit;
  std::uint32_t best = 0;
  for (const std::uint32_t candidate : candidates(items)) {
    const std::uint32_t plane = plane_of(candidate);
    const SideCounts c = count(plane, items, splits);
    if (c.split > splits || (c.split == splits && imbalance(c) >= uneven)) continue;
    splits = c.split;
    uneven = imbalance(c);
    best = plane;
  }
  return best;
}

std::uint32_t RootChooser::most_conflicts(const Items& items) {
  const Items list = candidates(items);
  return plane_of(list[best_by_conflicts(set_, list, options_.weight)]);
}

std::uint32_t RootChooser::least_cost(const Items& items) {
  const Items probe = sampled(items, kProbe);
  std::vector<Rated> rated;
  for (const std::uint32_t c : candidates(items)) {
    const std::uint32_t plane = plane_of(c);
    rated.push_back({plane, count(plane, probe, kNoLimit)});
  }
  if (options_.dividing_planes && items.size() > kDividedSize)
    for (const Plane& plane : planes_across_axes(set_, probe, kShares)) {
      const std::uint32_t index = set_.add_plane(plane);
      const SideCounts counts = count(index, probe, kNoLimit);
      // Without a polygon in it a plane must part the list, or nothing is gained.
      if (counts.positive > 0 && counts.negative > 0)
        rated.push_back({index, counts});
      else
        set_.planes.pop_back();
    }
  set_costs(rated, probe.size());
  if (probe.size() < items.size()) {
    std::stable_sort(rated.begin(), rated.end(), cheaper);
    rated.resize(std::min(rated.size(), kFinalists));
    for (Rated& r : rated) r.counts = count(r.plane, items, kNoLimit);
    set_costs(rated, items.size());
  }
  return std::min_element(rated.begin(), rated.end(), cheaper)->plane;
}

}  // namespace cigsim
