// SPDX-License-Identifier: MIT
#include "models/database/polygon.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim {
namespace {

// Newell's normal, rounded: good enough to choose the axis along which the loop is largest.
Vec3 newell(std::span<const Vec3> vertices, const Loop& loop) {
  Vec3 n{};
  const Vec3 origin = vertices[loop[0]];
  for (std::size_t i = 0; i < loop.size(); ++i)
    n = n + cross(vertices[loop[i]] - origin, vertices[loop[(i + 1) % loop.size()]] - origin);
  return n;
}

double square(const Vec3& v) { return dot(v, v); }

bool inside_triangle(const FlatLoop& flat, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                     std::uint32_t p) {
  return flat.turn(a, b, p) >= 0 && flat.turn(b, c, p) >= 0 && flat.turn(c, a, p) >= 0;
}

bool is_ear(const FlatLoop& flat, const Loop& rest, std::size_t i) {
  const std::size_t n = rest.size();
  const std::uint32_t a = rest[(i + n - 1) % n], b = rest[i], c = rest[(i + 1) % n];
  if (flat.turn(a, b, c) <= 0) return false;
  for (const std::uint32_t p : rest) {
    if (p == a || p == b || p == c) continue;
    if (inside_triangle(flat, a, b, c, p)) return false;
  }
  return true;
}

}  // namespace

std::optional<FlatLoop> FlatLoop::make(std::span<const Vec3> vertices, const Loop& loop) {
  const Vec3 n = newell(vertices, loop);
  const double size[3] = {std::abs(n.x), std::abs(n.y), std::abs(n.z)};
  std::array<int, 3> axes{0, 1, 2};
  std::sort(axes.begin(), axes.end(), [&](int a, int b) { return size[a] > size[b]; });
  FlatLoop flat;
  flat.vertices_ = vertices;
  for (const int axis : axes) {
    flat.axis_ = axis;
    flat.mirrored_ = false;
    // The turn at a vertex that is extreme in the plane tells how a simple loop runs.
    const std::size_t count = loop.size();
    std::size_t least = 0;
    for (std::size_t i = 1; i < count; ++i) {
      const Vec2 p = flat.at(loop[i]), q = flat.at(loop[least]);
      if (p.x < q.x || (p.x == q.x && p.y < q.y)) least = i;
    }
    for (std::size_t step = 1; step < count; ++step) {
      const std::uint32_t before = loop[(least + count - step) % count];
      const std::uint32_t after = loop[(least + 1) % count];
      const int turn = flat.turn(before, loop[least], after);
      if (turn == 0) continue;
      flat.mirrored_ = turn < 0;
      return flat;
    }
    // Everything before it lies on one line with its successor: look at the other corners.
    for (std::size_t i = 0; i + 2 < count; ++i) {
      const int turn = flat.turn(loop[i], loop[i + 1], loop[i + 2]);
      if (turn == 0) continue;
      flat.mirrored_ = turn < 0;
      return flat;
    }
  }
  return std::nullopt;
}

Vec2 FlatLoop::at(std::uint32_t vertex) const {
  const Vec3& v = vertices_[vertex];
  const Vec2 p = axis_ == 0 ? Vec2{v.y, v.z} : axis_ == 1 ? Vec2{v.z, v.x} : Vec2{v.x, v.y};
  return mirrored_ ? Vec2{-p.x, p.y} : p;
}

std::optional<std::array<std::uint32_t, 3>> spanning_corners(std::span<const Vec3> vertices,
                                                             const Loop& loop) {
  const auto flat = FlatLoop::make(vertices, loop);
  if (!flat) return std::nullopt;
  const std::size_t n = loop.size();
  std::array<std::uint32_t, 3> best{};
  double best_area = -1;
  const auto consider = [&](std::size_t i, std::size_t j, std::size_t k) {
    const Vec3 a = vertices[loop[i]], b = vertices[loop[j]], c = vertices[loop[k]];
    const double area = square(cross(b - a, c - a));
    if (area > best_area && flat->turn(loop[i], loop[j], loop[k]) > 0) {
      best_area = area;
      best = {loop[i], loop[j], loop[k]};
    }
  };
  for (std::size_t i = 0; i < n; ++i) consider((i + n - 1) % n, i, (i + 1) % n);
  if (n > 4) consider(0, n / 3, 2 * n / 3);
  if (best_area < 0) return std::nullopt;
  return best;
}

