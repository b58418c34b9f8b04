// SPDX-License-Identifier: MIT
#include "models/database/bsp/conflicts.hpp"

#include <bit>
#include <limits>

namespace cigsim {
namespace {

using Row = std::vector<std::uint64_t>;

// By root: the polygons in front of its plane, split by it and behind it, a bit each.
struct Sides {
  Row front, split, back;
};

std::vector<Sides> all_sides(const WorkSet& set, const std::vector<std::uint32_t>& items) {
  const std::size_t n = items.size();
  const Row none((n + 63) / 64, 0);
  std::vector<Sides> all(n, {none, none, none});
  for (std::size_t p = 0; p < n; ++p) {
    const std::uint32_t plane = set.polygons[set.items[items[p]].first_polygon].plane;
    for (std::size_t q = 0; q < n; ++q) {
      const int where = set.classify(set.planes[plane], set.items[items[q]], plane);
      if (where == 0) continue;
      Row& row = where == 2 ? all[p].split : where > 0 ? all[p].front : all[p].back;
      row[q / 64] |= std::uint64_t{1} << q % 64;
    }
  }
  return all;
}

// Sum of f(s, t) over s in `planes` and t in `polygons`.
std::uint64_t conflicts(const std::vector<Sides>& all, const Row& planes, const Row& polygons) {
  std::uint64_t sum = 0;
  for (std::size_t w = 0; w < planes.size(); ++w)
    for (std::uint64_t rest = planes[w]; rest != 0; rest &= rest - 1) {
      const Row& split = all[64 * w + static_cast<std::size_t>(std::countr_zero(rest))].split;
      for (std::size_t i = 0; i < split.size(); ++i)
        sum += static_cast<std::uint64_t>(std::popcount(split[i] & polygons[i]));
    }
  return sum;
}

}  // namespace

std::vector<ConflictCounts> count_conflicts(const WorkSet& set,
                                            const std::vector<std::uint32_t>& items) {
  const std::vector<Sides> all = all_sides(set, items);
  std::vector<ConflictCounts> counts;
  for (const Sides& s : all)
    counts.push_back({conflicts(all, s.front, s.back), conflicts(all, s.back, s.front),
                      conflicts(all, s.split, s.split)});
  return counts;
}

std::size_t best_by_conflicts(const WorkSet& set, const std::vector<std::uint32_t>& items,
                              double weight) {
  const std::vector<ConflictCounts> counts = count_conflicts(set, items);
  double most = -std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  for (std::size_t p = 0; p < counts.size(); ++p)
    if (counts[p].value(weight) > most) {
      most = counts[p].value(weight);
      best = p;
    }
  return best;
}

}  // namespace cigsim
