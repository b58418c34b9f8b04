// SPDX-License-Identifier: MIT
// Edges of certified frames against those of exact ones: the same faces, the same edges, the same
// lines, and the same element on every line; and error bounds against the errors that exact numbers
// show.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>

#include "models/database/prepare.hpp"
#include "models/edge_orderer/list_stepper.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/geometry_processor/functional_certified.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/viewpoints.hpp"
#include "tests/support/worlds.hpp"

namespace cigsim::test {
namespace {

using geometry_processor::Functional;

struct Tally {
  std::uint64_t vertices = 0, vertices_redone = 0, faces = 0, faces_redone = 0, crossings = 0,
                crossings_redone = 0;
  std::uint64_t wrong = 0;   // lists that are not the exact ones
  double largest_share = 0;  // of an error in its bound

  std::string text() const {
    return std::to_string(vertices_redone) + " of " + std::to_string(vertices) + " vertices, " +
           std::to_string(faces_redone) + " of " + std::to_string(faces) + " faces, " +
           std::to_string(crossings_redone) + " of " + std::to_string(crossings) +
           " crossings redone; errors up to " + std::to_string(largest_share) + " of their bounds";
  }
};

// The largest error of the column, over the lines of an edge, as a share of its bound. Only of
// edges whose bound says something.
double share_of_bound(const Edge<Certified>& edge, const Edge<Exact>& exact) {
  if (!(edge.bound < 0.5)) return 0;
  double worst = 0;
  for (const int k :
       {0, (edge.end_line - edge.first_line) / 2, edge.end_line - edge.first_line - 1}) {
    const double at = edge.x + edge.slope * k;
    const Exact off = abs(Exact(at) - (exact.x + exact.slope * k));
    if (sgn(off) != 0) worst = std::max(worst, edge.bound > 0 ? off.get_d() / edge.bound : 1e9);
  }
  return worst;
}

// True when both lists are the same, decision by decision.
bool same(const EdgeList<Certified>& list, const EdgeList<Exact>& exact, const Raster& raster,
          Tally& tally) {
  if (list.faces.size() != exact.faces.size() || list.edges.size() != exact.edges.size())
    return false;
  for (std::size_t f = 0; f < list.faces.size(); ++f) {
    const RasterFace &a = list.faces[f], &b = exact.faces[f];
    if (a.object != b.object || a.first_edge != b.first_edge || a.edge_count != b.edge_count ||
        a.first_line != b.first_line || a.end_line != b.end_line)
      return false;
  }
  edge_orderer::ListStepper<Certified> stepper;
  stepper.begin();
  std::vector<std::int32_t> got(raster.height), want(raster.height);
  bool good = true;
  for (std::uint32_t e = 0; e < list.edges.size(); ++e) {
    const Edge<Certified>& a = list.edges[e];
    const Edge<Exact>& b = exact.edges[e];
    if (a.first_line != b.first_line || a.end_line != b.end_line || a.left != b.left) return false;
    // In two bands, as the painter takes them.
    const int middle = (a.first_line + a.end_line) / 2;
    stepper.step(list, e, a.first_line, middle, raster.width, got.data());
    stepper.step(list, e, middle, a.end_line, raster.width, got.data() + (middle - a.first_line));
    edge_orderer::step_edge(b, b.first_line, b.end_line, raster.width, want.data());
    const int lines = a.end_line - a.first_line;
    good = good && std::equal(got.begin(), got.begin() + lines, want.begin());
    tally.crossings += static_cast<std::uint64_t>(lines);
    tally.largest_share = std::max(tally.largest_share, share_of_bound(a, b));
  }
  tally.crossings_redone += stepper.redone();
  return good;
}

// All items of a set, from one viewpoint.
void compare(const FaceSet& set, const ViewTransform& view, double caution, Tally& tally) {
  std::vector<ItemRef> items;
  for (std::uint32_t i = 0; i < set.items.size(); ++i) items.push_back({SetId::kStatic, i});
  Functional<Exact> exact_geometry;
  Functional<Certified> geometry(caution);
  EdgeList<Exact> exact;
  EdgeList<Certified> list;
  exact_geometry.compute(view, {&set, nullptr, nullptr}, items, exact);
  geometry.compute(view, {&set, nullptr, nullptr}, items, list);
  tally.wrong += !same(list, exact, view.raster, tally);
  tally.vertices += list.redone.vertices;
  tally.vertices_redone += list.redone.vertices_redone;
  tally.faces += list.redone.faces;
  tally.faces_redone += list.redone.faces_redone;
}

World world_of_kind(int kind, Random& random) {
  switch (kind % 8) {
    case 0:
      return disjoint_world(random, 8);
    case 1:
      return touching_world(random);
    case 2:
      return triangle_soup(random, 6);
    case 3:
      return grid_boxes(random, 5);
    case 4:
      return coplanar_polygons(random, 5);
    case 5:
      return lattice_world(random, 5);
    case 6:
      return cell_bodies(random, 2);
    default:
      return nested_world(random);
  }
}

// Every coordinate of the world times `scale`, plus `offset`.
void move(World& world, double scale, const Vec3& offset) {
  for (Object& object : world.environment.objects)
    for (Vec3& v : object.vertices) v = v * scale + offset;
}

Tally worlds(std::uint64_t seed, int count, double caution, double scale = 1,
             const Vec3& offset = {}) {
  Tally tally;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t own = seed + static_cast<std::uint64_t>(i);
    SCOPED_TRACE("seed " + std::to_string(own));
    Random random(own);
    World world = world_of_kind(i, random);
    move(world, scale, offset);
    const Database database = prepare(world.environment);
    for (int v = 0; v < 4; ++v) {
      Viewpoint viewpoint = random_viewpoint(world.environment, random);
      const ViewTransform view =
          frame_calculator::view_transform(viewpoint, random_raster(random, 48));
      const std::uint64_t wrong = tally.wrong;
      compare(database.systems[0].set, view, caution, tally);
      EXPECT_TRUE(caution == 0 || tally.wrong == wrong) << "view " << v;
    }
  }
  std::cout << tally.text() << "\n";
  return tally;
}

TEST(CertifiedEdges, AreTheExactOnesInDegenerateWorlds) {
  const Tally tally = worlds(100, 64, 1);
  EXPECT_LT(tally.largest_share, 1);
  EXPECT_GT(tally.vertices_redone, 0u);
  EXPECT_GT(tally.crossings_redone, 0u);
}

// With wider bounds the same lists come from exact arithmetic: what is redone is redone right.
TEST(CertifiedEdges, AreTheExactOnesHoweverMuchIsRedone) {
  for (const double caution : {1e6, 1e9, 1e11, std::numeric_limits<double>::infinity()}) {
    SCOPED_TRACE(caution);
    const Tally tally = worlds(300, 16, caution);
    EXPECT_GT(tally.crossings_redone, caution > 1e10 ? tally.crossings / 4 : 0);
  }
}

// The check can fail: without bounds the rounded decisions differ from the exact ones.
TEST(CertifiedEdges, WithoutBoundsAreWrong) {
  const Tally tally = worlds(100, 64, 0);
  EXPECT_GT(tally.wrong, 0u);
  std::cout << tally.wrong << " lists are wrong without bounds\n";
}

TEST(CertifiedEdges, AreTheExactOnesAtEveryScale) {
  for (const double scale : {1e-12, 1e-6, 1e6, 1e12}) {
    SCOPED_TRACE(scale);
    EXPECT_LT(worlds(500, 16, 1, scale).largest_share, 1);
  }
}

TEST(CertifiedEdges, AreTheExactOnesFarFromTheOrigin) {
  for (const double offset : {1e3, 6.4e6, 1e9}) {
    SCOPED_TRACE(offset);
    EXPECT_LT(worlds(600, 16, 1, 1, {offset, -offset / 2, offset / 4}).largest_share, 1);
  }
}

// A triangle that is hard to draw from `eye`: of any size and at any distance, a sliver, almost
// edge on, across the plane of the eyepoint by a hair, with corners on the sides of a pyramid of 90
// degrees, or of small whole coordinates.
std::array<Vec3, 3> hard_triangle(const Vec3& eye, Random& random) {
  const auto small = [&] { return std::pow(10, random.between(-14, 0)); };
  const auto direction = [&] { return random_direction(random); };
  const double size = std::pow(10, random.between(-12, 12));
  Vec3 a = direction() * size, b = direction() * size, c = direction() * size;
  switch (random.below(6)) {
    case 0:
      c = direction() * std::pow(10, random.between(-12, 12));
      break;
    case 1:
      c = a + (b - a) * random.between(-1, 2) + direction() * (size * small());
      break;
    case 2:
      c = a * random.between(-2, 2) + b * random.between(-2, 2) + direction() * (size * small());
      break;
    case 3:
      for (Vec3* p : {&a, &b, &c}) p->y *= small();
      break;
    case 4:
      for (Vec3* p : {&a, &b, &c})
        if (random.below(2)) p->x = random.below(2) ? p->y : -p->y;
      break;
    default:
      for (Vec3* p : {&a, &b, &c})
        *p = {std::round(random.between(-9, 9)), std::round(random.between(-2, 9)),
              std::round(random.between(-9, 9))};
  }
  return {eye + a, eye + b, eye + c};
}

// Edges that leave a square picture through its corner, or beside it by a hair.
TEST(CertifiedEdges, ThroughCornersOfThePictureAreTheExactOnes) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto whole = [&](double low, double high) {
      return std::round(random.between(low, high));
    };
    const double unit = random.below(2) ? 1 : 0.1;
    FaceSet set;
    for (std::uint32_t i = 0; i < 10; ++i) {
      const double right = random.below(2) ? 1 : -1, up = random.below(2) ? 1 : -1;
      const auto diagonal = [&](double k) { return Vec3{right * k, whole(-3, 12), up * k} * unit; };
      Vec3 corners[3] = {diagonal(whole(1, 9)), diagonal(whole(1, 9)),
                         Vec3{whole(-9, 9), whole(1, 12), whole(-9, 9)} * unit};
      if (random.below(3) == 0)
        corners[0].x = std::nextafter(corners[0].x, random.below(2) ? 9 : -9);
      set.items.push_back({i, 1, 3 * i, 3, {}});
      set.faces.push_back({3 * i, 3, i, i + 1, {}, true});
      set.planes.push_back(plane_through(corners[0], corners[1], corners[2]));
      for (std::uint32_t k = 0; k < 3; ++k) {
        set.vertices.push_back(corners[k]);
        set.corners.push_back(k);
      }
    }
    Viewpoint viewpoint;
    viewpoint.fov = random.below(2) ? 90 : random.between(20, 120);
    const int side = 1 + static_cast<int>(random.below(64));
    const ViewTransform view = frame_calculator::view_transform(viewpoint, {side, side});
    const std::uint64_t wrong = tally.wrong;
    compare(set, view, 1, tally);
    EXPECT_EQ(tally.wrong, wrong);
  }
  std::cout << tally.text() << "\n";
  EXPECT_GT(tally.faces_redone, 100u);
}

