// SPDX-License-Identifier: MIT
// How far an element of the raster is from the projected edges of two things.
#pragma once

#include <cstdint>
#include <span>

#include "models/geometry_processor/functional.hpp"

namespace cigsim::stability {

/// The distance, in elements, of the centre of element (column, row) from the nearest projected
/// edge of a face of object `a` or of object `b` among `items`; infinite without any. In doubles:
/// good to far less than an element as long as an element spans much more than an ulp of the
/// coordinates. Edges are followed to where they come abreast of the eyepoint.
double distance_to_edges(const ViewTransform& view, const geometry_processor::FrameSets& sets,
                         std::span<const ItemRef> items, std::uint32_t a, std::uint32_t b,
                         int column, int row);

}  // namespace cigsim::stability
