// SPDX-License-Identifier: MIT
// Properties of the generated scenes, checked with rational arithmetic written out here.
#include "models/environment/generate.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

namespace cigsim {
namespace {

struct Q3 {
  mpq_class x, y, z;
};
Q3 q(const Vec3& v) { return {v.x, v.y, v.z}; }
Q3 minus(const Q3& a, const Q3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Q3 times(const Q3& a, const Q3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
mpq_class dot_of(const Q3& a, const Q3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The side of v against the plane of the face's first three vertices.
int side_of(const Object& o, const Face& f, const Vec3& v) {
  const Q3 a = q(o.vertices[f.vertices[0]]);
  const Q3 n =
      times(minus(q(o.vertices[f.vertices[1]]), a), minus(q(o.vertices[f.vertices[2]]), a));
  return sgn(dot_of(n, minus(q(v), a)));
}

bool faces_are_planar(const Object& o) {
  return std::all_of(o.faces.begin(), o.faces.end(), [&](const Face& f) {
    return std::all_of(f.vertices.begin(), f.vertices.end(),
                       [&](auto v) { return side_of(o, f, o.vertices[v]) == 0; });
  });
}

/// Every vertex behind or on every face, and each directed edge once each way.
bool is_closed_and_convex(const Object& o) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Face& f : o.faces) {
    for (const Vec3& v : o.vertices)
      if (side_of(o, f, v) > 0) return false;
    for (std::size_t i = 0; i < f.vertices.size(); ++i)
      if (!edges.insert({f.vertices[i], f.vertices[(i + 1) % f.vertices.size()]}).second)
        return false;
  }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
    return edges.count({e.second, e.first}) == 1;
  });
}

/// True when a face's plane of either has the two convex solids on different sides (touching
/// allowed). Enough for solids with upright sides; others may need a plane through two edges.
bool share_no_volume(const Object& a, const Object& b) {
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const Face& f : one->faces)
      if (std::all_of(other->vertices.begin(), other->vertices.end(),
                      [&, o = one](const Vec3& v) { return side_of(*o, f, v) >= 0; }))
        return true;
  return false;
}

TEST(Generate, EveryKindHasTheCountAndDependsOnTheSeedAlone) {
  for (const GenerateKind& kind : generate_kinds())
    for (const std::uint32_t n : {1u, 2u, 7u, 48u, 200u, 1000u}) {
      const Environment e = generate_environment(kind.name, {n, 5});
      ASSERT_EQ(e.objects.size(), n) << kind.name;
      EXPECT_EQ(e, generate_environment(kind.name, {n, 5})) << kind.name;
      if (kind.name != "cubes" && n > 20) {
        EXPECT_NE(e.objects, generate_environment(kind.name, {n, 6}).objects) << kind.name;
      }
    }
  EXPECT_THROW(generate_environment("town", {}), std::invalid_argument);
  EXPECT_THROW(generate_environment("city", {0, 1}), std::invalid_argument);
}

TEST(Generate, SolidsAreClosedConvexAndExactlyPlanar) {
  for (const char* kind : {"city", "cubes", "random", "brushes"})
    for (const Object& o : generate_environment(kind, {300, 11}).objects) {
      ASSERT_TRUE(faces_are_planar(o)) << kind << " " << o.name;
      ASSERT_TRUE(is_closed_and_convex(o)) << kind << " " << o.name;
    }
  for (const Object& o : generate_environment("soup", {300, 11}).objects)
    ASSERT_TRUE(faces_are_planar(o)) << o.name;
}

TEST(Generate, CityCubesAndBrushesShareNoVolume) {
  for (const char* kind : {"city", "cubes", "brushes"}) {
    const Environment e = generate_environment(kind, {150, 4});
    for (std::size_t i = 0; i < e.objects.size(); ++i)
      for (std::size_t j = i + 1; j < e.objects.size(); ++j)
        ASSERT_TRUE(share_no_volume(e.objects[i], e.objects[j])) << kind << " " << i << " " << j;
  }
}

TEST(Generate, RandomSolidsLieEachInACellOfItsOwn) {
  const Environment e = generate_environment("random", {400, 9});
  std::set<std::tuple<double, double, double>> cells;
  double least = 1e9, most = 0;
  for (const Object& o : e.objects) {
    Vec3 low = o.vertices[0], high = low;
    for (const Vec3& v : o.vertices) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    const Vec3 size = high - low;
    least = std::min(least, std::max({size.x, size.y, size.z}));
    most = std::max(most, std::max({size.x, size.y, size.z}));
    const auto cell = [](const Vec3& v) {
      return std::tuple(std::floor((v.x + 512) / 1024), std::floor((v.y + 512) / 1024),
                        std::floor((v.z + 512) / 1024));
    };
    EXPECT_EQ(cell(low), cell(high)) << o.name;
    EXPECT_TRUE(cells.insert(cell(low)).second) << o.name;
  }
  EXPECT_GT(most / least, 300) << "sizes span decades";
}

