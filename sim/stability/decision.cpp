// SPDX-License-Identifier: MIT
#include "sim/stability/decision.hpp"

#include "sim/stability/catalogue.hpp"

namespace cigsim::stability {

const std::vector<Decision>& decisions() {
  static const std::vector<Decision> all{
      convexity_decision(), hull_decision(),        sphere_decision(), retrieval_decision(),
      side_decision(),      listability_decision(), facing_decision(), hither_decision(),
      pyramid_decision(),   projection_decision(),  edge_decision(),   crossing_order_decision()};
  return all;
}

}  // namespace cigsim::stability
