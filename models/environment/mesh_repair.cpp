// SPDX-License-Identifier: MIT
#include "models/environment/mesh_repair.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace cigsim {

void join_vertices(Object& object) {
  std::vector<std::uint32_t> order(object.vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    const Vec3& v = object.vertices[i];
    return std::tuple(v.x, v.y, v.z, i);
  };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  std::vector<std::uint32_t> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && object.vertices[order[i]] == object.vertices[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> joined(order.size(), kNone);
  std::vector<Vec3> vertices;
  for (Face& face : object.faces)
    for (std::uint32_t& v : face.vertices) {
      std::uint32_t& place = joined[first[v]];
      if (place == kNone) {
        place = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(object.vertices[first[v]]);
      }
      v = place;
    }
  object.vertices = std::move(vertices);
}

namespace {

bool has_three_distinct(std::vector<std::uint32_t> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return std::unique(vertices.begin(), vertices.end()) - vertices.begin() >= 3;
}

}  // namespace

std::uint64_t drop_degenerate_faces(Object& object) {
  return std::erase_if(object.faces, [](const Face& f) { return !has_three_distinct(f.vertices); });
}

}  // namespace cigsim
