// SPDX-License-Identifier: MIT
#include "benchmarks/mesa_packed.hpp"

#include <cstddef>
#include <stdexcept>

namespace cigsim::benchmarks {

MesaPacked::MesaPacked(const Mesh& mesh, const Raster& raster)
    : elements_(static_cast<std::size_t>(raster.width) * raster.height),
      context_(mesh, raster, elements_) {
  for (const std::uint16_t number : mesh.numbers)
    if (number > 255)
      throw std::invalid_argument("object numbers above 255 do not fit beside the colour");
  const std::array<float, 4> clear = clear_colour(mesh);
  glClearColor(clear[0], clear[1], clear[2], clear[3]);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  glVertexPointer(3, GL_FLOAT, sizeof(MesaVertex), nullptr);
  glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(MesaVertex),
                 reinterpret_cast<const void*>(offsetof(MesaVertex, colour)));
}

const std::vector<std::uint32_t>& MesaPacked::draw(const ViewTransform& view) {
  context_.make_current();
  glLoadMatrixf(clip_matrix(view, 1).data());
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  context_.draw_mesh();
  glFinish();
  return elements_;
}

}  // namespace cigsim::benchmarks