TEST(CertifiedEdges, OfTrianglesAtTheExtremesAreTheExactOnes) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double away = random.below(2) ? 0 : std::pow(10, random.between(0, 9));
    Viewpoint viewpoint;
    viewpoint.eye.position = random_direction(random) * away;
    if (random.below(2)) {
      viewpoint.eye.heading = random.between(-180, 180);
      viewpoint.eye.pitch = random.between(-90, 90);
      viewpoint.eye.roll = random.between(-180, 180);
      viewpoint.fov = std::pow(10, random.between(-2, 2.25));
    } else {
      viewpoint.fov = 90;
    }
    FaceSet set;
    for (std::uint32_t i = 0; i < 40; ++i) {
      const auto corners = hard_triangle(viewpoint.eye.position, random);
      set.items.push_back({i, 1, 3 * i, 3, {}});
      set.faces.push_back({3 * i, 3, i, i + 1, {}, true});
      set.planes.push_back(plane_through(corners[0], corners[1], corners[2]));
      for (std::uint32_t k = 0; k < 3; ++k) {
        set.vertices.push_back(corners[k]);
        set.corners.push_back(k);
      }
    }
    const ViewTransform view =
        frame_calculator::view_transform(viewpoint, random_raster(random, 64));
    const std::uint64_t wrong = tally.wrong;
    compare(set, view, 1, tally);
    EXPECT_EQ(tally.wrong, wrong);
  }
  std::cout << tally.text() << "\n";
  EXPECT_LT(tally.largest_share, 1);
  EXPECT_GT(tally.faces_redone, 0u);
}

}  // namespace
}  // namespace cigsim::test
