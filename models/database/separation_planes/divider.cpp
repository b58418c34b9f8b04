// SPDX-License-Identifier: MIT
#include "models/database/separation_planes/divider.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>

namespace cigsim::separation_planes {
namespace {

using Set = std::vector<std::uint32_t>;

// Planes tried at most for a set.
constexpr std::uint64_t kMostEdgePlanes = 500000, kMostCornerPlanes = 500000;

struct Sides {
  std::size_t on_true = 0, on_false = 0, cut = 0;
  bool divide() const { return cut == 0 && on_true > 0 && on_false > 0; }
};

class Divider {
 public:
  explicit Divider(SideTable& table) : table_(table) {
    for (std::uint32_t c = 0; c < table.candidates().size(); ++c) allowed_.push_back(c);
  }

  DividedTable run() {
    sets_.resize(1);
    for (std::uint32_t b = 0; b < table_.bodies().size(); ++b) sets_[0].push_back(b);
    while (at_ < sets_.size()) {
      if (sets_[at_].size() <= 1)
        ++at_;
      else if (const auto c = select())
        part_set(*c);
      else if (const auto further = further_candidate(sets_[at_]))
        part_set(add(*further));
      else
        without_division();
    }
    out_.planes = static_cast<std::uint32_t>(chosen_.size());
    return std::move(out_);
  }

 private:
  Sides sides(std::uint32_t c, const Set& set) const {
    Sides out;
    for (const std::uint32_t b : set) {
      const int s = table_.side(c, b);
      ++(s > 0 ? out.on_true : s < 0 ? out.on_false : out.cut);
    }
    return out;
  }

  bool is_chosen(std::uint32_t c) const {
    return std::find(chosen_.begin(), chosen_.end(), c) != chosen_.end();
  }

  std::optional<std::uint32_t> select() const {
    using Cost = std::tuple<bool, std::size_t, std::size_t, std::size_t>;
    std::optional<std::uint32_t> best;
    Cost least;
    for (const std::uint32_t c : allowed_) {
      const Sides here = sides(c, sets_[at_]);
      if (!here.divide()) continue;
      const std::size_t difference = here.on_true > here.on_false ? here.on_true - here.on_false
                                                                  : here.on_false - here.on_true;
      const Cost cost{!is_chosen(c), difference, ~waiting_pairs(c), objects_cut(c)};
      if (best && !(cost < least)) continue;
      best = c;
      least = cost;
    }
    return best;
  }

  std::size_t waiting_pairs(std::uint32_t c) const {
    std::size_t pairs = 0;
    for (std::size_t s = at_ + 1; s < sets_.size(); ++s) {
      const Sides there = sides(c, sets_[s]);
      if (there.divide()) pairs += there.on_true * there.on_false;
    }
    return pairs;
  }

  std::size_t objects_cut(std::uint32_t c) const {
    std::size_t cut = 0;
    for (std::uint32_t b = 0; b < table_.bodies().size(); ++b) cut += table_.side(c, b) == 0;
    return cut;
  }

  std::uint32_t add(const Candidate& candidate) {
    allowed_.push_back(table_.add(candidate));
    return allowed_.back();
  }

  // A plane that divides the bodies, from their edges and corners.
  std::optional<Candidate> further_candidate(const Set& set) const {
    std::optional<Candidate> found;
    std::uint64_t tried = 0;
    const auto take = [&](const Candidate& candidate) {
      ++tried;
      if (candidate_divides(candidate.plane, set)) found = candidate;
      return !found;
    };
    for (std::size_t i = 0; i < set.size() && !found && tried < kMostEdgePlanes; ++i)
      for (std::size_t j = 0; j < i && !found && tried < kMostEdgePlanes; ++j) {
        const Body &a = table_.bodies()[set[j]], &b = table_.bodies()[set[i]];
        for_each_edge_plane(a, b, {Origin::kEdges, a.object, b.object}, take);
      }
    if (found) return found;
    std::vector<const Body*> bodies;
    for (const std::uint32_t b : set) bodies.push_back(&table_.bodies()[b]);
    if (corner_planes(bodies) <= kMostCornerPlanes) for_each_corner_plane(bodies, take);
    return found;
  }

