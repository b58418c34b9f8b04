// SPDX-License-Identifier: MIT
// Planes that a set of bodies may be divided by, and the bodies' sides at them, exactly.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "models/database/separation_planes/body.hpp"
#include "models/environment/deck.hpp"

namespace cigsim::separation_planes {

/// Where a candidate comes from.
struct Origin {
  enum Kind { kFace, kCard, kEdges, kCorners } kind = kFace;
  /// kFace: object and face, from 1. kCard: number of the S card. kEdges, kCorners: objects.
  std::uint32_t a = 0, b = 0;
};

struct Candidate {
  Plane plane;
  Origin origin;
};

/// "face 2 of object 1", "S card 3", …
std::string text_of(const Origin& origin);

/// Faces in the order of the cards, then S cards (Stump 1986, ch. III). The plane of a face passes
/// through three of its corners that are not on one line; faces without area give none.
std::vector<Candidate> published_candidates(const StumpDeck& deck);

/// Calls `visit` for the planes that contain an edge of one body and are parallel to an edge of the
/// other, until it returns false. Edges between cut corners are left out.
void for_each_edge_plane(const Body& a, const Body& b, Origin origin,
                         const std::function<bool(const Candidate&)>& visit);

/// The same for the planes through three corners of the bodies, not on one line.
void for_each_corner_plane(std::span<const Body* const> bodies,
                           const std::function<bool(const Candidate&)>& visit);

/// How many planes that are at most.
std::uint64_t corner_planes(std::span<const Body* const> bodies);

/// Candidates with the side of every body.
class SideTable {
 public:
  SideTable(std::vector<Body> bodies, std::vector<Candidate> candidates);

  const std::vector<Body>& bodies() const { return bodies_; }
  const std::vector<Candidate>& candidates() const { return candidates_; }
  /// +1 TRUE, -1 FALSE, 0 for a body that is cut or lies in the plane.
  int side(std::uint32_t candidate, std::uint32_t body) const { return sides_[candidate][body]; }
  std::uint32_t add(const Candidate& candidate);
  /// Puts `part` in the place of a body and adds `other`; returns the number of that.
  std::uint32_t replace(std::uint32_t body, Body part, Body other);

 private:
  std::int8_t side_of(const Plane& plane, const Body& body) const;

  std::vector<Body> bodies_;
  std::vector<Candidate> candidates_;
  std::vector<std::vector<std::int8_t>> sides_;
};

}  // namespace cigsim::separation_planes
