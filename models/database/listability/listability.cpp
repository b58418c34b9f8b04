// SPDX-License-Identifier: MIT
#include "models/database/listability/listability.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace cigsim::listability {
namespace {

constexpr std::uint32_t kNoPlane = 0xffffffffu;

void check(const PriorityTable& table) {
  for (const auto& [plane, t, f] : table.pairs)
    if (plane >= table.planes.size() || t >= table.members || f >= table.members || t == f)
      throw std::invalid_argument("a pair names no member or plane, or one member twice");
}

// By two members whose pair stands once: its plane, and where the eye is when the first precedes.
class PairPlanes {
 public:
  PairPlanes(const PriorityTable& table, const std::vector<PairFault>& faults)
      : members_(table.members), sides_(members_ * members_, EyeSide{kNoPlane, false}) {
    for (const auto& [plane, t, f] : table.pairs) {
      sides_[at(t, f)] = {plane, true};
      sides_[at(f, t)] = {plane, false};
    }
    for (const PairFault& fault : faults)
      sides_[at(fault.a, fault.b)] = sides_[at(fault.b, fault.a)] = {kNoPlane, false};
  }
  const EyeSide& when_first(std::uint32_t a, std::uint32_t b) const { return sides_[at(a, b)]; }

 private:
  std::size_t at(std::uint32_t a, std::uint32_t b) const { return a * members_ + b; }

  std::size_t members_;
  std::vector<EyeSide> sides_;
};

struct Found {
  std::array<std::uint32_t, 3> members;
  std::array<EyeSide, 3> sides;

  int true_sides() const { return sides[0].eye_true + sides[1].eye_true + sides[2].eye_true; }
  friend bool operator<(const Found& a, const Found& b) {
    return std::make_tuple(a.true_sides(), a.members) < std::make_tuple(b.true_sides(), b.members);
  }
};

std::vector<PairFault> pair_faults(const PriorityTable& table) {
  const std::size_t n = table.members;
  std::vector<std::uint32_t> times(n * n, 0);
  for (const auto& [plane, t, f] : table.pairs) ++times[std::min(t, f) * n + std::max(t, f)];
  std::vector<PairFault> faults;
  for (std::uint32_t a = 0; a < n; ++a)
    for (std::uint32_t b = a + 1; b < n; ++b)
      if (times[a * n + b] != 1) faults.push_back({a, b, times[a * n + b]});
  return faults;
}

std::vector<EyeSide> all_sides(const PriorityTable& table, const ExactVec& eye) {
  std::vector<EyeSide> sides;
  for (std::uint32_t p = 0; p < table.planes.size(); ++p)
    sides.push_back({p, eye_is_true(table.planes[p], eye)});
  return sides;
}

std::vector<std::uint32_t> counts_of(const PriorityTable& table, std::uint64_t eye_true) {
  std::vector<std::uint32_t> counts(table.members, 0);
  for (const auto& [plane, t, f] : table.pairs) ++counts[eye_true >> plane & 1 ? f : t];
  return counts;
}

class Prover {
 public:
  Prover(const PriorityTable& table, const ProofOptions& options)
      : table_(table), options_(options), eyes_(table.planes), reach_(reach_of(table.planes)) {}

  Proof run() {
    proof_.pair_faults = pair_faults(table_);
    find_circuits();
    if (proof_.pair_faults.empty()) {
      proof_.listable = proof_.listable_with_all = found_.empty();
      if (!found_.empty()) witness_from(proof_.circuits.front().eye.exact);
    } else {
      count_with_all();
    }
    return std::move(proof_);
  }

 private:
  void find_circuits() {
    const PairPlanes planes(table_, proof_.pair_faults);
    const std::uint32_t n = table_.members;
    for (std::uint32_t a = 0; a < n; ++a)
      for (std::uint32_t b = a + 1; b < n; ++b)
        for (std::uint32_t c = b + 1; c < n; ++c) {
          ++proof_.triples;
          look(planes, {a, b, c});
          look(planes, {a, c, b});
        }
    std::sort(found_.begin(), found_.end());
    proof_.circuit_count = found_.size();
    for (const Found& f : found_) {
      if (proof_.circuits.size() == options_.most_circuits && !proof_.circuits.empty()) break;
      proof_.circuits.push_back({f.members, f.sides, witness_of(f)});
    }
  }

  void look(const PairPlanes& planes, const std::array<std::uint32_t, 3>& m) {
    const std::array<EyeSide, 3> sides{planes.when_first(m[0], m[1]), planes.when_first(m[1], m[2]),
                                       planes.when_first(m[2], m[0])};
    for (std::size_t k = 0; k < 3; ++k) {
      const EyeSide &s = sides[k], &next = sides[(k + 1) % 3];
      if (s.plane == kNoPlane) return;
      // No eye is on both sides of a plane; of a division every three have two pairs on one.
      if (s.plane == next.plane && s.eye_true != next.eye_true) return;
    }
    if (eyes_.can_see(sides)) found_.push_back({m, sides});
  }

  Eyepoint witness_of(const Found& f) const {
    const std::optional<ExactVec> point = eyes_.point_with(f.sides, reach_);
    if (!point) throw std::logic_error("two ways to decide whether an eyepoint exists disagree");
    return eyepoint_near(*point, table_.planes, f.sides);
  }

  void witness_from(const ExactVec& point) {
    const std::vector<EyeSide> sides = all_sides(table_, point);
    Eyepoint eye = eyepoint_near(point, table_.planes, sides);
    proof_.witness = Witness{std::move(eye), counts_at(table_, point)};
  }

  // Pairs stand twice or not at all.
  void count_with_all() {
    const std::uint64_t n = table_.members;
    if (table_.pairs.size() != n * (n - 1) / 2) {
      witness_from({0, 0, 0});
      return;
    }
    eyes_.for_each_cell([&](std::uint64_t eye_true, const CellPath& path) {
      ++proof_.cells;
      if (!is_permutation(counts_of(table_, eye_true))) witness_from(eyes_.point_of(path, reach_));
      return !proof_.witness;
    });
    proof_.listable_with_all = !proof_.witness;
  }

  const PriorityTable& table_;
  const ProofOptions& options_;
  Arrangement eyes_;
  Exact reach_;
  std::vector<Found> found_;
  Proof proof_;
};

}  // namespace

Proof prove(const PriorityTable& table, const ProofOptions& options) {
  check(table);
  return Prover(table, options).run();
}

std::vector<std::uint32_t> counts_at(const PriorityTable& table, const ExactVec& eye) {
  std::vector<bool> eye_true;
  for (const Plane& plane : table.planes) eye_true.push_back(eye_is_true(plane, eye));
  std::vector<std::uint32_t> counts(table.members, 0);
  for (const auto& [plane, t, f] : table.pairs) ++counts[eye_true[plane] ? f : t];
  return counts;
}

bool is_permutation(const std::vector<std::uint32_t>& counts) {
  std::vector<bool> met(counts.size(), false);
  for (const std::uint32_t c : counts) {
    if (c >= counts.size() || met[c]) return false;
    met[c] = true;
  }
  return true;
}

}  // namespace cigsim::listability
