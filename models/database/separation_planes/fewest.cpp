// SPDX-License-Identifier: MIT
#include "models/database/separation_planes/fewest.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

namespace cigsim::separation_planes {
namespace {

constexpr std::size_t kMostCompared = 4000;

bool contains(const SidePair& a, const SidePair& b) {
  return (b.on_true & ~a.on_true) == 0 && (b.on_false & ~a.on_false) == 0;
}

bool within(const SidePair& a, const SidePair& b) {
  return contains(b, a) || contains({b.on_false, b.on_true}, a);
}

bool divides(const SidePair& plane, std::uint64_t set) {
  return (set & ~(plane.on_true | plane.on_false)) == 0 && (set & plane.on_true) != 0 &&
         (set & plane.on_false) != 0;
}

std::uint64_t low_bit(std::uint64_t set) { return set & (~set + 1); }

// By object: those that a plane parts from it.
using Parted = std::array<std::uint64_t, 64>;

void part(Parted& parted, const SidePair& plane) {
  for (std::uint64_t rest = plane.on_true; rest != 0; rest &= rest - 1)
    parted[std::countr_zero(rest)] |= plane.on_false;
  for (std::uint64_t rest = plane.on_false; rest != 0; rest &= rest - 1)
    parted[std::countr_zero(rest)] |= plane.on_true;
}

class Search {
 public:
  Search(std::uint32_t objects, const std::vector<SidePair>& candidates, std::uint64_t most_steps)
      : all_(objects == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << objects) - 1),
        objects_(objects),
        candidates_(candidates),
        left_(most_steps),
        most_steps_(most_steps) {}

  Fewest run(std::uint32_t upper) {
    Fewest out;
    out.any_table = planes_for_pockets(objects_);
    out.by_pockets = true;
    while (out.any_table < upper && left_ > 0 && !covers(Parted{}, out.any_table)) {
      if (left_ == 0) break;
      ++out.any_table;
      out.by_pockets = false;
    }
    out.division = out.any_table;
    left_ = most_steps_;
    while (out.division < upper) {
      chosen_.clear();
      if (divide({all_}, out.division)) {
        out.planes = chosen_;
        break;
      }
      if (left_ == 0) break;
      ++out.division;
    }
    out.steps = steps_;
    return out;
  }

 private:
  bool step() {
    if (left_ == 0) return false;
    --left_;
    ++steps_;
    return true;
  }

  // Whether k more planes can part every pair.
  bool covers(const Parted& parted, std::uint32_t k) {
    if (!step()) return false;
    std::uint64_t a = 0, open = 0;
    std::uint64_t missing = 0;
    for (std::uint32_t i = 0; i < objects_; ++i) {
      const std::uint64_t rest = all_ & ~parted[i] & ~(std::uint64_t{1} << i);
      missing += static_cast<std::uint64_t>(std::popcount(rest));
      if (rest == 0 || open != 0) continue;
      a = std::uint64_t{1} << i;
      open = low_bit(rest);
    }
    if (open == 0) return true;
    if (k == 0) return false;
    std::uint64_t most = 0;
    std::vector<SidePair> ways;
    for (const SidePair& c : candidates_) {
      most = std::max(most, newly_parted(parted, c));
      if (((c.on_true & a) && (c.on_false & open)) || ((c.on_false & a) && (c.on_true & open)))
        ways.push_back(c);
    }
    if (missing > 2 * most * k) return false;
    std::stable_sort(ways.begin(), ways.end(), [&](const SidePair& x, const SidePair& y) {
      return newly_parted(parted, x) > newly_parted(parted, y);
    });
    for (const SidePair& c : ways) {
      Parted next = parted;
      part(next, c);
      if (covers(next, k - 1)) return true;
      if (left_ == 0) return false;
    }
    return false;
  }

  static std::uint64_t newly_parted(const Parted& parted, const SidePair& plane) {
    std::uint64_t n = 0;
    for (std::uint64_t rest = plane.on_true; rest != 0; rest &= rest - 1)
      n += static_cast<std::uint64_t>(
          std::popcount(plane.on_false & ~parted[std::countr_zero(rest)]));
    return n;
  }

  // Divides the sets with the chosen planes and k more.
  bool divide(std::vector<std::uint64_t> sets, std::uint32_t k) {
    if (!step()) return false;
    use_chosen(sets);
    if (sets.empty()) return true;
    if (k == 0) return false;
    std::uint64_t rest = 0;
    for (const std::uint64_t set : sets) rest |= set;
    for (const std::uint32_t c : ways_to_divide(sets, rest, k)) {
      chosen_.push_back(c);
      if (divide(sets, k - 1)) return true;
      chosen_.pop_back();
      if (left_ == 0) return false;
    }
    return false;
  }

