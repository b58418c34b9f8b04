// SPDX-License-Identifier: MIT
// What instances are made of: things at random, or the faces, planes, bodies and views of a scene.
#pragma once

#include <array>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "models/database/database.hpp"
#include "models/environment/random.hpp"
#include "models/numeric/plane.hpp"

namespace cigsim::stability {

using Triangle = std::array<Vec3, 3>;

/// A scene's own things in its own units. Empty lists stand for things at random, of about one unit
/// round the origin.
struct Material {
  std::vector<Triangle> triangles;        ///< three corners of each face, in its order
  std::vector<PlaneDefinition> planes;    ///< of separation and of faces
  std::vector<std::vector<Vec3>> bodies;  ///< the vertices of each item, four at least
  std::vector<Sphere> spheres;            ///< of items and groups
  std::vector<Vec3> eyepoints;            ///< that the scene is seen from
};

/// The static environment's. `eyepoints`: further ones beside the scene's default view.
Material material_of(const Database& database, const std::vector<Vec3>& eyepoints = {});

/// The largest coordinate of them, either way. Above kMostReach things leave the range of doubles
/// when they are scaled to their extremes.
double reach_of(const Material& material);
inline constexpr double kMostReach = 1e90;

}  // namespace cigsim::stability
