// SPDX-License-Identifier: MIT
#include "benchmarks/mesa_context.hpp"

#include <cstddef>
#include <cstdlib>
#include <stdexcept>

namespace cigsim::benchmarks {
namespace {

constexpr double kNear = 1, kFar = 1e5;

const char* text(GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); }

OSMesaContext create_context() {
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  setenv("LP_NUM_THREADS", "1", 1);
  return OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
}

}  // namespace

MesaContext::MesaContext(const Mesh& mesh, const Raster& raster,
                         std::vector<std::uint32_t>& elements)
    : raster_(raster), elements_(elements), context_(create_context()) {
  if (context_ == nullptr) throw std::runtime_error("OSMesa gives no context");
  make_current();
  if (description().find("llvmpipe") == std::string::npos)
    throw std::runtime_error("OSMesa does not draw with llvmpipe but with " + description());
  OSMesaPixelStore(OSMESA_Y_UP, 0);
  load(mesh);
  glViewport(0, 0, raster.width, raster.height);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glDisable(GL_DITHER);
  glShadeModel(GL_FLAT);
}

MesaContext::~MesaContext() { OSMesaDestroyContext(context_); }

void MesaContext::make_current() {
  if (OSMesaGetCurrentContext() == context_) return;
  if (!OSMesaMakeCurrent(context_, elements_.data(), GL_UNSIGNED_BYTE, raster_.width,
                         raster_.height))
    throw std::runtime_error("OSMesa does not take the picture's memory");
}

void MesaContext::draw_mesh() {
  glDrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_SHORT, nullptr);
}

std::string MesaContext::description() const {
  return std::string(text(GL_RENDERER)) + ", OpenGL " + text(GL_VERSION);
}

void MesaContext::load(const Mesh& mesh) {
  if (4 * mesh.faces() > 0x10000)
    throw std::invalid_argument("the mesh has too many vertices for 16-bit indices");
  std::vector<MesaVertex> vertices;
  std::vector<GLushort> indices;
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const std::uint32_t number = mesh.numbers[f];
    const std::uint32_t colour = (mesh.colours[f] & 0xffffffu) | number << 24;
    for (std::size_t k = 4 * f; k < 4 * f + 4; ++k) {
      const float* p = mesh.positions.data() + 3 * k;
      vertices.push_back({{p[0], p[1], p[2]}, colour, number});
    }
    for (const std::size_t corner : {0, 1, 2, 0, 2, 3})
      indices.push_back(static_cast<GLushort>(4 * f + corner));
  }
  indices_ = static_cast<GLsizei>(indices.size());
  GLuint buffers[2];
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(MesaVertex)),
               vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLushort)),
               indices.data(), GL_STATIC_DRAW);
}

std::array<float, 16> clip_matrix(const ViewTransform& view, double up) {
  const Vec3 u = view.rotation.row[0], v = view.rotation.row[1], w = view.rotation.row[2];
  const double sx = 2 * view.focal / view.raster.width;
  const double sy = up * 2 * view.focal / view.raster.height;
  const double depth = (kFar + kNear) / (kFar - kNear), offset = -2 * kFar * kNear / (kFar - kNear);
  const auto column = [&](double a, double b, double c, double d) {
    return std::array<double, 4>{sx * b, sy * c, depth * a + d, a};
  };
  const std::array<double, 4> columns[] = {
      column(u.x, v.x, w.x, 0), column(u.y, v.y, w.y, 0), column(u.z, v.z, w.z, 0),
      column(-dot(u, view.eye), -dot(v, view.eye), -dot(w, view.eye), offset)};
  std::array<float, 16> matrix;
  for (std::size_t k = 0; k < 16; ++k) matrix[k] = static_cast<float>(columns[k / 4][k % 4]);
  return matrix;
}

std::array<float, 4> clear_colour(const Mesh& mesh) {
  std::array<float, 4> colour{};
  for (std::size_t k = 0; k < 3; ++k)
    colour[k] = static_cast<float>(mesh.background >> (8 * k) & 0xff) / 255;
  return colour;
}

}  // namespace cigsim::benchmarks
