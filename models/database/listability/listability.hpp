// SPDX-License-Identifier: MIT
// Proof that a table of separation planes with TRUE/FALSE pairs is listable from every eyepoint, or
// an eyepoint from which it is not (Stump 1986, ch. III, says what listable means; how to decide it
// is ours).
//
// A pair on a plane adds one to the count of its member on the side opposite the eye. A table of N
// members is listable when the counts are 0 .. N-1, each once, from every eyepoint.
//
// Claim 1. When every pair of members stands on exactly one plane, the counts at an eyepoint are
// 0 .. N-1 if and only if no three members form a circuit there.
//   The pairs are then a tournament: of two members exactly one precedes, and a member's count is
//   the number of those that precede it. If the counts are 0 .. N-1, the member with count 0
//   precedes all others; without it every other count is less by one, so by induction the table is
//   an order, and an order has no circuit. If there is no circuit of three, there is none at all:
//   of a shortest circuit a b c ... z with four members or more, either a precedes c and b can be
//   left out, or c precedes a and a b c is a shorter one. A tournament without circuit is an order,
//   and its counts are 0 .. N-1. (Moon 1968, ch. 6, has both.)
// Claim 2. Whether three members ever form a circuit depends on the three planes of their pairs.
//   a before b before c before a names a side of the eye at each of them. So the table is listable
//   if and only if for no three members and neither sense of going round an eyepoint with these
//   three sides exists; arrangement.hpp decides that in whole numbers. That are N (N-1) (N-2) / 3
//   decisions, however many cells the planes make.
// Claim 3. What holds for all members holds for those in view: leaving members out of an order
//   leaves an order. So such a table is right for every set of members in view too.
//
// A pair that stands on no plane, or twice, is a fault by itself: with these two alone in view the
// counts are 0 and 0, or 0 and 2, or 1 and 1, from every eyepoint. With all members in view:
//  - each pair of the table adds one to the sum of the counts, whatever the eyepoint. The sum of
//    0 .. N-1 is N (N-1) / 2. If the table has another number of pairs, every eyepoint is a
//    witness;
//  - if it has just that number (one pair twice for another that is missing), counts can be right
//    by accident. Then all combinations of sides over all planes are gone through.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "models/database/listability/eyepoint.hpp"

namespace cigsim::listability {

struct TablePair {
  std::uint32_t plane = 0, true_member = 0, false_member = 0;
};

/// Members are numbered from 0. A pair's two members differ.
struct PriorityTable {
  std::uint32_t members = 0;
  std::vector<Plane> planes;
  std::vector<TablePair> pairs;
};

/// Three members each of which precedes the next, and the last the first, seen from `eye`.
struct Circuit {
  std::array<std::uint32_t, 3> members{};  ///< the least first
  std::array<EyeSide, 3> sides{};          ///< at the plane of each and the next
  Eyepoint eye;
};

/// Two members whose pair does not stand on exactly one plane.
struct PairFault {
  std::uint32_t a = 0, b = 0, times = 0;
  friend bool operator==(const PairFault&, const PairFault&) = default;
};

/// An eyepoint from which the counts of all members are not 0 .. N-1.
struct Witness {
  Eyepoint eye;
  std::vector<std::uint32_t> counts;
};

struct Proof {
  /// Right from every eyepoint, whichever members are in view.
  bool listable = false;
  /// Right from every eyepoint with all members in view. Differs from `listable` only when there
  /// are pair faults.
  bool listable_with_all = false;
  std::vector<PairFault> pair_faults;
  /// The first circuits, those first that put the eye on the FALSE side of most planes.
  std::vector<Circuit> circuits;
  std::uint64_t circuit_count = 0;
  std::optional<Witness> witness;  ///< when not listable_with_all
  std::uint64_t triples = 0;       ///< of members, each decided in both senses
  std::uint64_t cells = 0;         ///< gone through, where pairs stand twice
};

struct ProofOptions {
  std::size_t most_circuits = 8;  ///< that get an eyepoint
};

/// Throws std::invalid_argument when a pair names no member or plane, or one member twice; and when
/// cells of more than kMostCellPlanes planes would have to be gone through.
Proof prove(const PriorityTable& table, const ProofOptions& options = {});

/// The counts of all members from an eyepoint.
std::vector<std::uint32_t> counts_at(const PriorityTable& table, const ExactVec& eye);

/// True when the counts are 0 .. n-1, each once.
bool is_permutation(const std::vector<std::uint32_t>& counts);

}  // namespace cigsim::listability
