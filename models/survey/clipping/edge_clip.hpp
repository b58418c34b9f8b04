// SPDX-License-Identifier: MIT
// Edge clipping (Sandor 1979, sec. 4.2): first against the view plane in the observer's frame, then
// in the view plane against the four sides of the screen.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "models/survey/clipping/observer.hpp"

namespace cigsim::survey {

/// Where a vertex lies, a bit each (equations 4.2.1).
enum : std::uint8_t { kRight = 1, kLeft = 2, kAbove = 4, kBelow = 8, kBehind = 16 };

template <class N>
std::uint8_t region(const Vec3T<N>& p, const ViewBox<N>& box) {
  const N wide(box.half_width * p.z), high(box.half_height * p.z);
  const N x(box.d * p.x), y(box.d * p.y);
  return static_cast<std::uint8_t>((wide - x < 0 ? kRight : 0) | (wide + x < 0 ? kLeft : 0) |
                                   (high - y < 0 ? kAbove : 0) | (high + y < 0 ? kBelow : 0) |
                                   (p.z - box.d < 0 ? kBehind : 0));
}

template <class N>
struct ScreenPoint {
  N x{}, y{};
  friend bool operator==(const ScreenPoint& a, const ScreenPoint& b) {
    return a.x == b.x && a.y == b.y;
  }
};

template <class N>
struct ScreenEdge {
  ScreenPoint<N> a, b;
};

/// The part of a screen edge within the screen, which is closed, or nothing. Of the edge's ends and
/// its meetings with the four lines of the sides it takes the two outermost that are on the edge
/// and within the screen.
template <class N>
std::optional<ScreenEdge<N>> clip_on_screen(const ScreenEdge<N>& edge, const ViewBox<N>& box) {
  const N &w = box.half_width, &h = box.half_height;
  const N dx(edge.b.x - edge.a.x), dy(edge.b.y - edge.a.y);
  std::optional<ScreenEdge<N>> seen;
  N first{}, last{};
  const auto take = [&](const N& q, const ScreenPoint<N>& p) {
    if (q < 0 || q > 1 || p.x > w || p.x < -w || p.y > h || p.y < -h) return;
    if (!seen) {
      seen = ScreenEdge<N>{p, p};
      first = last = q;
    } else if (q < first) {
      seen->a = p;
      first = q;
    } else if (q > last) {
      seen->b = p;
      last = q;
    }
  };
  take(N(0), edge.a);
  take(N(1), edge.b);
  for (const N& side : {N(w), N(-w)})
    if (dx != 0) {
      const N q((side - edge.a.x) / dx);
      take(q, {side, N(edge.a.y + q * dy)});
    }
  for (const N& side : {N(h), N(-h)})
    if (dy != 0) {
      const N q((side - edge.a.y) / dy);
      take(q, {N(edge.a.x + q * dx), side});
    }
  return seen;
}

/// The visible part of the edge from `a` to `b` of the observer's frame, on the screen, or nothing.
template <class N>
std::optional<ScreenEdge<N>> clip_edge(Vec3T<N> a, Vec3T<N> b, const ViewBox<N>& box) {
  const std::uint8_t ra = region(a, box), rb = region(b, box);
  if ((ra & rb) != 0) return std::nullopt;
  if (((ra | rb) & kBehind) != 0) {
    const N q((box.d - a.z) / (b.z - a.z));
    const Vec3T<N> meeting{N(a.x + (b.x - a.x) * q), N(a.y + (b.y - a.y) * q), box.d};
    ((ra & kBehind) != 0 ? a : b) = meeting;
  }
  const Vec3T<N> pa = perspective(a, box.d), pb = perspective(b, box.d);
  return clip_on_screen<N>({{pa.x, pa.y}, {pb.x, pb.y}}, box);
}

}  // namespace cigsim::survey
