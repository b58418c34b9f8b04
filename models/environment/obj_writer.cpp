// SPDX-License-Identifier: MIT
#include <cstdio>
#include <string>

#include "models/environment/coordinates_text.hpp"
#include "models/environment/detail.hpp"
#include "models/environment/placement.hpp"
#include "models/environment/scene_writers.hpp"

namespace cigsim {
namespace {

std::string material(const std::optional<Colour>& colour) {
  if (!colour) return "rgb_none";
  char name[16];
  std::snprintf(name, sizeof name, "rgb_%02x%02x%02x", colour->r, colour->g, colour->b);
  return name;
}

/// A name that stays on its line.
std::string one_line(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < 0x20) c = '_';
  if (!name.empty() && name.back() == '\\') name.back() = '_';
  return name;
}

}  // namespace

void write_obj(const Environment& environment, std::ostream& out) {
  out << "# cigsim scene: x east, y north, z up\n";
  std::uint64_t base = 1;
  std::optional<Colour> colour;
  std::string text;
  for (const Object& object : environment.objects) {
    text.assign("o ").append(one_line(object.name)).append("\n");
    if (!is_most_detailed(environment, object)) {
      out << text;
      continue;
    }
    for (const Vec3& p : placed(object.vertices, first_placement(environment, object))) {
      text += "v ";
      append_coordinates(text, p);
      text += '\n';
    }
    for (const Face& face : object.faces) {
      if (face.colour != colour) text.append("usemtl ").append(material(face.colour)).append("\n");
      colour = face.colour;
      text += 'f';
      for (const std::uint32_t v : face.vertices)
        text.append(1, ' ').append(std::to_string(base + v));
      text += '\n';
    }
    out << text;
    base += object.vertices.size();
  }
}

}  // namespace cigsim
