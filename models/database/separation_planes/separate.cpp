// SPDX-License-Identifier: MIT
#include "models/database/separation_planes/separate.hpp"

#include <algorithm>
#include <unordered_set>

#include "models/database/separation_planes/fewest.hpp"
#include "models/database/separation_planes/published.hpp"
#include "models/environment/input_error.hpp"

namespace cigsim::separation_planes {
namespace {

constexpr std::size_t kMostSearched = 64;

std::vector<Body> bodies_of(const StumpDeck& deck) {
  std::vector<Body> bodies;
  for (std::uint32_t o = 0; o < deck.objects.size(); ++o)
    bodies.push_back(body_of(deck.objects[o], o + 1));
  return bodies;
}

SidePair sides_of(const Plane& plane, const std::vector<Body>& bodies) {
  SidePair out;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Where at = where(plane, bodies[b]);
    if (at == Where::kTrue) out.on_true |= std::uint64_t{1} << b;
    if (at == Where::kFalse) out.on_false |= std::uint64_t{1} << b;
  }
  return out;
}

struct SideHash {
  std::size_t operator()(const SidePair& p) const {
    return static_cast<std::size_t>(p.on_true * 0x9e3779b97f4a7c15u ^
                                    (p.on_false * 0xbf58476d1ce4e5b9u >> 7));
  }
};

// The planes that the search may use, the published candidates first.
class SearchSpace {
 public:
  SearchSpace(const std::vector<Body>& bodies, const std::vector<Candidate>& candidates,
              const SeparateOptions& options)
      : bodies_(bodies) {
    for (const Candidate& candidate : candidates) add(candidate);
    std::vector<const Body*> all;
    for (const Body& body : bodies) all.push_back(&body);
    complete_ = corner_planes(all) <= options.most_corner_planes &&
                std::all_of(bodies.begin(), bodies.end(), [](const Body& b) { return b.convex; });
    if (complete_)
      for_each_corner_plane(all, [&](const Candidate& candidate) {
        add(candidate);
        return true;
      });
    sides_ = maximal(list_);
  }

  bool complete() const { return complete_; }
  std::uint64_t tried() const { return tried_; }
  const std::vector<SidePair>& sides() const { return sides_; }
  const Candidate& candidate(std::uint32_t side) const {
    const auto at = std::find_if(list_.begin(), list_.end(),
                                 [&](const SidePair& p) { return turned(p) == sides_[side]; });
    return candidates_[static_cast<std::size_t>(at - list_.begin())];
  }

 private:
  void add(const Candidate& candidate) {
    ++tried_;
    const SidePair sides = sides_of(candidate.plane, bodies_);
    if (sides.on_true == 0 || sides.on_false == 0) return;
    if (!met_.insert(turned(sides)).second) return;
    list_.push_back(sides);
    candidates_.push_back(candidate);
  }

  const std::vector<Body>& bodies_;
  std::unordered_set<SidePair, SideHash> met_;
  std::vector<SidePair> list_, sides_;
  std::vector<Candidate> candidates_;
  std::uint64_t tried_ = 0;
  bool complete_ = false;
};

class Separation {
 public:
  Separation(const StumpDeck& deck, const SeparateOptions& options)
      : deck_(deck), options_(options), candidates_(published_candidates(deck)) {}

  SeparationResult run() {
    SideTable table(bodies_of(deck_), candidates_);
    DividedTable divided = divide(table);
    result_.greedy = divided.planes;
    result_.published = published_count();
    result_.pair_by_pair = divided.pair_by_pair;
    const bool whole = divided.splits.empty() && !divided.pair_by_pair;
    if (whole && deck_.objects.size() >= 2 && deck_.objects.size() <= kMostSearched) {
      if (auto better = search(table, divided.planes)) {
        take(better->first, better->second);
        return std::move(result_);
      }
    }
    take(table, divided);
    return std::move(result_);
  }

 private:
  std::optional<std::uint32_t> published_count() const {
    try {
      const PublishedTable table = PublishedProgram(deck_, "the deck").run();
      if (table.found) return static_cast<std::uint32_t>(table.planes.size());
    } catch (const InputError&) {  // it divides by zero
    }
    return std::nullopt;
  }

  // A division with fewer planes, with its own table of candidates.
  std::optional<std::pair<SideTable, DividedTable>> search(const SideTable& table,
                                                           std::uint32_t upper) {
    const SearchSpace space(table.bodies(), candidates_, options_);
    const Fewest fewest = fewest_planes(static_cast<std::uint32_t>(table.bodies().size()),
                                        space.sides(), upper, options_.most_steps);
    result_.least = LeastPlanes{fewest.any_table,  fewest.division, space.complete(),
                                fewest.by_pockets, space.tried(),   space.sides().size()};
    if (fewest.planes.empty()) return std::nullopt;
    std::vector<Candidate> few;
    for (const std::uint32_t side : fewest.planes) few.push_back(space.candidate(side));
    SideTable own(bodies_of(deck_), std::move(few));
    DividedTable divided = divide(own);
    return std::pair(std::move(own), std::move(divided));
  }

  void take(const SideTable& table, const DividedTable& divided) {
    result_.bodies = table.bodies();
    std::vector<std::uint32_t> place(table.candidates().size(), 0);
    for (const PartedPair& pair : divided.pairs) {
      if (place[pair.candidate] == 0) {
        const Candidate& candidate = table.candidates()[pair.candidate];
        result_.planes.push_back({candidate.plane, candidate.origin, {}});
        place[pair.candidate] = static_cast<std::uint32_t>(result_.planes.size());
      }
      result_.planes[place[pair.candidate] - 1].pairs.push_back(
          {pair.on_true + 1, pair.on_false + 1});
    }
    for (const Split& split : divided.splits)
      result_.splits.push_back({split.body + 1, split.new_body + 1, place[split.candidate]});
    prove();
  }

  void prove() {
    listability::PriorityTable table;
    table.members = static_cast<std::uint32_t>(result_.bodies.size());
    for (const ResultPlane& plane : result_.planes) {
      for (const auto& [t, f] : plane.pairs)
        table.pairs.push_back({static_cast<std::uint32_t>(table.planes.size()), t - 1, f - 1});
      table.planes.push_back(plane.plane);
    }
    result_.proof = listability::prove(table);
  }

  const StumpDeck& deck_;
  const SeparateOptions& options_;
  std::vector<Candidate> candidates_;
  SeparationResult result_;
};

}  // namespace

SeparationResult separate(const StumpDeck& deck, const SeparateOptions& options) {
  return Separation(deck, options).run();
}

}  // namespace cigsim::separation_planes
