// SPDX-License-Identifier: MIT
// Moving models among the static separation planes.
//
// A moving model is prepared once, in its own axes. Each frame its items are placed, run down the
// static separation tree from the root, and are cut by a plane that passes through them. A piece
// that arrives at a static item is ordered against it by the planes of the item's faces. Pieces at
// the same place keep the order of their own model; models whose spheres are disjoint are ordered
// by the power of the eyepoint with respect to the spheres, which orders disjoint spheres without a
// circuit (the plane of equal power separates them); models whose spheres meet are partitioned
// afresh for the frame. Of choices among the static items, and of the moving models' own, only the
// description that is shown takes part.
#pragma once

#include "models/boundary/transactions.hpp"
#include "models/database/partition.hpp"
#include "models/frame_calculator/retrieval.hpp"

namespace cigsim::frame_calculator {

/// Finds the places of all moving pieces, for the view in `out`; `choices` are those of the static
/// hierarchy, `detail` is the scale of thresholds for those of the moving ones, which `out` counts.
/// `forced` receives the static members that the pieces refer to, so that these are active even
/// when out of view.
void place_moving_models(const Database& database, double frame, double detail, Choices& choices,
                         ActiveEnvironment& out, FaceSet& set, ForcedMembers& forced);

}  // namespace cigsim::frame_calculator
