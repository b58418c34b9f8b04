// SPDX-License-Identifier: MIT
// Objects as the separation program sees them: corners, exact however often they have been cut.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "models/environment/environment.hpp"
#include "models/numeric/plane.hpp"

namespace cigsim::separation_planes {

/// A point, and its exact place where a cut made it and doubles do not hold it.
struct Corner {
  Vec3 rounded;
  std::optional<ExactVec> exact;
};

struct Body {
  std::uint32_t object = 0;  ///< number of the object that it is, or is a part of, from 1
  bool part = false;
  std::vector<Corner> corners;
  std::vector<std::vector<std::uint32_t>> faces;  ///< anticlockwise as seen from outside
  bool convex = false;                            ///< closed and convex: it can be split
};

/// The body of an object. Its faces are repaired as preparation does; those of an object that is no
/// convex body stay as they are.
Body body_of(const Object& object, std::uint32_t number);

/// The body as an object, corners rounded: where that moves them, with the faces of their hull.
Object object_of(const Body& body, const std::string& name);

/// Where a body lies at a plane, exactly. Touching the plane does not count.
enum class Where : std::int8_t { kFalse = -1, kCut = 0, kTrue = 1, kIn = 2 };
Where where(const Plane& plane, const Body& body);

/// The TRUE and the FALSE part of a convex body that the plane cuts; each is closed by a face in
/// the plane.
std::array<Body, 2> split(const Plane& plane, const Body& body);

}  // namespace cigsim::separation_planes
