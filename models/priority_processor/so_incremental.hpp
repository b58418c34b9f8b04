// SPDX-License-Identifier: MIT
// The separating-object matrix of one group (Levine 1975, ch. VI.E) kept up to date plane by plane,
// as rtl/priority_processor/so_update.sv keeps it: two counts a pair, the planes that have the
// first nearer and those that have the second nearer. An eye that crosses a plane changes the pairs
// which that plane parts, and nothing else. A reconstruction.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "models/database/database.hpp"

namespace cigsim::priority_processor {

/// What keeping the matrix took. Cycles as so_update.sv takes them: for a plane that is crossed
/// one, and one for each member that it tells of.
struct SoUpdateWork {
  std::uint64_t crossings = 0, pairs = 0, cycles = 0;
};

class SoIncremental {
 public:
  /// For `members` (at most kGroupCapacity) and the planes of `nodes`, which must outlive it. No
  /// plane parts anybody yet.
  SoIncremental(std::span<const SeparationNode> nodes, std::uint32_t members)
      : nodes_(nodes), members_(members) {}

  /// `eye_true`: bit n is set when the eyepoint is on the TRUE side of node n's plane.
  void move(std::uint64_t eye_true, SoUpdateWork& work) {
    const std::uint64_t all =
        nodes_.size() == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << nodes_.size()) - 1;
    const std::uint64_t crossed = told_ ? (eye_true ^ eye_true_) & all : all;
    for (std::uint64_t rest = crossed; rest != 0; rest &= rest - 1) {
      const int n = std::countr_zero(rest);
      cross(nodes_[static_cast<std::size_t>(n)], (eye_true >> n & 1) != 0, work);
    }
    told_ = true;
    eye_true_ = eye_true;
  }

  /// Members that may hide member `m`: those on the near side of a plane that has `m` beyond it,
  /// and of which no plane has `m` on the near side.
  std::uint64_t hidden(std::uint32_t m) const { return nearer_[m] & ~beyond_[m]; }
  /// Members that `m` may hide.
  std::uint64_t hides(std::uint32_t m) const { return beyond_[m] & ~nearer_[m]; }
  std::uint32_t members() const { return members_; }

 private:
  void cross(const SeparationNode& node, bool eye_true, SoUpdateWork& work) {
    const std::uint64_t near = eye_true ? node.true_members : node.false_members;
    const std::uint64_t far = eye_true ? node.false_members : node.true_members;
    for (std::uint64_t rest = near; rest != 0; rest &= rest - 1)
      for (std::uint64_t others = far; others != 0; others &= others - 1)
        turn(static_cast<std::uint32_t>(std::countr_zero(rest)),
             static_cast<std::uint32_t>(std::countr_zero(others)));
    const auto told = static_cast<unsigned>(std::popcount(near) + std::popcount(far));
    ++work.crossings;
    work.pairs += static_cast<std::uint64_t>(std::popcount(near)) *
                  static_cast<std::uint64_t>(std::popcount(far));
    work.cycles += 1 + told;
  }

  // A plane that had `far` nearer, or was not told of before, has `near` nearer.
  void turn(std::uint32_t near, std::uint32_t far) {
    const std::uint64_t near_bit = std::uint64_t{1} << near, far_bit = std::uint64_t{1} << far;
    ++count_[near][far];
    beyond_[near] |= far_bit;
    nearer_[far] |= near_bit;
    if (!told_ || --count_[far][near] > 0) return;
    beyond_[far] &= ~near_bit;
    nearer_[near] &= ~far_bit;
  }

  using Counts = std::array<std::uint8_t, kGroupCapacity>;

  std::span<const SeparationNode> nodes_;
  std::uint32_t members_;
  bool told_ = false;
  std::uint64_t eye_true_ = 0;
  /// [l][m]: planes that have l on the near side and m beyond.
  std::array<Counts, kGroupCapacity> count_{};
  std::array<std::uint64_t, kGroupCapacity> nearer_{}, beyond_{};
};

}  // namespace cigsim::priority_processor
