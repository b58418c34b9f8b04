// SPDX-License-Identifier: MIT
// What a format drew, held against the rays.
#pragma once

#include "sim/stability/drawing.hpp"
#include "sim/stability/sight.hpp"

namespace cigsim::stability {

/// What the geometry processor claims for doubles: no projected edge is off by more, in elements
/// (models/geometry_processor/functional.hpp).
inline constexpr double kDoubleClaim = 0.001;

/// What rounding to a machine's words may move a whole triangle's edges by, in elements across the
/// edge. Derived: u, v, w of a corner are off by half a unit for the corner and for the eyepoint in
/// each coordinate, by half a unit of the direction word times the differences, and by half a unit;
/// its column by width/2 · (both errors over u, and a quotient's last bit) and half a unit of the
/// raster word, its line likewise; an edge's start and slope by half a unit each, or on a single
/// line by a quotient's last bit of its length. None: a corner may be cut off by the hither plane.
std::optional<double> picture_bound_in_words(const Triangle& triangle, const ViewTransform& view,
                                             const Format& format);

/// Whether each line shows the elements that it must, for one triangle; `error` is the largest
/// distance of a crossing from the true border, on lines that both cover, and of elements that are
/// missing, or too many, the way from their samples to the nearest border.
Outcome judge_cover(const Drawing& drawing, std::uint32_t triangle, const Sight& sight,
                    const Raster& raster, std::optional<double> bound);

/// The claim for a format: of doubles kDoubleClaim, of words the derived one where the triangle is
/// whole, of exact and certified pictures 0, of float none.
std::optional<double> picture_bound(const Triangle& triangle, const Sight& sight,
                                    const ViewTransform& view, const Format& format);

}  // namespace cigsim::stability