  bool candidate_divides(const Plane& plane, const Set& set) const {
    bool on_true = false, on_false = false;
    for (const std::uint32_t b : set) {
      const Where at = where(plane, table_.bodies()[b]);
      if (at == Where::kCut || at == Where::kIn) return false;
      on_true = on_true || at == Where::kTrue;
      on_false = on_false || at == Where::kFalse;
    }
    return on_true && on_false;
  }

  void choose(std::uint32_t c) {
    if (!is_chosen(c)) chosen_.push_back(c);
  }

  // The TRUE part takes the set's place, the FALSE part follows it.
  void part_set(std::uint32_t c) {
    choose(c);
    Set on_true, on_false;
    for (const std::uint32_t b : sets_[at_])
      (table_.side(c, b) > 0 ? on_true : on_false).push_back(b);
    for (const std::uint32_t t : on_true)
      for (const std::uint32_t f : on_false) out_.pairs.push_back({c, t, f});
    sets_[at_] = std::move(on_true);
    sets_.insert(sets_.begin() + static_cast<std::ptrdiff_t>(at_) + 1, std::move(on_false));
  }

  void without_division() {
    part_each_pair();
    if (const auto pairs = pair_by_pair(table_, sets_[at_])) {
      for (const PartedPair& pair : *pairs) {
        choose(pair.candidate);
        out_.pairs.push_back(pair);
      }
      out_.pair_by_pair = true;
      ++at_;
      return;
    }
    split_set();
  }

  // Sees to it that each two of the set are parted by some candidate.
  void part_each_pair() {
    const Set set = sets_[at_];
    for (std::size_t i = 0; i < set.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto parts = [&](std::uint32_t c) {
          return table_.side(c, set[i]) * table_.side(c, set[j]) < 0;
        };
        if (std::any_of(allowed_.begin(), allowed_.end(), parts)) continue;
        const auto further = further_candidate({set[j], set[i]});
        if (!further)
          throw NotApart(table_.bodies()[set[j]].object, table_.bodies()[set[i]].object);
        add(*further);
      }
  }

  void split_set() {
    using Cost = std::tuple<bool, std::size_t, std::size_t>;
    std::optional<std::uint32_t> best;
    Cost least;
    for (const std::uint32_t c : allowed_) {
      const Sides here = sides(c, sets_[at_]);
      if (here.on_true == 0 || here.on_false == 0) continue;
      const std::size_t difference = here.on_true > here.on_false ? here.on_true - here.on_false
                                                                  : here.on_false - here.on_true;
      const Cost cost{!can_split(c), here.cut, difference};
      if (best && !(cost < least)) continue;
      best = c;
      least = cost;
    }
    const Set set = sets_[at_];
    for (const std::uint32_t b : set)
      if (table_.side(*best, b) == 0) split_body(b, *best);
    part_set(*best);
  }

  bool can_split(std::uint32_t c) const {
    return std::all_of(sets_[at_].begin(), sets_[at_].end(), [&](std::uint32_t b) {
      return table_.side(c, b) != 0 || table_.bodies()[b].convex;
    });
  }

  void split_body(std::uint32_t b, std::uint32_t c) {
    const Body& body = table_.bodies()[b];
    if (!body.convex) throw NotToBeSplit(body.object);
    auto [on_true, on_false] = split(table_.candidates()[c].plane, body);
    const std::uint32_t made = table_.replace(b, std::move(on_false), std::move(on_true));
    out_.splits.push_back({b, made, c});
    sets_[at_].push_back(made);
    // Wherever the body lay, both its parts lie.
    const std::vector<PartedPair> before = out_.pairs;
    for (const PartedPair& pair : before) {
      if (pair.on_true == b) out_.pairs.push_back({pair.candidate, made, pair.on_false});
      if (pair.on_false == b) out_.pairs.push_back({pair.candidate, pair.on_true, made});
    }
  }

  SideTable& table_;
  Set allowed_, chosen_;
  std::vector<Set> sets_;
  std::size_t at_ = 0;
  DividedTable out_;
};

}  // namespace

NotApart::NotApart(std::uint32_t a, std::uint32_t b)
    : std::runtime_error("no plane parts objects " + std::to_string(a) + " and " +
                         std::to_string(b) + ": they reach into each other") {}

NotToBeSplit::NotToBeSplit(std::uint32_t object)
    : std::runtime_error("object " + std::to_string(object) +
                         " would have to be split, but is no closed convex body") {}

DividedTable divide(SideTable& table) { return Divider(table).run(); }

}  // namespace cigsim::separation_planes
