// SPDX-License-Identifier: MIT
// The rules by which an object's faces are made fit (models/database/surface.hpp), one by one.
#include "models/database/surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/support/bodies.hpp"

namespace cigsim::test {
namespace {

struct Made {
  Notices notices;
  Surface surface;

  explicit Made(const Object& object) : surface(make_surface(object, notices)) {}
  std::uint64_t count(std::string_view what) const {
    for (const Notice& n : notices.list())
      if (n.what.find(what) != std::string::npos) return n.count;
    return 0;
  }
};

Object unit_cube() { return box_between({0, 0, 0}, {1, 1, 1}); }

void turn(Face& face) { std::reverse(face.vertices.begin(), face.vertices.end()); }

// Twice the area vector of a loop of grid points, exact in doubles.
Vec3 area(const Surface& s, const Loop& loop) {
  Vec3 sum;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum = sum + cross(s.vertices[loop[i]], s.vertices[loop[(i + 1) % loop.size()]]);
  return sum;
}

// Six times the volume that the faces enclose.
Exact volume(const Surface& s) {
  Exact sum = 0;
  for (const SurfaceFace& f : s.faces)
    for (std::size_t i = 1; i + 1 < f.loop.size(); ++i)
      sum += dot(
          convert<Exact>(s.vertices[f.loop[0]]),
          cross(convert<Exact>(s.vertices[f.loop[i]]), convert<Exact>(s.vertices[f.loop[i + 1]])));
  return sum;
}

void expect_faces_are_planar_convex_and_front(const Surface& s) {
  for (const SurfaceFace& f : s.faces) {
    for (const std::uint32_t v : f.loop) EXPECT_EQ(side(f.plane, s.vertices[v]), 0);
    const Vec3 n = f.plane.normal;
    for (std::size_t i = 0; i < f.loop.size(); ++i) {
      const Vec3 a = s.vertices[f.loop[i]], b = s.vertices[f.loop[(i + 1) % f.loop.size()]],
                 c = s.vertices[f.loop[(i + 2) % f.loop.size()]];
      EXPECT_GE(dot(cross(b - a, c - b), n), 0) << "corner " << i;
    }
  }
}

TEST(Surface, CubeStaysAsItIs) {
  const Made m(unit_cube());
  EXPECT_TRUE(m.surface.closed);
  EXPECT_TRUE(m.surface.convex);
  EXPECT_EQ(m.surface.faces.size(), 6u);
  EXPECT_EQ(m.surface.vertices.size(), 8u);
  EXPECT_TRUE(m.notices.list().empty());
  EXPECT_EQ(volume(m.surface), 6);
}

// Each face of the cube as two triangles, the second of a colour of its own on `painted` faces.
Object triangulated_cube(std::size_t painted) {
  Object cube = unit_cube();
  std::vector<Face> triangles;
  for (const Face& f : cube.faces) {
    const auto& v = f.vertices;
    triangles.push_back({{v[0], v[1], v[2]}, Colour{10, 20, 30}});
    triangles.push_back({{v[2], v[3], v[0]}, Colour{10, 20, 30}});
    if (triangles.size() <= 2 * painted) triangles.back().colour = Colour{200, 0, 0};
  }
  cube.faces = triangles;
  return cube;
}

TEST(Surface, CoplanarTrianglesOfAConvexBodyAreJoined) {
  const Made made(triangulated_cube(0));
  EXPECT_TRUE(made.surface.convex);
  ASSERT_EQ(made.surface.faces.size(), 6u);
  for (const SurfaceFace& f : made.surface.faces) EXPECT_EQ(f.loop.size(), 4u);
  EXPECT_EQ(made.count("joined"), 6u);
  EXPECT_EQ(volume(made.surface), 6);
  expect_faces_are_planar_convex_and_front(made.surface);
}

TEST(Surface, CoplanarTrianglesOfTwoColoursStayApart) {
  const Made made(triangulated_cube(2));
  EXPECT_TRUE(made.surface.convex);
  EXPECT_EQ(made.surface.faces.size(), 8u);
  EXPECT_EQ(volume(made.surface), 6);
}

TEST(Surface, VerticesAtOnePlaceAreMerged) {
  const Object cube = unit_cube();
  Object apart;  // every face with vertices of its own, and -0 beside 0
  for (const Face& face : cube.faces) {
    Face f;
    for (const std::uint32_t v : face.vertices) {
      f.vertices.push_back(static_cast<std::uint32_t>(apart.vertices.size()));
      Vec3 p = cube.vertices[v];
      if (p.x == 0 && apart.vertices.size() % 2) p.x = -0.0;
      apart.vertices.push_back(p);
    }
    apart.faces.push_back(f);
  }
  const Made m(apart);
  EXPECT_EQ(m.surface.vertices.size(), 8u);
  EXPECT_EQ(m.count("merged"), 16u);
  EXPECT_TRUE(m.surface.closed);
  EXPECT_TRUE(m.surface.convex);
}

TEST(Surface, RepeatedCornersAndSpikesGo) {
  Object cube = unit_cube();
  cube.faces[0].vertices = {0, 0, 2, 3, 3, 1, 0};
  cube.faces[1].vertices = {4, 5, 7, 5, 7, 6};  // back along an edge and forth
  const Made m(cube);
  EXPECT_TRUE(m.surface.convex);
  ASSERT_EQ(m.surface.faces.size(), 6u);
  EXPECT_EQ(m.surface.faces[0].loop.size(), 4u);
  EXPECT_EQ(m.surface.faces[1].loop.size(), 4u);
}

TEST(Surface, FacesWithoutAreaAreDroppedAndCounted) {
  Object cube = unit_cube();
  cube.vertices.push_back({0.5, 0, 0});
  cube.faces.push_back({{0, 8, 1}, {}});     // on one line
  cube.faces.push_back({{0, 1, 0}, {}});     // there and back
  cube.faces.push_back({{2, 2, 2}, {}});     // a point
  cube.faces.push_back({{0, 1, 8, 1}, {}});  // on one line with a spike
  const Made m(cube);
  EXPECT_EQ(m.count("without area"), 4u);
  EXPECT_EQ(m.surface.faces.size(), 6u);
  EXPECT_TRUE(m.surface.convex);
}

TEST(Surface, OfEqualFacesTheFirstStays) {
  Object cube = unit_cube();
  Face again = cube.faces[2];
  std::rotate(again.vertices.begin(), again.vertices.begin() + 2, again.vertices.end());
  cube.faces.push_back(again);
  const Made m(cube);
  EXPECT_EQ(m.count("duplicate"), 1u);
  ASSERT_EQ(m.surface.faces.size(), 6u);
  EXPECT_EQ(m.surface.faces[2].source, 2u);
  EXPECT_TRUE(m.surface.convex);
}

TEST(Surface, FacesBackToBackMakeAClosedSheet) {
  Object sheet = polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  sheet.faces.push_back({{2, 1, 0}, {}});
  const Made m(sheet);
  EXPECT_TRUE(m.surface.closed);
  EXPECT_EQ(m.surface.faces.size(), 2u);
  EXPECT_EQ(m.count("duplicate"), 0u);
}

TEST(Surface, JunctionsInAnEdgeCloseTheObject) {
  Object cube = unit_cube();
  // The top (z = 1) in two halves, whose common edge ends within edges of the sides.
  cube.vertices.push_back({0.5, 0, 1});
  cube.vertices.push_back({0.5, 1, 1});
  cube.faces[1] = {{4, 8, 9, 6}, {}};
  cube.faces.push_back({{8, 5, 7, 9}, {}});
  const Made m(cube);
  EXPECT_EQ(m.count("T-junction"), 2u);
  EXPECT_TRUE(m.surface.closed);
  EXPECT_TRUE(m.surface.convex);
  EXPECT_EQ(volume(m.surface), 6);
}

TEST(Surface, JunctionsThatCloseNothingStayOut) {
  Object open = polygon({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}});
  open.vertices.push_back({1, 0, 0});
  open.vertices.push_back({1, -1, 0});
  open.faces.push_back({{0, 5, 4}, {}});
  const Made m(open);
  EXPECT_FALSE(m.surface.closed);
  EXPECT_EQ(m.count("T-junction"), 0u);
  EXPECT_EQ(m.surface.faces[0].loop.size(), 4u);
}

TEST(Surface, WindingsAreRepairedWhicheverFacesAreTurned) {
  for (unsigned mask = 0; mask < 64; ++mask) {
    Object cube = unit_cube();
    for (unsigned f = 0; f < 6; ++f)
      if (mask >> f & 1) turn(cube.faces[f]);
    const Made m(cube);
    EXPECT_TRUE(m.surface.closed) << mask;
    EXPECT_TRUE(m.surface.convex) << mask;
    EXPECT_EQ(volume(m.surface), 6) << mask;
    EXPECT_EQ(m.count("turned") > 0, mask != 0) << mask;
  }
}

Object cube_with_cavity(bool cavity_inwards) {
  Object o = box_between({0, 0, 0}, {4, 4, 4});
  const Object inner = box_between({1, 1, 1}, {2, 2, 2});
  o.vertices.insert(o.vertices.end(), inner.vertices.begin(), inner.vertices.end());
  for (Face f : inner.faces) {
    for (std::uint32_t& v : f.vertices) v += 8;
    if (cavity_inwards) turn(f);
    o.faces.push_back(f);
  }
  return o;
}

TEST(Surface, ACavityStaysACavity) {
  const Made m(cube_with_cavity(true));
  EXPECT_TRUE(m.surface.closed);
  EXPECT_FALSE(m.surface.convex);
  EXPECT_EQ(m.count("turned"), 0u);
  EXPECT_EQ(volume(m.surface), 6 * (64 - 1));
}

TEST(Surface, ABodyWithinABodyStaysABody) {
  const Made m(cube_with_cavity(false));
  EXPECT_TRUE(m.surface.closed);
  EXPECT_FALSE(m.surface.convex);
  EXPECT_EQ(volume(m.surface), 6 * (64 + 1));
}

TEST(Surface, ManyCavitiesStayCavitiesAlsoInsideOut) {
  Object o = box_between({0, 0, 0}, {10, 4, 4});
  for (int k = 0; k < 4; ++k) {
    const double x = 1 + 2 * k;
    const Object inner = box_between({x, 1, 1}, {x + 1, 2, 2});
    const auto base = static_cast<std::uint32_t>(o.vertices.size());
    o.vertices.insert(o.vertices.end(), inner.vertices.begin(), inner.vertices.end());
    for (Face f : inner.faces) {
      for (std::uint32_t& v : f.vertices) v += base;
      turn(f);
      o.faces.push_back(f);
    }
  }
  EXPECT_EQ(volume(Made(o).surface), 6 * (160 - 4));
  for (Face& f : o.faces) turn(f);
  EXPECT_EQ(volume(Made(o).surface), 6 * (160 - 4));
}

TEST(Surface, AnInsideOutBodyIsTurned) {
  Object o = unit_cube();
  for (Face& f : o.faces) turn(f);
  EXPECT_EQ(volume(Made(o).surface), 6);
}

TEST(Surface, ABodyWithCavitiesThatIsInsideOutIsTurnedAsAWhole) {
  Object o = cube_with_cavity(true);
  const Object far = box_between({10, 0, 0}, {11, 1, 1});
  for (Face f : far.faces) {
    for (std::uint32_t& v : f.vertices) v += 16;
    o.faces.push_back(f);
  }
  o.vertices.insert(o.vertices.end(), far.vertices.begin(), far.vertices.end());
  for (Face& f : o.faces) turn(f);
  EXPECT_EQ(volume(Made(o).surface), 6 * (64 - 1 + 1));
}

TEST(Surface, AnObjectWithoutOneFaceIsNotClosed) {
  Object o = unit_cube();
  o.faces.pop_back();
  const Made m(o);
  EXPECT_FALSE(m.surface.closed);
  EXPECT_FALSE(m.surface.convex);
  EXPECT_EQ(m.count("not closed"), 1u);
}

TEST(Surface, AnObjectOfFacesWithoutAreaHasNone) {
  const Made m(polygon({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}));
  EXPECT_TRUE(m.surface.faces.empty());
  EXPECT_FALSE(m.surface.closed);
  EXPECT_EQ(m.count("without a face"), 1u);
}

TEST(Surface, ACubesCornerAnUlpOutBulgesAndAnUlpInDents) {
  // The top has the corner 7; moved along z only, the three faces around it stay planar or become
  // two triangles, and the body is the hull of its corners.
  for (const double direction : {2.0, -2.0}) {
    Object o = unit_cube();
    o.vertices[7].z = std::nextafter(1.0, direction);
    const Made m(o);
    EXPECT_TRUE(m.surface.closed);
    EXPECT_TRUE(m.surface.convex) << "non-planar faces of a convex body bulge";
    EXPECT_EQ(m.count("not planar"), 1u);
    EXPECT_EQ(m.surface.faces.size(), 7u);
    expect_faces_are_planar_convex_and_front(m.surface);
  }
}

// A cube whose top is a fan of four triangles around a middle vertex.
Object cube_with_fan(double height) {
  Object o = unit_cube();
  o.vertices.push_back({0.5, 0.5, height});
  o.faces[1] = {{4, 5, 8}, {}};
  o.faces.push_back({{5, 7, 8}, {}});
  o.faces.push_back({{7, 6, 8}, {}});
  o.faces.push_back({{6, 4, 8}, {}});
  return o;
}

TEST(Surface, ConvexityIsDecidedToTheUlp) {
  const Made level(cube_with_fan(1)), out(cube_with_fan(std::nextafter(1, 2))),
      in(cube_with_fan(std::nextafter(1, 0)));
  EXPECT_TRUE(level.surface.convex);
  EXPECT_TRUE(out.surface.convex);
  EXPECT_FALSE(in.surface.convex);
  EXPECT_TRUE(in.surface.closed);
}

TEST(Surface, AnUnclosedNonPlanarFaceBecomesEars) {
  const Made m(polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}));
  EXPECT_EQ(m.count("not planar"), 1u);
  EXPECT_EQ(m.surface.faces.size(), 2u);
  expect_faces_are_planar_convex_and_front(m.surface);
}