bool on_plane(const Plane& plane, std::span<const Vec3> vertices, const Loop& loop) {
  return std::all_of(loop.begin(), loop.end(),
                     [&](std::uint32_t v) { return side(plane, vertices[v]) == 0; });
}

bool is_convex(const FlatLoop& flat, const Loop& loop) {
  const std::size_t n = loop.size();
  int reversals = 0;
  int last = 0, first = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t a = loop[i], b = loop[(i + 1) % n], c = loop[(i + 2) % n];
    const int turn = flat.turn(a, b, c);
    if (turn < 0) return false;
    const Vec2 p = flat.at(a), q = flat.at(b), r = flat.at(c);
    if (turn == 0 && (q.x - p.x) * (r.x - q.x) + (q.y - p.y) * (r.y - q.y) < 0) return false;
    const int along = p.x != q.x ? (q.x > p.x ? 1 : -1) : (q.y > p.y ? 1 : -1);
    if (last != 0 && along != last) ++reversals;
    if (first == 0) first = along;
    last = along;
  }
  if (last != first) ++reversals;
  return reversals <= 2;
}

Triangulation triangulate(const FlatLoop& flat, const Loop& loop) {
  Triangulation result;
  Loop rest = loop;
  std::size_t start = 0;
  while (rest.size() >= 3) {
    const std::size_t n = rest.size();
    std::size_t ear = n;
    for (std::size_t k = 0; k < n && ear == n; ++k)
      if (is_ear(flat, rest, (start + k) % n)) ear = (start + k) % n;
    if (ear == n) {
      // No ear: a straight corner may be passed over; otherwise the loop crosses itself.
      for (std::size_t i = 0; i < n && ear == n; ++i)
        if (flat.turn(rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]) == 0) ear = i;
      if (ear == n) {
        result.crossing = true;
        ear = 0;
      }
    }
    const std::uint32_t a = rest[(ear + n - 1) % n], b = rest[ear], c = rest[(ear + 1) % n];
    if (flat.turn(a, b, c) != 0) result.triangles.push_back({a, b, c});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
    start = ear;
  }
  return result;
}

std::vector<Loop> join_convex(const FlatLoop& flat, std::vector<Loop> pieces) {
  // Joins two pieces over a shared edge when the union is convex, until no pair can be joined.
  for (bool joined = true; joined;) {
    joined = false;
    for (std::size_t i = 0; i < pieces.size() && !joined; ++i) {
      for (std::size_t j = i + 1; j < pieces.size() && !joined; ++j) {
        for (std::size_t e = 0; e < pieces[i].size() && !joined; ++e) {
          const std::uint32_t a = pieces[i][e], b = pieces[i][(e + 1) % pieces[i].size()];
          const auto at = std::find(pieces[j].begin(), pieces[j].end(), b);
          if (at == pieces[j].end()) continue;
          const std::size_t f = static_cast<std::size_t>(at - pieces[j].begin());
          if (pieces[j][(f + 1) % pieces[j].size()] != a) continue;
          Loop both;
          for (std::size_t k = 1; k <= pieces[i].size(); ++k)
            both.push_back(pieces[i][(e + k) % pieces[i].size()]);
          for (std::size_t k = 2; k < pieces[j].size(); ++k)
            both.push_back(pieces[j][(f + k) % pieces[j].size()]);
          if (!is_convex(flat, both)) continue;
          pieces[i] = std::move(both);
          pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(j));
          joined = true;
        }
      }
    }
  }
  return pieces;
}

std::vector<Loop> bulge(std::span<const Vec3> vertices, const Loop& loop) {
  std::vector<Loop> triangles;
  // Each chain of the loop from `first` to `last` is closed by the edge between them, which is on
  // the hull; the third corner of its triangle is the one that leaves no other in front.
  std::vector<std::pair<std::size_t, std::size_t>> chains{{0, loop.size() - 1}};
  while (!chains.empty()) {
    const auto [first, last] = chains.back();
    chains.pop_back();
    if (last < first + 2) continue;
    std::size_t apex = first + 1;
    for (std::size_t k = first + 2; k < last; ++k)
      if (orientation(vertices[loop[first]], vertices[loop[apex]], vertices[loop[last]],
                      vertices[loop[k]]) > 0)
        apex = k;
    if (!collinear(vertices[loop[first]], vertices[loop[apex]], vertices[loop[last]]))
      triangles.push_back({loop[first], loop[apex], loop[last]});
    chains.emplace_back(first, apex);
    chains.emplace_back(apex, last);
  }
  return triangles;
}

}  // namespace cigsim