TEST(Generate, LevinesCubesStandWhereHisListSays) {
  const auto places = [](std::uint32_t n) {
    std::set<std::tuple<double, double, double>> set;
    for (const Object& o : generate_environment("cubes", {n, 1}).objects) {
      const Vec3 low =
          *std::min_element(o.vertices.begin(), o.vertices.end(), [](const Vec3& a, const Vec3& b) {
            return std::tuple(a.x, a.y, a.z) < std::tuple(b.x, b.y, b.z);
          });
      set.insert({low.x + 0.5, low.y + 0.5, low.z + 0.5});
    }
    return set;
  };
  const auto lattice = [](int nx, int ny, int nz) {
    std::set<std::tuple<double, double, double>> set;
    for (int x = 0; x < nx; ++x)
      for (int y = 0; y < ny; ++y)
        for (int z = 0; z < nz; ++z) set.insert({3.0 * x, 3.0 * y, 3.0 * z});
    return set;
  };
  EXPECT_EQ(places(4), lattice(2, 1, 2));
  EXPECT_EQ(places(8), lattice(2, 2, 2));
  EXPECT_EQ(places(16), lattice(4, 2, 2));
  EXPECT_EQ(places(24), lattice(4, 2, 3));
  EXPECT_EQ(places(32), lattice(4, 2, 4));
  EXPECT_EQ(places(48), lattice(4, 4, 3));
  EXPECT_EQ(places(64), lattice(4, 4, 4));
  EXPECT_EQ(places(125), lattice(5, 5, 5));
}

TEST(Generate, BrushesTouch) {
  const Environment e = generate_environment("brushes", {100, 2});
  std::size_t touching = 0;
  for (const Object& a : e.objects)
    touching += std::any_of(e.objects.begin(), e.objects.end(), [&](const Object& b) {
      return &a != &b && std::any_of(a.vertices.begin(), a.vertices.end(), [&](const Vec3& v) {
        return std::all_of(b.faces.begin(), b.faces.end(),
                           [&](const Face& f) { return side_of(b, f, v) <= 0; });
      });
    });
  EXPECT_GT(touching, 90u);
}

TEST(Generate, TheDefaultViewSeesEveryVertex) {
  for (const GenerateKind& kind : generate_kinds())
    for (const std::uint32_t n : {1u, 16u, 200u}) {
      const Environment e = generate_environment(kind.name, {n, 1});
      ASSERT_TRUE(e.view);
      const double h = e.view->eye.heading * std::numbers::pi / 180;
      const double p = e.view->eye.pitch * std::numbers::pi / 180;
      const Vec3 ahead{std::sin(h) * std::cos(p), std::cos(h) * std::cos(p), std::sin(p)};
      const double least = std::cos(e.view->fov / 2 * std::numbers::pi / 180);
      for (const Object& o : e.objects)
        for (const Vec3& v : o.vertices) {
          const Vec3 d = v - e.view->eye.position;
          ASSERT_GT(dot(d, ahead), least * std::sqrt(dot(d, d))) << kind.name << n;
        }
    }
}

TEST(Generate, SoupPassesThroughItself) {
  const Environment e = generate_environment("soup", {200, 3});
  std::size_t crossings = 0;
  for (const Object& a : e.objects)
    for (const Object& b : e.objects) {
      const Face& f = b.faces[0];
      if (&a == &b || f.vertices.size() != 3) continue;
      // The edge from a's first to its second vertex against b's first triangle.
      const Vec3 &s = a.vertices[0], &t = a.vertices[1];
      if (side_of(b, f, s) * side_of(b, f, t) >= 0) continue;
      const Vec3 c[] = {b.vertices[f.vertices[0]], b.vertices[f.vertices[1]],
                        b.vertices[f.vertices[2]]};
      int signs = 0;
      for (int i = 0; i < 3; ++i)
        signs += sgn(
            dot_of(times(minus(q(c[i]), q(s)), minus(q(c[(i + 1) % 3]), q(s))), minus(q(t), q(s))));
      crossings += signs == 3 || signs == -3;
    }
  EXPECT_GT(crossings, 10u);
}

}  // namespace
}  // namespace cigsim