TEST(Surface, TurnedBoxesStayConvex) {
  Random random(31);
  int non_planar = 0;
  for (int k = 0; k < 300; ++k) {
    const Mat3 t = random_turn(random);
    const double size = std::pow(10.0, random.between(-6, 6));
    Object o = unit_cube();
    const Vec3 at = random_direction(random) * (size * random.between(0, 100));
    for (Vec3& v : o.vertices) v = at + t * (v * size);
    const Made m(o);
    ASSERT_TRUE(m.surface.closed) << "case " << k << " of seed 31";
    ASSERT_TRUE(m.surface.convex) << "case " << k << " of seed 31";
    expect_faces_are_planar_convex_and_front(m.surface);
    non_planar += m.count("not planar") > 0;
  }
  EXPECT_GT(non_planar, 200) << "the cases must need the rule";
}

TEST(Surface, HullsAreRecognisedAsConvexAndDentedOnesAreNot) {
  Random random(32);
  for (int k = 0; k < 200; ++k) {
    Object o = random_hull(random_direction(random) * 10, 1, random);
    ASSERT_TRUE(Made(o).surface.convex) << "case " << k << " of seed 32";
    // A face with its middle pushed in.
    const std::vector<std::uint32_t> loop = o.faces[0].vertices;
    Vec3 middle, inner;
    for (const std::uint32_t v : loop) middle = middle + o.vertices[v] * (1.0 / loop.size());
    for (const Face& f : o.faces)
      for (const std::uint32_t v : f.vertices)
        inner = inner + o.vertices[v] * (1.0 / (3 * o.faces.size()));
    const auto apex = static_cast<std::uint32_t>(o.vertices.size());
    o.vertices.push_back(middle + (inner - middle) * 0x1p-20);
    o.faces.erase(o.faces.begin());
    for (std::size_t i = 0; i < loop.size(); ++i)
      o.faces.push_back({{loop[i], loop[(i + 1) % loop.size()], apex}, {}});
    const Made dented(o);
    ASSERT_TRUE(dented.surface.closed) << "case " << k << " of seed 32";
    ASSERT_FALSE(dented.surface.convex) << "case " << k << " of seed 32";
  }
}

