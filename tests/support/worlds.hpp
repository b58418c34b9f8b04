// SPDX-License-Identifier: MIT
// Seeded random worlds whose right picture the oracle knows: every face is planar and convex.
#pragma once

#include <vector>

#include "models/environment/environment.hpp"
#include "models/environment/random.hpp"
#include "tests/support/ray_oracle.hpp"

namespace cigsim::test {

/// An environment of one model in system 0, and which of its objects are seen from both sides.
struct World {
  Environment environment;
  std::vector<bool> open;

  World();
  void add(Object object, bool is_open = false);
};

/// What the oracle sees of it.
std::vector<OraclePolygon> polygons_of(const World& world);

/// Turned boxes, prisms, tetrahedra and hulls that do not meet; radii over six decades.
World disjoint_world(Random& random, int objects);

/// A block of grid cells divided at random into boxes, wedges and tetrahedra that touch in faces,
/// edges and corners; some are left out.
World touching_world(Random& random);

/// Triangles that pass through each other, seen from both sides.
World triangle_soup(Random& random, int objects);

/// Bodies that pass through each other.
World body_soup(Random& random, int objects);

/// Boxes on a coarse grid: interpenetrating, with coplanar faces that overlap.
World grid_boxes(Random& random, int objects);

/// Polygons that overlap in a few common planes, and boxes with faces in these planes.
World coplanar_polygons(Random& random, int objects);

/// Hulls and triangles whose corners have coordinates 0, 1 and 2 only: planes, edges and corners
/// coincide all over.
World lattice_world(Random& random, int objects);

/// Bodies of grid cells stuck together: concave, with holes and cavities, touching themselves in
/// edges and corners; some lack a face and are seen from both sides.
World cell_bodies(Random& random, int objects);

/// Several worlds of other kinds in one place.
World mixed_world(Random& random);

/// Bodies within bodies.
World nested_world(Random& random);

}  // namespace cigsim::test
