// SPDX-License-Identifier: MIT
#include "benchmarks/mesa_targets.hpp"

#include <cstddef>
#include <stdexcept>

namespace cigsim::benchmarks {
namespace {

constexpr const char* kVertexShader = R"(#version 130
uniform mat4 matrix;
in vec3 position;
in vec3 colour;
in uint number;
flat out vec3 face_colour;
flat out uint face_number;
void main() {
  gl_Position = matrix * vec4(position, 1.0);
  face_colour = colour;
  face_number = number;
}
)";
constexpr const char* kFragmentShader = R"(#version 130
flat in vec3 face_colour;
flat in uint face_number;
out vec4 picture;
out uint numbers;
void main() {
  picture = vec4(face_colour, 1.0);
  numbers = face_number;
}
)";

enum Attribute : GLuint { kPosition, kColour, kNumber };

void attach_shader(GLuint program, GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
}

GLuint use_program() {
  const GLuint program = glCreateProgram();
  attach_shader(program, GL_VERTEX_SHADER, kVertexShader);
  attach_shader(program, GL_FRAGMENT_SHADER, kFragmentShader);
  glBindAttribLocation(program, kPosition, "position");
  glBindAttribLocation(program, kColour, "colour");
  glBindAttribLocation(program, kNumber, "number");
  glBindFragDataLocation(program, 0, "picture");
  glBindFragDataLocation(program, 1, "numbers");
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) throw std::runtime_error("GL does not link the shaders");
  glUseProgram(program);
  return program;
}

void attach_target(GLenum attachment, GLenum format, const Raster& raster) {
  GLuint buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorage(GL_RENDERBUFFER, format, raster.width, raster.height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

void use_targets(const Raster& raster) {
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  attach_target(GL_COLOR_ATTACHMENT0, GL_RGBA8, raster);
  attach_target(GL_COLOR_ATTACHMENT1, GL_R16UI, raster);
  attach_target(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, raster);
  constexpr GLenum kTargets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glDrawBuffers(2, kTargets);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("GL does not take the two targets");
}

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

MesaTargets::MesaTargets(const Mesh& mesh, const Raster& raster)
    : clear_(clear_colour(mesh)),
      default_framebuffer_(static_cast<std::size_t>(raster.width) * raster.height),
      context_(mesh, raster, default_framebuffer_) {
  matrix_ = glGetUniformLocation(use_program(), "matrix");
  use_targets(raster);
  glFrontFace(GL_CW);  // the picture is upside down, so that it is read from the top
  constexpr GLsizei kStride = sizeof(MesaVertex);
  for (const GLuint attribute : {kPosition, kColour, kNumber}) glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(kPosition, 3, GL_FLOAT, GL_FALSE, kStride, nullptr);
  glVertexAttribPointer(kColour, 3, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                        offset(offsetof(MesaVertex, colour)));
  glVertexAttribIPointer(kNumber, 1, GL_UNSIGNED_INT, kStride,
                         offset(offsetof(MesaVertex, number)));
  clear_[3] = 1;
  picture_.width = raster.width;
  picture_.height = raster.height;
  picture_.colours.resize(default_framebuffer_.size());
  picture_.numbers.resize(default_framebuffer_.size());
}

const Picture& MesaTargets::draw(const ViewTransform& view) {
  context_.make_current();
  constexpr float kFarthest = 1;
  constexpr GLuint kNothing[4] = {};
  glUniformMatrix4fv(matrix_, 1, GL_FALSE, clip_matrix(view, -1).data());
  glClearBufferfv(GL_COLOR, 0, clear_.data());
  glClearBufferuiv(GL_COLOR, 1, kNothing);
  glClearBufferfv(GL_DEPTH, 0, &kFarthest);
  context_.draw_mesh();
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glReadPixels(0, 0, picture_.width, picture_.height, GL_RGBA, GL_UNSIGNED_BYTE,
               picture_.colours.data());
  glReadBuffer(GL_COLOR_ATTACHMENT1);
  glReadPixels(0, 0, picture_.width, picture_.height, GL_RED_INTEGER, GL_UNSIGNED_SHORT,
               picture_.numbers.data());
  return picture_;
}

}  // namespace cigsim::benchmarks
