// SPDX-License-Identifier: MIT
#include "models/database/separation_planes/body.hpp"

#include <algorithm>
#include <map>

#include "models/database/hull/hull.hpp"
#include "models/database/surface.hpp"

namespace cigsim::separation_planes {
namespace {

int side_of(const Plane& plane, const Corner& corner) {
  return corner.exact ? side(plane, corner.rounded, *corner.exact) : side(plane, corner.rounded);
}

ExactVec exact(const Corner& corner) {
  return corner.exact ? *corner.exact : convert<Exact>(corner.rounded);
}

Corner corner_between(const Plane& plane, const Corner& a, const Corner& b) {
  const ExactVec n = exact_normal(plane), p = convert<Exact>(plane.exact.p);
  const ExactVec at = exact(a), to = exact(b);
  const Exact da = dot(n, at - p), db = dot(n, to - p);
  const ExactVec cut = at + (to - at) * Exact(da / (da - db));
  Corner corner{{cut.x.get_d(), cut.y.get_d(), cut.z.get_d()}, std::nullopt};
  if (!(convert<Exact>(corner.rounded) == cut)) corner.exact = cut;
  return corner;
}

// Both parts of a cut, over one pool of corners.
class Cut {
 public:
  Cut(const Plane& plane, const Body& body) : plane_(plane), body_(body), pool_(body.corners) {
    for (const Corner& corner : body.corners) sides_.push_back(side_of(plane, corner));
  }

  std::array<Body, 2> run() {
    std::array<Faces, 2> parts;
    for (const Loop& face : body_.faces)
      for (int half = 0; half < 2; ++half) {
        Loop loop = clipped(face, half == 0 ? 1 : -1);
        if (!loop.empty()) parts[half].push_back(std::move(loop));
      }
    for (Faces& faces : parts) faces.push_back(cap(faces));
    return {body_with(parts[0]), body_with(parts[1])};
  }

 private:
  using Faces = std::vector<Loop>;

  // What of a face lies on the closed side `keep`; nothing when it has no corner inside it.
  Loop clipped(const Loop& face, int keep) {
    Loop out;
    bool inside = false;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
      const int sa = sides_[a] * keep, sb = sides_[b] * keep;
      if (sa >= 0) out.push_back(a);
      inside = inside || sa > 0;
      if (sa * sb < 0) out.push_back(between(a, b));
    }
    return inside ? out : Loop{};
  }

  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    const auto [at, made] =
        made_.emplace(std::minmax(a, b), static_cast<std::uint32_t>(pool_.size()));
    if (made) {
      pool_.push_back(corner_between(plane_, pool_[at->first.first], pool_[at->first.second]));
      sides_.push_back(0);
    }
    return at->second;
  }

  // The face in the plane: the edges there, turned round.
  Loop cap(const Faces& faces) const {
    std::map<std::uint32_t, std::uint32_t> next;
    for (const Loop& face : faces)
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
        if (sides_[a] == 0 && sides_[b] == 0) next[b] = a;
      }
    Loop loop;
    std::uint32_t at = next.begin()->first;
    while (loop.size() < next.size()) {
      loop.push_back(at);
      at = next.at(at);
    }
    return loop;
  }

  Body body_with(const Faces& faces) const {
    Body out{body_.object, true, {}, {}, true};
    std::map<std::uint32_t, std::uint32_t> index;
    for (const Loop& face : faces) {
      Loop& loop = out.faces.emplace_back();
      for (const std::uint32_t v : face) {
        const auto [at, made] = index.emplace(v, static_cast<std::uint32_t>(out.corners.size()));
        if (made) out.corners.push_back(pool_[v]);
        loop.push_back(at->second);
      }
    }
    return out;
  }

  const Plane& plane_;
  const Body& body_;
  std::vector<Corner> pool_;
  std::vector<int> sides_;  // by corner of the pool
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> made_;
};

// Corners that no face uses are none.
void add_used(Body& body, const std::vector<Vec3>& vertices, const std::vector<Loop>& loops) {
  std::map<std::uint32_t, std::uint32_t> index;
  for (const Loop& loop : loops) {
    std::vector<std::uint32_t>& face = body.faces.emplace_back();
    for (const std::uint32_t v : loop) {
      const auto [at, made] = index.emplace(v, static_cast<std::uint32_t>(body.corners.size()));
      if (made) body.corners.push_back({vertices[v], std::nullopt});
      face.push_back(at->second);
    }
  }
}

}  // namespace

Body body_of(const Object& object, std::uint32_t number) {
  Body body;
  body.object = number;
  Notices notices;
  const Surface surface = make_surface(object, notices);
  body.convex = surface.convex;
  std::vector<Loop> loops;
  if (surface.convex)
    for (const SurfaceFace& face : surface.faces) loops.push_back(face.loop);
  else
    for (const Face& face : object.faces) loops.push_back(face.vertices);
  add_used(body, surface.convex ? surface.vertices : object.vertices, loops);
  return body;
}

Object object_of(const Body& body, const std::string& name) {
  Object object;
  object.name = name;
  for (const Corner& corner : body.corners) object.vertices.push_back(corner.rounded);
  const bool exact = std::none_of(body.corners.begin(), body.corners.end(),
                                  [](const Corner& corner) { return corner.exact.has_value(); });
  const auto faces =
      exact ? body.faces : hull_facets(object.vertices, convex_hull(object.vertices));
  for (const auto& face : faces) object.faces.push_back({face, std::nullopt});
  return object;
}

Where where(const Plane& plane, const Body& body) {
  bool on_true = false, on_false = false;
  for (const Corner& corner : body.corners) {
    const int s = side_of(plane, corner);
    on_true = on_true || s > 0;
    on_false = on_false || s < 0;
    if (on_true && on_false) return Where::kCut;
  }
  return on_true ? Where::kTrue : on_false ? Where::kFalse : Where::kIn;
}

std::array<Body, 2> split(const Plane& plane, const Body& body) { return Cut(plane, body).run(); }

}  // namespace cigsim::separation_planes
