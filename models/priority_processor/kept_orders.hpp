// SPDX-License-Identifier: MIT
// Coherence of priority between frames: an eyepoint that crosses no plane leaves every order as it
// was. A group's order is kept with the eyepoint that it was worked out for and a distance within
// which no plane lies that was asked; while the members in view are the same and the eyepoint stays
// within that distance, nothing is computed. No source tells of it: ours.
#pragma once

#include <cstdint>
#include <vector>

#include "models/numeric/vec3.hpp"
#include "models/priority_processor/group_order.hpp"

namespace cigsim::priority_processor {

/// What became of the groups with two active members or more, in one frame.
struct OrderingWork {
  std::uint64_t ordered_groups = 0;  ///< counted anew
  std::uint64_t reused_groups = 0;   ///< kept, because the eyepoint crossed none of their planes
  std::uint64_t tested_planes = 0;   ///< side tests
};

/// The order of one group for one set of active members.
class KeptOrder {
 public:
  GroupOrder order;
  std::uint64_t active = 0;    ///< members; never fewer than two once there is an order
  std::uint64_t eye_true = 0;  ///< nodes on whose TRUE side the eyepoint was

  /// Every plane that was asked has the same answer at all eyepoints nearer to `eye` than
  /// `clearance`.
  void set_eye(const Vec3& eye, double clearance) {
    // Squares neither overflow nor lose what matters; rounded down.
    constexpr double kLeast = 0x1p-400, kMost = 0x1p400, kSlack = 0x1p-48;
    eye_ = eye;
    const double c = clearance < kMost ? clearance : kMost;
    clearance_squared_ = c > kLeast ? c * c * (1 - kSlack) : 0;
  }
  /// True only if the sides at this eyepoint are certainly the same.
  bool stands_at(const Vec3& eye) const {
    if (eye == eye_) return true;
    constexpr double kSlack = 0x1p-48;
    const Vec3 d = eye - eye_;
    return dot(d, d) * (1 + kSlack) < clearance_squared_;
  }

 private:
  Vec3 eye_;
  double clearance_squared_ = 0;
};

/// Of the groups of one hierarchy: memory for those that were asked for, and one index a group.
class KeptOrders {
 public:
  /// Of a group, below `groups`. An order that was never set has no active members.
  KeptOrder& of(std::uint32_t group, std::size_t groups) {
    if (places_.size() != groups) {
      places_.assign(groups, kNone);
      kept_.clear();
    }
    std::uint32_t& place = places_[group];
    if (place == kNone) {
      place = static_cast<std::uint32_t>(kept_.size());
      kept_.emplace_back();
    }
    return kept_[place];
  }

 private:
  std::vector<std::uint32_t> places_;  // by group
  std::vector<KeptOrder> kept_;
};

}  // namespace cigsim::priority_processor
