// SPDX-License-Identifier: MIT
// Solids, figures and wire frames of a scene.
#pragma once

#include <span>

#include "models/database/notices.hpp"
#include "models/hidden_line/part.hpp"

namespace cigsim::hidden_line {

/// Convex bodies become solids. Of every other body each face becomes a figure, seen from both
/// sides where the body is not closed; edges between faces that lie in one plane, or that the input
/// had as one, are drawn only as outline. An object that is one plane face stays one figure,
/// concave or not. Objects whose numbers are in `wires` become wire frames. Faces of the ground are
/// drawn and hide nothing; their number follows the objects'.
///
/// `placements` has a placement for each coordinate system of the environment. What is dropped or
/// repaired is counted in `notices`.
PartSet scene_parts(const Environment& environment, std::span<const Placement> placements,
                    std::span<const std::uint32_t> wires, Notices& notices);

/// The planes of a separation table made by hand, to be tried first.
std::vector<Plane> table_planes(const Environment& environment);

}  // namespace cigsim::hidden_line
