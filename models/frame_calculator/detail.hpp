// SPDX-License-Identifier: MIT
// Levels of detail: which description of a choice is shown (Levine 1975, ch. II.G). The projected
// radius of the choice's sphere decides, Rp = f r/(f - z) in his axes; here the eyepoint is the
// origin, so that it is focal * radius / u with u the centre's distance along the line of sight.
// That radii count in elements is a reconstruction.
// docs/machine/frame_calculator.md gives the rules (FC4, FC5).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "models/environment/placement.hpp"

namespace cigsim::frame_calculator {

/// The description that is shown, from 0, the least detailed: the first whose threshold times
/// `scale` is not below the sphere's projected radius; the last, which has no threshold, if there
/// is none, and where the centre is not ahead of the eyepoint. Exact for the doubles given. `scale`
/// is finite and not negative; 0 always gives the last.
std::uint32_t description_shown(const Sphere& sphere, std::span<const double> thresholds,
                                const ViewTransform& view, double scale);

/// The choices of one hierarchy in one frame. Each is made when it is first asked for.
class Choices {
 public:
  /// All must outlive it. `place` stands a moving system in the environment; none: it stands still.
  Choices(const PriorityHierarchy& hierarchy, const ViewTransform& view, double scale,
          const Placing* place = nullptr)
      : hierarchy_(hierarchy), view_(view), scale_(scale), place_(place) {}

  /// The member of a choice's group that may be active.
  std::uint32_t member(const Group& group) {
    if (made_.empty()) made_.resize(hierarchy_.choices.size(), kNone);
    if (made_[group.choice] == kNone) made_[group.choice] = make(group.choice);
    return made_[group.choice];
  }

  /// Adds to `counts` how many choices were made for the 1st, 2nd, … description.
  void count(std::vector<std::uint32_t>& counts) const;

 private:
  std::uint32_t make(std::uint32_t choice) const;

  const PriorityHierarchy& hierarchy_;
  const ViewTransform& view_;
  const double scale_;
  const Placing* place_;
  std::vector<std::uint32_t> made_;  // by choice; kNone: not asked for
};

/// Which items of the set the choices show; all of those that stand in no choice.
std::vector<bool> items_shown(const PriorityHierarchy& hierarchy, std::size_t items,
                              Choices& choices);

}  // namespace cigsim::frame_calculator
