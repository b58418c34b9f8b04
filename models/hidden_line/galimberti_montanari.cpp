// SPDX-License-Identifier: MIT
#include "models/hidden_line/galimberti_montanari.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "models/environment/input_error.hpp"
#include "models/environment/placement.hpp"

namespace cigsim::hidden_line {
namespace {

ExactVec exact(const CardsStructure& structure, std::uint32_t vertex) {
  return convert<Exact>(structure.vertices[vertex].position);
}

ExactVec inward_normal(const CardsStructure& structure, const CardsFace& face) {
  const ExactVec first = exact(structure, face.vertices[0]);
  ExactVec sum;
  for (std::size_t k = 1; k + 1 < face.vertices.size(); ++k)
    sum = sum + cross(exact(structure, face.vertices[k]) - first,
                      exact(structure, face.vertices[k + 1]) - first);
  return sum;
}

std::string edge_name(const CardsStructure& structure, const SolvedEdge& edge) {
  return std::to_string(structure.vertices[edge.ends[0]].tag) + "-" +
         std::to_string(structure.vertices[edge.ends[1]].tag);
}

// Row vectors of his transform: to the right, up, and along the line of sight.
struct Axes {
  Vec3 right, up, ahead;
};

Axes axes(const CardsView& view) {
  const double ct = cos_degrees(view.theta), st = sin_degrees(view.theta);
  const double cp = cos_degrees(view.phi), sp = sin_degrees(view.phi);
  return {{ct, 0, st}, {sp * st, cp, -sp * ct}, {cp * st, -sp, -cp * ct}};
}

Vec3 eye_of(const CardsView& view) { return axes(view).ahead * -(view.r + view.dr); }

}  // namespace

bool SolvedStructure::concave() const {
  return std::any_of(edges.begin(), edges.end(), [](const SolvedEdge& e) { return e.concave; });
}

SolvedStructure solve(const CardsStructure& structure, const std::string& name) {
  SolvedStructure out;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
  std::vector<int> sides;
  for (std::uint32_t f = 0; f < structure.faces.size(); ++f) {
    const CardsFace& face = structure.faces[f];
    const auto fail = [&](const std::string& what) { throw InputError(name, face.line, what); };
    out.normals.push_back(inward_normal(structure, face));
    const ExactVec& n = out.normals.back();
    if (sgn(n.x) == 0 && sgn(n.y) == 0 && sgn(n.z) == 0)
      fail("face " + std::to_string(face.label) +
           " has no area, so that it has no normal; remove it or move a corner");
    for (std::size_t i = 0; i < face.vertices.size(); ++i) {
      const std::uint32_t a = face.vertices[i], b = face.vertices[(i + 1) % face.vertices.size()];
      const auto [at, fresh] =
          known.emplace(std::minmax(a, b), static_cast<std::uint32_t>(out.edges.size()));
      if (fresh) {
        out.edges.push_back({{a, b}, {f, f}, false});
        sides.push_back(1);
        continue;
      }
      SolvedEdge& edge = out.edges[at->second];
      if (++sides[at->second] > 2)
        fail("edge " + edge_name(structure, edge) + " has a third face; an edge belongs to two");
      if (edge.ends[0] == a)
        fail("edge " + edge_name(structure, edge) +
             " is passed twice in the same direction; list the corners of every face clockwise as "
             "seen from outside");
      edge.faces[1] = f;
    }
  }
  for (std::size_t e = 0; e < out.edges.size(); ++e) {
    SolvedEdge& edge = out.edges[e];
    if (sides[e] != 2)
      throw InputError(name, structure.faces[edge.faces[0]].line,
                       "edge " + edge_name(structure, edge) +
                           " has one face only; an edge belongs to two, add the missing face");
    const ExactVec along = exact(structure, edge.ends[1]) - exact(structure, edge.ends[0]);
    edge.concave =
        sgn(dot(along, cross(out.normals[edge.faces[0]], out.normals[edge.faces[1]]))) > 0;
  }
  return out;
}

bool transpose(const CardsView& view, const Vec3& point, Vec2& out) {
  if (point == Vec3{}) {  // as his program has it
    out = {};
    return true;
  }
  const Axes a = axes(view);
  const double d = view.d + view.dd;
  const Vec3 v = point + a.ahead * (view.r + view.dr);
  const double depth = dot(v, a.ahead);
  if (!(depth > 0)) return false;
  // Where the ray meets the view plane, from its middle.
  const Vec3 t = v * (d / depth) - a.ahead * d;
  out = {dot(t, a.right), dot(t, a.up)};
  return std::isfinite(out.x) && std::isfinite(out.y);
}

HiddenEdges hide(const CardsStructure& structure, const SolvedStructure& solved,
                 const CardsView& view) {
  HiddenEdges out;
  const ExactVec eye = convert<Exact>(eye_of(view));
  std::vector<char> off_view(structure.faces.size());
  for (std::size_t f = 0; f < structure.faces.size(); ++f) {
    const ExactVec sight = exact(structure, structure.faces[f].vertices[0]) - eye;
    off_view[f] = sgn(dot(solved.normals[f], sight)) <= 0;
    out.off_view_faces += off_view[f];
  }
  for (std::uint32_t e = 0; e < solved.edges.size(); ++e) {
    const SolvedEdge& edge = solved.edges[e];
    const int off = off_view[edge.faces[0]] + off_view[edge.faces[1]];
    if (off == 2) {
      ++out.dropped;
      continue;
    }
    if (edge.concave && off == 1) {
      ++out.dropped_concave;
      continue;
    }
    DrawnEdge drawn{e, {}, {}};
    if (transpose(view, structure.vertices[edge.ends[0]].position, drawn.from) &&
        transpose(view, structure.vertices[edge.ends[1]].position, drawn.to))
      out.drawn.push_back(drawn);
    else
      ++out.behind_eye;
  }
  return out;
}

bool press(int key, CardsView& view, bool as_published) {
  if (key < 2 || key > 14) return false;
  const CardsView before = view;
  // Three keys for each quantity: forth, back, stop.
  struct Motion {
    double* increment;
    double amount;
  };
  const Motion motions[] = {{&view.dtheta, 2}, {&view.dphi, 2}, {&view.dr, 0.25}, {&view.dd, 0.2}};
  if (key == 2) {
    for (const Motion& m : motions) *m.increment = 0;
  } else {
    const Motion& m = motions[(key - 3) / 3];
    *m.increment = m.amount * (key % 3 == 0 ? 1 : key % 3 == 1 ? -1 : 0);
  }
  if (!as_published) {
    view.r += before.dr - view.dr;
    view.d += before.dd - view.dd;
  }
  return true;
}

void step(CardsView& view, bool as_published) {
  view.theta += view.dtheta;
  view.phi += view.dphi;
  if (as_published) return;
  // A picture stands at r + dr.
  if (view.r + 2 * view.dr > 0) view.r += view.dr;
  if (view.d + 2 * view.dd > 0) view.d += view.dd;
}

}  // namespace cigsim::hidden_line
