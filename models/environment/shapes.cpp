// SPDX-License-Identifier: MIT
#include "models/environment/shapes.hpp"

#include "models/numeric/plane.hpp"

namespace cigsim {

Object prism(const std::vector<Vec3>& base, const Vec3& up) {
  const auto n = static_cast<std::uint32_t>(base.size());
  Object object;
  object.vertices = base;
  for (const Vec3& v : base) object.vertices.push_back(v + up);
  Face bottom, top;
  for (std::uint32_t i = 0; i < n; ++i) {
    bottom.vertices.push_back(n - 1 - i);
    top.vertices.push_back(n + i);
  }
  object.faces = {bottom, top};
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    object.faces.push_back({{i, next, n + next, n + i}, {}});
  }
  return object;
}

Object box(const Vec3& low, const Vec3& high) {
  return prism({{low.x, low.y, low.z},
                {high.x, low.y, low.z},
                {high.x, high.y, low.z},
                {low.x, high.y, low.z}},
               {0, 0, high.z - low.z});
}

Object parallelepiped(const Vec3& centre, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 base = centre - c;
  return prism({base - a - b, base + a - b, base + a + b, base - a + b}, c + c);
}

Object hull(std::span<const Vec3> points) {
  const auto n = static_cast<std::uint32_t>(points.size());
  Object object;
  object.vertices.assign(points.begin(), points.end());
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = i + 1; j < n; ++j)
      for (std::uint32_t k = j + 1; k < n; ++k) {
        int outside = 0, inside = 0;
        for (std::uint32_t m = 0; m < n && (outside == 0 || inside == 0); ++m) {
          if (m == i || m == j || m == k) continue;
          const int where = orientation(points[i], points[j], points[k], points[m]);
          outside += where >= 0;
          inside += where <= 0;
        }
        if (outside == 0) object.faces.push_back({{i, j, k}, {}});
        if (inside == 0) object.faces.push_back({{i, k, j}, {}});
      }
  if (object.faces.size() != 2 * points.size() - 4) object.faces.clear();
  return object;
}

}  // namespace cigsim
