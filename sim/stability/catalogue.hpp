// SPDX-License-Identifier: MIT
// The decisions one by one; decisions() lists them.
#pragma once

#include "sim/stability/decision.hpp"

namespace cigsim::stability {

// Preparation.
Decision convexity_decision();
Decision hull_decision();
Decision sphere_decision();
// Frame calculator.
Decision retrieval_decision();
// Priority processor.
Decision side_decision();
Decision listability_decision();
// Geometry processor.
Decision facing_decision();
Decision hither_decision();
Decision pyramid_decision();
Decision projection_decision();
Decision edge_decision();
// Edge orderer.
Decision crossing_order_decision();

/// A yes or no.
inline Outcome answer(bool right) { return {right ? Verdict::kRight : Verdict::kWrong, {}, {}}; }
/// A yes or no with what is claimed of it: `border` is how far the truth is from changing.
inline Outcome answer(bool right, double border, std::optional<double> bound) {
  return {right ? Verdict::kRight : Verdict::kWrong, right ? 0 : border, bound};
}

/// f(format) for each.
template <class F>
std::vector<Outcome> in_each(std::span<const Format> formats, F f) {
  std::vector<Outcome> out;
  for (const Format& format : formats) out.push_back(f(format));
  return out;
}

}  // namespace cigsim::stability
