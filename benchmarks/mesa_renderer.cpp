// SPDX-License-Identifier: MIT
#include "benchmarks/mesa_renderer.hpp"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>

namespace cigsim::benchmarks {
namespace {

struct Vertex {
  float position[3];
  std::uint32_t colour;  ///< R, G, B, object number
};

constexpr double kNear = 1, kFar = 1e5;

// Column-major, from environment to clip coordinates.
std::array<double, 16> clip_matrix(const ViewTransform& view) {
  const Vec3 u = view.rotation.row[0], v = view.rotation.row[1], w = view.rotation.row[2];
  const double sx = 2 * view.focal / view.raster.width, sy = 2 * view.focal / view.raster.height;
  const double depth = (kFar + kNear) / (kFar - kNear), offset = -2 * kFar * kNear / (kFar - kNear);
  const double tu = -dot(u, view.eye), tv = -dot(v, view.eye), tw = -dot(w, view.eye);
  return {sx * v.x, sy * w.x, depth * u.x,         u.x,  //
          sx * v.y, sy * w.y, depth * u.y,         u.y,  //
          sx * v.z, sy * w.z, depth * u.z,         u.z,  //
          sx * tv,  sy * tw,  depth * tu + offset, tu};
}

float channel(std::uint32_t colour, int shift) {
  return static_cast<float>(colour >> shift & 0xff) / 255;
}

}  // namespace

class MesaRenderer::Impl {
 public:
  Impl(const Mesh& mesh, const Raster& raster)
      : picture_(static_cast<std::size_t>(raster.width) * raster.height) {
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("LP_NUM_THREADS", "1", 1);
    context_ = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
    if (context_ == nullptr) throw std::runtime_error("OSMesa gives no context");
    make_current(raster);
    if (description().find("llvmpipe") == std::string::npos)
      throw std::runtime_error("OSMesa does not draw with llvmpipe but with " + description());
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    load(mesh);
    glViewport(0, 0, raster.width, raster.height);
    glClearColor(channel(mesh.background, 0), channel(mesh.background, 8),
                 channel(mesh.background, 16), 0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glDisable(GL_DITHER);
    glShadeModel(GL_FLAT);
  }
  ~Impl() { OSMesaDestroyContext(context_); }

  const std::vector<std::uint32_t>& draw(const ViewTransform& view) {
    if (OSMesaGetCurrentContext() != context_) make_current(view.raster);
    glLoadMatrixd(clip_matrix(view).data());
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_SHORT, nullptr);
    glFinish();
    return picture_;
  }

  std::string description() const {
    return reinterpret_cast<const char*>(glGetString(GL_RENDERER)) + std::string(", OpenGL ") +
           reinterpret_cast<const char*>(glGetString(GL_VERSION));
  }

 private:
  void make_current(const Raster& raster) {
    if (!OSMesaMakeCurrent(context_, picture_.data(), GL_UNSIGNED_BYTE, raster.width,
                           raster.height))
      throw std::runtime_error("OSMesa does not take the picture's memory");
  }

  void load(const Mesh& mesh) {
    std::vector<Vertex> vertices;
    std::vector<GLushort> indices;
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
      if (mesh.numbers[f] > 255)
        throw std::invalid_argument("object numbers above 255 do not fit beside the colour");
      const std::size_t first = vertices.size();
      for (std::size_t k = 4 * f; k < 4 * f + 4; ++k)
        vertices.push_back(
            {{mesh.positions[3 * k], mesh.positions[3 * k + 1], mesh.positions[3 * k + 2]},
             (mesh.colours[f] & 0xffffffu) | std::uint32_t{mesh.numbers[f]} << 24});
      for (const std::size_t corner : {0, 1, 2, 0, 2, 3})
        indices.push_back(static_cast<GLushort>(first + corner));
    }
    indices_ = static_cast<GLsizei>(indices.size());
    GLuint buffers[2];
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                 vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof(GLushort)), indices.data(),
                 GL_STATIC_DRAW);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex), nullptr);
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex),
                   reinterpret_cast<const void*>(offsetof(Vertex, colour)));
  }

  std::vector<std::uint32_t> picture_;
  OSMesaContext context_ = nullptr;
  GLsizei indices_ = 0;
};

MesaRenderer::MesaRenderer(const Mesh& mesh, const Raster& raster)
    : impl_(std::make_unique<Impl>(mesh, raster)) {}
MesaRenderer::~MesaRenderer() = default;

const std::vector<std::uint32_t>& MesaRenderer::draw(const ViewTransform& view) {
  return impl_->draw(view);
}
std::string MesaRenderer::description() const { return impl_->description(); }

}  // namespace cigsim::benchmarks
