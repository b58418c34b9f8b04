// SPDX-License-Identifier: MIT
// What every mesh needs before it is an object of the scene.
#pragma once

#include "models/environment/environment.hpp"

namespace cigsim {

/// Makes vertices at the same place one, in the order of their first use, and drops those that no
/// face uses: formats split vertices by normals, texture or material, and closed meshes must be
/// closed again.
void join_vertices(Object& object);

/// Removes faces of fewer than three different vertices and returns how many there were.
std::uint64_t drop_degenerate_faces(Object& object);

}  // namespace cigsim