  // Single objects leave the list.
  void use_chosen(std::vector<std::uint64_t>& sets) const {
    std::vector<std::uint64_t> undivided;
    while (!sets.empty()) {
      const std::uint64_t set = sets.back();
      sets.pop_back();
      if (std::popcount(set) < 2) continue;
      const auto c = std::find_if(chosen_.begin(), chosen_.end(), [&](std::uint32_t plane) {
        return divides(candidates_[plane], set);
      });
      if (c == chosen_.end()) {
        undivided.push_back(set);
        continue;
      }
      sets.push_back(set & candidates_[*c].on_true);
      sets.push_back(set & candidates_[*c].on_false);
    }
    sets = std::move(undivided);
  }

  // Candidates that divide the set that fewest divide; of those alike on all that is left, one.
  std::vector<std::uint32_t> ways_to_divide(const std::vector<std::uint64_t>& sets,
                                            std::uint64_t rest, std::uint32_t k) const {
    if (!enough(sets, k)) return {};
    std::optional<std::vector<std::uint32_t>> least;
    for (const std::uint64_t set : sets) {
      std::vector<std::uint32_t> ways;
      for (std::uint32_t c = 0; c < candidates_.size(); ++c)
        if (divides(candidates_[c], set)) ways.push_back(c);
      if (!least || ways.size() < least->size()) least = std::move(ways);
    }
    std::vector<std::uint32_t> kept;
    std::vector<SidePair> seen;
    for (const std::uint32_t c : *least) {
      const SidePair here{candidates_[c].on_true & rest, candidates_[c].on_false & rest};
      if (std::any_of(seen.begin(), seen.end(), [&](const SidePair& s) { return within(here, s); }))
        continue;
      seen.push_back(here);
      kept.push_back(c);
    }
    std::stable_sort(kept.begin(), kept.end(), [&](std::uint32_t a, std::uint32_t b) {
      return parted_pairs(candidates_[a], sets) > parted_pairs(candidates_[b], sets);
    });
    return kept;
  }

  static std::uint64_t parted_pairs(const SidePair& plane, const std::vector<std::uint64_t>& sets) {
    std::uint64_t n = 0;
    for (const std::uint64_t set : sets)
      n += static_cast<std::uint64_t>(std::popcount(set & plane.on_true)) *
           static_cast<std::uint64_t>(std::popcount(set & plane.on_false));
    return n;
  }

  // Whether k planes can part as many pairs as no chosen plane parts.
  bool enough(const std::vector<std::uint64_t>& sets, std::uint32_t k) const {
    Parted parted{};
    for (const std::uint32_t c : chosen_) part(parted, candidates_[c]);
    std::uint64_t missing = 0, most = 0;
    for (const std::uint64_t set : sets)
      for (std::uint64_t rest = set; rest != 0; rest &= rest - 1)
        missing += static_cast<std::uint64_t>(
            std::popcount(set & ~parted[std::countr_zero(rest)] & ~low_bit(rest)));
    for (const SidePair& c : candidates_) most = std::max(most, parted_pairs(c, sets));
    return missing <= 2 * most * k;
  }

  std::uint64_t all_;
  std::uint32_t objects_;
  const std::vector<SidePair>& candidates_;
  std::vector<std::uint32_t> chosen_;
  std::uint64_t left_, most_steps_, steps_ = 0;
};

}  // namespace

SidePair turned(const SidePair& plane) {
  const std::uint64_t least = low_bit(plane.on_true | plane.on_false);
  return plane.on_true & least ? plane : SidePair{plane.on_false, plane.on_true};
}

std::vector<SidePair> maximal(std::vector<SidePair> planes) {
  for (SidePair& plane : planes) plane = turned(plane);
  const auto objects = [](const SidePair& p) { return std::popcount(p.on_true | p.on_false); };
  std::stable_sort(planes.begin(), planes.end(),
                   [&](const SidePair& a, const SidePair& b) { return objects(a) > objects(b); });
  std::vector<SidePair> kept;
  for (const SidePair& plane : planes) {
    if (plane.on_true == 0 || plane.on_false == 0) continue;
    const std::size_t compared = std::min(kept.size(), kMostCompared);
    if (std::none_of(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(compared),
                     [&](const SidePair& k) { return within(plane, k); }))
      kept.push_back(plane);
  }
  return kept;
}

std::uint32_t planes_for_pockets(std::uint64_t objects) {
  std::uint32_t k = 0;
  for (std::uint64_t n = 0; 1 + n + n * (n - 1) / 2 + n * (n - 1) * (n - 2) / 6 < objects; ++n) ++k;
  return k;
}

Fewest fewest_planes(std::uint32_t objects, const std::vector<SidePair>& candidates,
                     std::uint32_t upper, std::uint64_t most_steps) {
  return Search(objects, candidates, most_steps).run(upper);
}

}  // namespace cigsim::separation_planes
