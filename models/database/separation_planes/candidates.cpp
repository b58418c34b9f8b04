// SPDX-License-Identifier: MIT
#include "models/database/separation_planes/candidates.hpp"

#include <set>

#include "models/database/polygon.hpp"

namespace cigsim::separation_planes {
namespace {

struct Edge {
  Vec3 from, to;
};

std::vector<Edge> edges_of(const Body& body) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> met;
  std::vector<Edge> edges;
  for (const auto& face : body.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto ends = std::minmax(face[i], face[(i + 1) % face.size()]);
      const Corner &a = body.corners[ends.first], &b = body.corners[ends.second];
      if (met.insert(ends).second && !a.exact && !b.exact) edges.push_back({a.rounded, b.rounded});
    }
  return edges;
}

}  // namespace

std::string text_of(const Origin& origin) {
  const std::string a = std::to_string(origin.a), b = std::to_string(origin.b);
  switch (origin.kind) {
    case Origin::kFace:
      return "face " + b + " of object " + a;
    case Origin::kCard:
      return "S card " + a;
    case Origin::kEdges:
      return "edges of objects " + a + " and " + b;
    default:
      return "corners of objects";
  }
}

std::vector<Candidate> published_candidates(const StumpDeck& deck) {
  std::vector<Candidate> out;
  for (std::uint32_t o = 0; o < deck.objects.size(); ++o) {
    const Object& object = deck.objects[o];
    for (std::uint32_t f = 0; f < object.faces.size(); ++f) {
      const auto corners = spanning_corners(object.vertices, object.faces[f].vertices);
      if (!corners) continue;
      const auto [a, b, c] = *corners;
      out.push_back({plane_through(object.vertices[a], object.vertices[b], object.vertices[c]),
                     {Origin::kFace, o + 1, f + 1}});
    }
  }
  for (std::uint32_t s = 0; s < deck.planes.size(); ++s) {
    const auto& [p1, p2, p3] = deck.planes[s];
    out.push_back({plane_through(p2, p1, p3), {Origin::kCard, s + 1, 0}});
  }
  return out;
}

void for_each_edge_plane(const Body& a, const Body& b, Origin origin,
                         const std::function<bool(const Candidate&)>& visit) {
  const std::vector<Edge> of_a = edges_of(a), of_b = edges_of(b);
  for (const Edge& e : of_a)
    for (const Edge& f : of_b)
      for (const Vec3& through : {e.from, f.from}) {
        const Plane plane = make_plane({through, e.from, e.to, f.from, f.to});
        if (has_normal(plane) && !visit({plane, origin})) return;
      }
}

std::uint64_t corner_planes(std::span<const Body* const> bodies) {
  std::uint64_t n = 0;
  for (const Body* body : bodies) n += body->corners.size();
  return n < 3 ? 0 : n * (n - 1) / 2 * (n - 2) / 3;
}

void for_each_corner_plane(std::span<const Body* const> bodies,
                           const std::function<bool(const Candidate&)>& visit) {
  std::vector<Vec3> corners;
  for (const Body* body : bodies)
    for (const Corner& corner : body->corners)
      if (!corner.exact) corners.push_back(corner.rounded);
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k) {
        const Plane plane = plane_through(corners[k], corners[j], corners[i]);
        if (has_normal(plane) && !visit({plane, {Origin::kCorners, 0, 0}})) return;
      }
}

SideTable::SideTable(std::vector<Body> bodies, std::vector<Candidate> candidates)
    : bodies_(std::move(bodies)) {
  for (const Candidate& candidate : candidates) add(candidate);
}

std::int8_t SideTable::side_of(const Plane& plane, const Body& body) const {
  const Where at = where(plane, body);
  return at == Where::kTrue ? 1 : at == Where::kFalse ? -1 : 0;
}

std::uint32_t SideTable::add(const Candidate& candidate) {
  candidates_.push_back(candidate);
  std::vector<std::int8_t>& sides = sides_.emplace_back();
  for (const Body& body : bodies_) sides.push_back(side_of(candidate.plane, body));
  return static_cast<std::uint32_t>(candidates_.size() - 1);
}

std::uint32_t SideTable::replace(std::uint32_t body, Body part, Body other) {
  bodies_[body] = std::move(part);
  bodies_.push_back(std::move(other));
  for (std::size_t c = 0; c < candidates_.size(); ++c) {
    sides_[c][body] = side_of(candidates_[c].plane, bodies_[body]);
    sides_[c].push_back(side_of(candidates_[c].plane, bodies_.back()));
  }
  return static_cast<std::uint32_t>(bodies_.size() - 1);
}

}  // namespace cigsim::separation_planes
