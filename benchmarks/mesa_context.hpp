// SPDX-License-Identifier: MIT
// An OSMesa context of llvmpipe on one thread with a mesh in static buffers.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <array>
#include <string>

#include "benchmarks/mesh.hpp"
#include "models/boundary/transactions.hpp"

namespace cigsim::benchmarks {

struct MesaVertex {
  float position[3];
  std::uint32_t colour;  ///< R, G, B and the low byte of the object number
  std::uint32_t number;
};

class MesaContext {
 public:
  /// The default framebuffer is `elements`, rows from the top. Throws std::runtime_error when there
  /// is no llvmpipe, std::invalid_argument for a mesh too large for 16-bit indices.
  MesaContext(const Mesh& mesh, const Raster& raster, std::vector<std::uint32_t>& elements);
  ~MesaContext();
  MesaContext(const MesaContext&) = delete;
  MesaContext& operator=(const MesaContext&) = delete;

  void make_current();
  void draw_mesh();
  std::string description() const;

 private:
  void load(const Mesh& mesh);

  Raster raster_;
  std::vector<std::uint32_t>& elements_;
  OSMesaContext context_;
  GLsizei indices_ = 0;
};

/// Environment to clip coordinates, column by column; `up` is -1 for a picture upside down.
std::array<float, 16> clip_matrix(const ViewTransform& view, double up);

/// The background as GL takes it, with alpha 0.
std::array<float, 4> clear_colour(const Mesh& mesh);

}  // namespace cigsim::benchmarks
