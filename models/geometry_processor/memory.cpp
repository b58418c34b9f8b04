// SPDX-License-Identifier: MIT
#include "models/geometry_processor/memory.hpp"

#include <stdexcept>
#include <string>

#include "models/machine/scale.hpp"
#include "models/numeric/unit_normal.hpp"

namespace cigsim::geometry_processor {
namespace {

Word word(std::size_t value) { return static_cast<Word>(value); }

void check(std::uint32_t count, std::uint32_t capacity, const char* what, const char* figure,
           const MachineDescription& machine) {
  if (capacity == 0 || count <= capacity) return;
  throw std::invalid_argument(std::string(what) + " " + std::to_string(count) +
                              ", and the geometry processor of machine '" + machine.name +
                              "' holds " + std::to_string(capacity) + " (" + figure +
                              "); divide it or take another machine");
}

}  // namespace

FaceMemory::FaceMemory(const FaceSet& set, int scale, const MachineDescription& machine) {
  items.reserve(set.items.size() * kItemWords);
  vertices.reserve(set.vertices.size() * kVertexWords);
  faces.reserve(set.faces.size() * kFaceWords);
  corners.reserve(set.corners.size());
  for (const Vec3& p : set.vertices)
    for (const double c : {p.x, p.y, p.z})
      vertices.push_back(coordinate_word(c, scale, machine.formats, overflows_));
  for (const std::uint32_t corner : set.corners) corners.push_back(word(corner));
  for (const PreparedFace& face : set.faces) add_face(set, face, machine.formats);
  for (const Item& item : set.items) add_item(set, item, machine);
}

void FaceMemory::add_face(const FaceSet& set, const PreparedFace& face,
                          const WordFormats& formats) {
  const Vec3 n = unit_normal(set.planes[face.plane]);
  const Colour& c = face.colour;
  faces.push_back(word(face.first_corner));
  faces.push_back(word(face.corner_count));
  for (const double element : {n.x, n.y, n.z}) faces.push_back(direction_word(element, formats));
  faces.push_back(face.two_sided);
  faces.push_back(word(face.object));
  faces.push_back(c.r | c.g << 8 | c.b << 16);
}

void FaceMemory::add_item(const FaceSet& set, const Item& item, const MachineDescription& machine) {
  const bool placeholder = item.face_count == 0 && item.vertex_count == 0;  // never listed
  if (!placeholder && (item.face_count == 0 || item.vertex_count == 0))
    throw std::invalid_argument("an item of the database has no faces; prepare the scene anew");
  check(item.vertex_count, machine.vertex_capacity, "an item's vertices number", "vertex_capacity",
        machine);
  for (std::uint32_t f = 0; f < item.face_count; ++f)
    check(set.faces[item.first_face + f].corner_count, machine.corner_capacity,
          "a face's corners number", "corner_capacity", machine);
  items.push_back(word(item.first_face * kFaceWords));
  items.push_back(word(item.face_count));
  items.push_back(word(item.first_vertex * kVertexWords));
  items.push_back(word(item.vertex_count));
}

}  // namespace cigsim::geometry_processor
