// SPDX-License-Identifier: MIT
// The faces of a prepared database as the quadrilaterals that the other renderers take.
#pragma once

#include <cstdint>
#include <vector>

#include "models/database/database.hpp"

namespace cigsim::benchmarks {

/// Face k has the vertices 4k .. 4k + 3, anticlockwise from its front.
struct Mesh {
  std::vector<float> positions;        ///< x, y, z
  std::vector<std::uint32_t> colours;  ///< of a face, as in Picture
  std::vector<std::uint16_t> numbers;  ///< of a face
  std::uint32_t background = 0;        ///< as in Picture

  std::size_t faces() const { return colours.size(); }
};

/// The static faces and the ground. Throws std::invalid_argument for a face that has not three or
/// four corners.
Mesh make_mesh(const Database& database);

}  // namespace cigsim::benchmarks
