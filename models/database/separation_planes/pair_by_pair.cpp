// SPDX-License-Identifier: MIT
#include "models/database/separation_planes/pair_by_pair.hpp"

#include <algorithm>

#include "models/database/listability/arrangement.hpp"

namespace cigsim::separation_planes {
namespace {

constexpr std::size_t kMostWays = 16;  // planes tried a pair
constexpr std::uint64_t kMostSteps = 200000;

class Choice {
 public:
  Choice(const SideTable& table, std::span<const std::uint32_t> set) : table_(table), set_(set) {
    const std::size_t n = set.size();
    for (std::size_t j = 1; j < n; ++j)
      for (std::size_t i = 0; i < j; ++i) pairs_.push_back({i, j, ways(set[i], set[j])});
    std::vector<Plane> planes;
    for (const std::uint32_t c : used_) planes.push_back(table.candidates()[c].plane);
    eyes_.emplace(planes);
  }

  std::optional<std::vector<PartedPair>> run() {
    chosen_.resize(pairs_.size());
    if (!choose(0)) return std::nullopt;
    std::vector<PartedPair> out;
    for (const Way& way : chosen_) out.push_back({used_[way.plane], way.on_true, way.on_false});
    return out;
  }

 private:
  struct Way {
    std::uint32_t plane = 0;  // into used_
    std::uint32_t on_true = 0, on_false = 0;
  };
  struct Pair {
    std::size_t i, j;
    std::vector<Way> ways;
  };

  std::vector<Way> ways(std::uint32_t a, std::uint32_t b) {
    std::vector<Way> out;
    for (std::uint32_t c = 0; c < table_.candidates().size() && out.size() < kMostWays; ++c) {
      const int sa = table_.side(c, a);
      if (sa == 0 || sa != -table_.side(c, b)) continue;
      out.push_back({place_of(c), sa > 0 ? a : b, sa > 0 ? b : a});
    }
    return out;
  }

  std::uint32_t place_of(std::uint32_t candidate) {
    const auto at = std::find(used_.begin(), used_.end(), candidate);
    if (at == used_.end()) {
      used_.push_back(candidate);
      return static_cast<std::uint32_t>(used_.size() - 1);
    }
    return static_cast<std::uint32_t>(at - used_.begin());
  }

  bool choose(std::size_t p) {
    if (p == pairs_.size()) return true;
    for (const Way& way : pairs_[p].ways) {
      if (++steps_ > kMostSteps) return false;
      chosen_[p] = way;
      if (no_circuit(p) && choose(p + 1)) return true;
    }
    return false;
  }

  const Way& chosen(std::size_t i, std::size_t j) const { return chosen_[j * (j - 1) / 2 + i]; }

  // Among the triples of which the pair p = (i, j) is the last: those with a member before i.
  bool no_circuit(std::size_t p) const {
    const auto [i, j] = std::pair(pairs_[p].i, pairs_[p].j);
    for (std::size_t h = 0; h < i; ++h)
      if (circuit(h, i, j) || circuit(i, h, j)) return false;
    return true;
  }

  // Whether an eyepoint sees a before b before c before a.
  bool circuit(std::size_t a, std::size_t b, std::size_t c) const {
    const std::array<listability::EyeSide, 3> sides{when_first(a, b), when_first(b, c),
                                                    when_first(c, a)};
    return eyes_->can_see(sides);
  }

  listability::EyeSide when_first(std::size_t a, std::size_t b) const {
    const Way& way = chosen(std::min(a, b), std::max(a, b));
    return {way.plane, way.on_true == set_[a]};
  }

  const SideTable& table_;
  std::span<const std::uint32_t> set_;
  std::vector<std::uint32_t> used_;
  std::vector<Pair> pairs_;  // (i, j) with i < j at place j (j - 1) / 2 + i
  std::optional<listability::Arrangement> eyes_;
  std::vector<Way> chosen_;
  std::uint64_t steps_ = 0;
};

}  // namespace

std::optional<std::vector<PartedPair>> pair_by_pair(const SideTable& table,
                                                    std::span<const std::uint32_t> set) {
  if (set.size() > kMostPairByPair) return std::nullopt;
  return Choice(table, set).run();
}

}  // namespace cigsim::separation_planes