// A star-shaped polygon on a grid about the origin, anticlockwise.
Object star(Random& random) {
  std::map<double, Vec3> by_angle;
  for (std::uint32_t i = 0; i < 4 + random.below(20); ++i) {
    const Vec3 p{std::round(random.between(-1000, 1000)), std::round(random.between(-1000, 1000)),
                 0};
    if (p.x == 0 && p.y == 0) continue;
    by_angle[std::atan2(p.y, p.x)] = p;
  }
  std::vector<Vec3> corners;
  for (const auto& [angle, p] : by_angle) corners.push_back(p);
  return polygon(corners);
}

TEST(Surface, ConcavePolygonsAreDecomposedWithoutLossOfArea) {
  Random random(33);
  for (int k = 0; k < 300; ++k) {
    Object o = star(random);
    // Into a slanted plane by whole numbers: still exact.
    const bool slanted = random.below(2);
    if (slanted)
      for (Vec3& v : o.vertices) v = {v.x + v.y, v.y - 2 * v.x, 3 * v.x + v.y};
    Loop all(o.vertices.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    const Made m(o);
    Surface before;
    before.vertices = o.vertices;
    const Vec3 whole = area(before, all);
    Vec3 sum;
    for (const SurfaceFace& f : m.surface.faces) sum = sum + area(m.surface, f.loop);
    if (m.count("crosses itself")) continue;  // a gap of more than half a turn
    EXPECT_EQ(sum, whole) << "case " << k << " of seed 33";
    expect_faces_are_planar_convex_and_front(m.surface);
  }
}

TEST(Surface, ASelfCrossingFaceIsSaidToBe) {
  const Made m(polygon({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}));
  EXPECT_EQ(m.count("crosses itself"), 1u);
  for (const SurfaceFace& f : m.surface.faces) EXPECT_EQ(f.loop.size(), 3u);
}

}  // namespace
}  // namespace cigsim::test
