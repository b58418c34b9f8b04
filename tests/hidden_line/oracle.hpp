// SPDX-License-Identifier: MIT
// What hides a point, by rational arithmetic along the ray from the eye: an oracle of hidden lines
// that knows nothing of edges, outlines and separation planes.
#pragma once

#include <string>

#include "models/hidden_line/hidden_lines.hpp"

namespace cigsim::test {

enum class Sight { kClear, kHidden, kBoundary };

/// Whether the part lies between the eye and the point. A solid hides when its interior does; with
/// the eye in it or on it, it does not. Of a figure the boundary is told apart, and a point in its
/// plane is never hidden by it.
Sight hides(const hidden_line::Part& part, const Vec3& eye, const ExactVec& point);

struct SampleCounts {
  std::uint64_t samples = 0, boundary = 0, hidden = 0;
};

/// Compares pieces (computed with the hidden ones) with the oracle at points within them; says what
/// is wrong, or "". Points out of view do not count. Also: pieces of an edge must follow one
/// another without gap, and vertices that two edges reach must agree. `per_piece` points a piece.
std::string check_pieces(const hidden_line::HiddenLines& lines, const ViewTransform& view,
                         int per_piece, SampleCounts& counts);

/// Compares the invisibility of the vertices with the number of solids that hide them. For worlds
/// of solids alone.
std::string check_invisibility(const hidden_line::HiddenLines& lines, const ViewTransform& view);

/// A view from `eye` towards `target`, 60 degrees, 1024 x 1024.
ViewTransform view_from(const Vec3& eye, const Vec3& target);

/// Parts of an environment whose systems stand still.
hidden_line::PartSet parts_of(const Environment& environment);

}  // namespace cigsim::test
