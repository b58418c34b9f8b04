// SPDX-License-Identifier: MIT
#include "models/database/face_set_builder.hpp"

#include <span>

#include "models/database/hierarchy.hpp"

namespace cigsim {

std::uint32_t FaceSetBuilder::add(const std::vector<std::uint32_t>& work_items) {
  local_.resize(work_.vertex_count(), kNone);
  plane_of_.resize(work_.planes.size(), kNone);
  Item item;
  item.first_face = static_cast<std::uint32_t>(out_.faces.size());
  item.first_vertex = static_cast<std::uint32_t>(out_.vertices.size());
  for (const std::uint32_t work_item : work_items) {
    const WorkItem& source = work_.items[work_item];
    for (std::uint32_t p = 0; p < source.polygon_count; ++p)
      add_face(work_.polygons[source.first_polygon + p], item.first_vertex);
  }
  for (const std::uint32_t v : used_) local_[v] = kNone;
  used_.clear();
  item.face_count = static_cast<std::uint32_t>(out_.faces.size()) - item.first_face;
  item.vertex_count = static_cast<std::uint32_t>(out_.vertices.size()) - item.first_vertex;
  item.sphere =
      enclosing(std::span<const Vec3>(out_.vertices).subspan(item.first_vertex, item.vertex_count));
  out_.items.push_back(item);
  return static_cast<std::uint32_t>(out_.items.size() - 1);
}

void FaceSetBuilder::add_placeholder() {
  Item item;
  item.first_face = static_cast<std::uint32_t>(out_.faces.size());
  item.first_vertex = static_cast<std::uint32_t>(out_.vertices.size());
  out_.items.push_back(item);
}

void FaceSetBuilder::add_face(const WorkPolygon& polygon, std::uint32_t first_vertex) {
  std::uint32_t& plane = plane_of_[polygon.plane];
  if (plane == kNone) {
    plane = static_cast<std::uint32_t>(out_.planes.size());
    out_.planes.push_back(work_.planes[polygon.plane]);
  }
  PreparedFace face;
  face.first_corner = static_cast<std::uint32_t>(out_.corners.size());
  face.corner_count = polygon.corner_count;
  face.plane = plane;
  face.object = polygon.origin.object;
  face.colour = polygon.origin.colour;
  face.two_sided = polygon.origin.two_sided;
  for (std::uint32_t c = 0; c < polygon.corner_count; ++c)
    out_.corners.push_back(local_vertex(work_.corners(polygon)[c], first_vertex));
  out_.faces.push_back(face);
}

std::uint32_t FaceSetBuilder::local_vertex(std::uint32_t v, std::uint32_t first_vertex) {
  if (local_[v] == kNone) {
    const auto index = static_cast<std::uint32_t>(out_.vertices.size());
    local_[v] = index - first_vertex;
    used_.push_back(v);
    if (const ExactVec* exact = work_.exact(v)) out_.cut_vertices.push_back({index, *exact});
    out_.vertices.push_back(work_.vertex(v));
  }
  return local_[v];
}

}  // namespace cigsim
