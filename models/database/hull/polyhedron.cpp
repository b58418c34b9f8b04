// SPDX-License-Identifier: MIT
#include "models/database/hull/polyhedron.hpp"

namespace cigsim {

std::uint32_t Polyhedron::new_face(const HullTriangle& corner) {
  std::uint32_t place = static_cast<std::uint32_t>(faces_.size());
  if (free_.empty()) {
    faces_.emplace_back();
  } else {
    place = free_.back();
    free_.pop_back();
  }
  Face& face = faces_[place];
  face.plane = points_.plane(corner[2], corner[0], corner[1]);
  face.corner = corner;
  face.alive = true;
  face.visit = 0;
  return place;
}

void Polyhedron::start(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  const std::uint32_t abc = new_face({a, b, c}), bad = new_face({b, a, d}),
                      cbd = new_face({c, b, d}), acd = new_face({a, c, d});
  faces_[abc].neighbour = {bad, cbd, acd};
  faces_[bad].neighbour = {abc, acd, cbd};
  faces_[cbd].neighbour = {abc, bad, acd};
  faces_[acd].neighbour = {abc, cbd, bad};
  added_ = {abc, bad, cbd, acd};
}

void Polyhedron::set_neighbour(std::uint32_t face, std::uint32_t from, std::uint32_t neighbour) {
  Face& f = faces_[face];
  const std::size_t edge = f.corner[0] == from ? 0 : f.corner[1] == from ? 1 : 2;
  f.neighbour[edge] = neighbour;
}

void Polyhedron::build_cap(std::uint32_t apex) {
  for (const std::uint32_t place : removed_) faces_[place].alive = false;
  added_.clear();
  for (const RimEdge& edge : rim_) {
    const std::uint32_t place = new_face({edge.from, edge.to, apex});
    faces_[place].neighbour[0] = edge.beyond;
    set_neighbour(edge.beyond, edge.to, place);
    edge_face_[edge.from] = place;
    added_.push_back(place);
  }
  // The rim is a cycle: the face that starts where this one's edge ends is its neighbour.
  for (const std::uint32_t place : added_) {
    const std::uint32_t next = edge_face_[faces_[place].corner[1]];
    faces_[place].neighbour[1] = next;
    faces_[next].neighbour[2] = place;
  }
}

}  // namespace cigsim
