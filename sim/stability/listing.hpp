// SPDX-License-Identifier: MIT
// A group of a few members and planes through the machine's own priority processor, in any format.
#pragma once

#include <span>
#include <vector>

#include "sim/stability/decision.hpp"

namespace cigsim::stability {

/// Separation planes with their TRUE/FALSE pairs: pairs[i] stands on planes[i].
struct Table {
  std::uint32_t members = 0;
  std::vector<PlaneDefinition> planes;
  std::vector<MemberPair> pairs;
};

struct Listing {
  std::vector<std::uint32_t> members;  ///< highest priority first
  bool fault = false;                  ///< counts were not unique
  friend bool operator==(const Listing&, const Listing&) = default;
};

/// The list from the view's eyepoint, all members in view.
Listing list(const Table& table, const ViewTransform& view, const Format& format);
/// From exact sides, by Stump's rule as it is written.
Listing exact_list(const Table& table, const Vec3& eye);

/// How far, in environment units, rounding to a machine's words may move an eyepoint against a
/// plane. Derived: half a unit of the coordinate word times the sum of the normal's elements, half
/// a unit of the direction word times that of the eyepoint's differences from the plane's point,
/// and half a unit of the distance.
double plane_bound_in_words(const PlaneDefinition& plane, const ViewTransform& view,
                            const Format& format);

}  // namespace cigsim::stability
