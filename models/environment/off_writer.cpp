// SPDX-License-Identifier: MIT
#include "models/environment/off_writer.hpp"

#include <string>

#include "models/environment/coordinates_text.hpp"

namespace cigsim {
namespace {

void write_vertices(const Object& object, std::ostream& out) {
  std::string text;
  for (const Vec3& v : object.vertices) {
    append_coordinates(text, v);
    text += '\n';
  }
  out << text;
}

void write_faces(const Object& object, std::size_t base, std::ostream& out) {
  std::string text;
  for (const Face& face : object.faces) {
    text += std::to_string(face.vertices.size());
    for (const std::uint32_t v : face.vertices)
      text.append(1, ' ').append(std::to_string(base + v));
    text += '\n';
  }
  out << text;
}

}  // namespace

void write_off(const Environment& environment, std::ostream& out) {
  std::size_t vertices = 0, faces = 0, base = 0;
  for (const Object& object : environment.objects) {
    vertices += object.vertices.size();
    faces += object.faces.size();
  }
  out << "OFF\n" << vertices << ' ' << faces << " 0\n";
  for (const Object& object : environment.objects) write_vertices(object, out);
  for (const Object& object : environment.objects) {
    write_faces(object, base, out);
    base += object.vertices.size();
  }
}

}  // namespace cigsim
