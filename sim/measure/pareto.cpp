// SPDX-License-Identifier: MIT
#include "sim/measure/pareto.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace cigsim {

std::vector<bool> pareto_front(std::span<const Vec2> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(points[a].x, points[a].y) < std::tie(points[b].x, points[b].y);
  });
  std::vector<bool> front(points.size());
  // The last of the front so far has the least y of all before.
  const Vec2* last = nullptr;
  for (const std::size_t i : order) {
    const Vec2& p = points[i];
    if (last != nullptr && p.y >= last->y && !(p.x == last->x && p.y == last->y)) continue;
    front[i] = true;
    last = &p;
  }
  return front;
}

}  // namespace cigsim
