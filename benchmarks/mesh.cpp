// SPDX-License-Identifier: MIT
#include "benchmarks/mesh.hpp"

#include <algorithm>
#include <stdexcept>

namespace cigsim::benchmarks {
namespace {

std::uint32_t packed(const Colour& c) {
  return 0xff000000u | std::uint32_t{c.b} << 16 | std::uint32_t{c.g} << 8 | c.r;
}

void add_set(const FaceSet& set, Mesh& mesh) {
  for (const Item& item : set.items)
    for (std::uint32_t f = item.first_face; f < item.first_face + item.face_count; ++f) {
      const PreparedFace& face = set.faces[f];
      if (face.corner_count != 3 && face.corner_count != 4)
        throw std::invalid_argument("the benchmark takes faces of three or four corners");
      for (std::uint32_t k = 0; k < 4; ++k) {
        const std::uint32_t corner = face.first_corner + std::min(k, face.corner_count - 1);
        const Vec3& v = set.vertices[item.first_vertex + set.corners[corner]];
        for (const double value : {v.x, v.y, v.z})
          mesh.positions.push_back(static_cast<float>(value));
      }
      mesh.colours.push_back(packed(face.colour));
      mesh.numbers.push_back(static_cast<std::uint16_t>(std::min(face.object, 65535u)));
    }
}

}  // namespace

Mesh make_mesh(const Database& database) {
  Mesh mesh;
  mesh.background = packed(database.background);
  add_set(database.systems[0].set, mesh);
  add_set(database.ground, mesh);
  return mesh;
}

}  // namespace cigsim::benchmarks
