// SPDX-License-Identifier: MIT
#include "models/environment/off_writer.hpp"

#include <charconv>
#include <string>

namespace cigsim {
namespace {

void append(std::string& line, double value) {
  char digits[40];
  line.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

void write_vertices(const Object& object, std::ostream& out) {
  std::string text;
  for (const Vec3& v : object.vertices) {
    append(text, v.x);
    text += ' ';
    append(text, v.y);
    text += ' ';
    append(text, v.z);
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
