// SPDX-License-Identifier: MIT
// Larger pictures in double against Embree. Embree works in float, so two rules say what counts:
//  - an element counts when no projected edge and no line in which two faces meet passes near it
//    (picture_check.hpp); near one, float and double may fall to different sides;
//  - where Embree's hit and the machine's face lie within 1e-5 of each other in depth, float cannot
//    tell which is in front.
// On the elements that count there is no mismatch; of all elements fewer than 0.01 % differ.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iostream>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/read.hpp"
#include "models/frame_calculator/functional.hpp"
#include "sim/functional_machine.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/embree_picture.hpp"
#include "tests/support/picture_check.hpp"
#include "tests/support/viewpoints.hpp"

namespace cigsim::test {
namespace {

constexpr Raster kRaster{256, 256};

// Depth of a polygon's plane along the line of sight at an element; infinite without a polygon.
double depth(const OraclePolygon* p, const ViewTransform& view, int c, int r) {
  if (!p) return std::numeric_limits<double>::infinity();
  const Vec3 ray = view.rotation.row[0] +
                   view.rotation.row[1] * ((c + 0.5 - view.raster.width / 2.0) / view.focal) -
                   view.rotation.row[2] * ((r + 0.5 - view.raster.height / 2.0) / view.focal);
  const Vec3 n = cross(p->vertices[1] - p->vertices[0], p->vertices[2] - p->vertices[0]);
  return dot(n, p->vertices[0] - view.eye) / dot(n, ray);
}

struct Comparison {
  std::uint64_t elements = 0, hits = 0, near_edges = 0, equal_depth = 0;
};

// `got` gives, for each element, 1 + the object of the polygons that the machine shows, or 0; the
// polygons' objects count from 1.
void compare(const std::vector<OraclePolygon>& polygons, const ViewTransform& view,
             const std::vector<std::uint32_t>& got, Comparison& sum) {
  const std::vector<EmbreeHit> hits = cast_with_embree(polygons, view);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const bool hit = hits[i].polygon != kNone;
    const std::uint32_t want = hit ? polygons[hits[i].polygon].object : 0;
    ++sum.elements;
    sum.hits += hit;
    if (want == got[i]) continue;
    const int c = static_cast<int>(i) % view.raster.width,
              r = static_cast<int>(i) / view.raster.width;
    if (near_an_edge(polygons, view, c, r, want, got[i])) {
      ++sum.near_edges;
      continue;
    }
    // The machine's face is the nearest of its object's that has the depth of Embree's, if any has.
    const double embree = depth(hit ? &polygons[hits[i].polygon] : nullptr, view, c, r);
    bool level = false;
    for (const OraclePolygon& p : polygons)
      if (p.object == got[i])
        level = level || std::abs(depth(&p, view, c, r) - embree) <= 1e-5 * std::abs(embree);
    EXPECT_TRUE(level) << "element (" << c << "," << r << ") is " << got[i] << ", must be " << want;
    sum.equal_depth += level;
  }
}

void check_sum(const Comparison& sum) {
  std::cout << sum.elements << " elements, " << sum.hits << " with a face; mismatches near edges "
            << sum.near_edges << ", within float's depth " << sum.equal_depth << "\n";
  EXPECT_GT(sum.hits, sum.elements / 20) << "the views must show something";
  EXPECT_LT(static_cast<double>(sum.near_edges + sum.equal_depth),
            1e-4 * static_cast<double>(sum.elements));
}

template <class Make>
void check_worlds(std::uint64_t first_seed, int worlds, int views, Make make) {
  Comparison sum;
  for (std::uint64_t seed = first_seed; seed < first_seed + worlds; ++seed) {
    Random random(seed);
    const World world = make(random);
    const Database database = prepare(world.environment);
    std::vector<FunctionalMachine> machines;
    for (const ResolverMethod resolver :
         {ResolverMethod::kPainter, ResolverMethod::kCoverage, ResolverMethod::kActiveList}) {
      MachineOptions options;
      options.raster = kRaster;
      options.resolver = resolver;
      machines.emplace_back(database, options);
    }
    for (int v = 0; v < views; ++v) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " view " + std::to_string(v));
      const Viewpoint viewpoint = plain_viewpoint(world.environment, random);
      const std::vector<std::uint16_t>& numbers = machines[0].compute(viewpoint, 0).numbers;
      for (std::size_t m = 1; m < machines.size(); ++m)
        EXPECT_EQ(machines[m].compute(viewpoint, 0).numbers, numbers) << "resolver " << m;
      compare(polygons_of(world), frame_calculator::view_transform(viewpoint, kRaster),
              {numbers.begin(), numbers.end()}, sum);
    }
    if (::testing::Test::HasFailure()) return;
  }
  check_sum(sum);
}

World generated(std::string_view kind, std::uint32_t objects, Random& random) {
  World world;
  world.environment = generate_environment(kind, {objects, random.bits()});
  world.environment.ground.clear();
  for (const Object& o : world.environment.objects) world.open.push_back(o.faces.size() == 1);
  return world;
}

TEST(Embree, DisjointBodies) {
  check_worlds(1, 4, 6, [](Random& r) { return disjoint_world(r, 200); });
}

TEST(Embree, ManyGeneratedSolids) {
  check_worlds(10, 2, 6, [](Random& r) { return generated("random", 1000, r); });
}

TEST(Embree, Cities) {
  check_worlds(20, 2, 6, [](Random& r) { return generated("city", 300, r); });
}

TEST(Embree, TouchingBodies) {
  check_worlds(30, 6, 6, [](Random& r) { return touching_world(r); });
}

TEST(Embree, TrianglesThatPassThroughEachOther) {
  check_worlds(40, 3, 6, [](Random& r) { return triangle_soup(r, 60); });
}

TEST(Embree, BodiesThatPassThroughEachOther) {
  check_worlds(50, 3, 6, [](Random& r) { return body_soup(r, 40); });
}

// A mesh with a colour a face, so that the picture tells the faces apart.
void check_mesh(const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(CIGSIM_CGAL_MESHES) / (name + ".off");
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << file << " is absent: install libcgal-demo and configure again";
  Environment environment = read_environment(file).environment;
  std::vector<OraclePolygon> polygons;
  for (Object& object : environment.objects)
    for (Face& face : object.faces) {
      OraclePolygon p;
      for (const std::uint32_t v : face.vertices) p.vertices.push_back(object.vertices[v]);
      p.object = static_cast<std::uint32_t>(polygons.size() + 1);
      p.two_sided = true;  // from outside a closed mesh shows its nearest face
      face.colour = Colour{static_cast<std::uint8_t>(p.object & 0xff),
                           static_cast<std::uint8_t>(p.object >> 8 & 0xff),
                           static_cast<std::uint8_t>(p.object >> 16 & 0xff)};
      polygons.push_back(std::move(p));
    }
  environment.background = {};
  environment.sun.reset();
  const Database database = prepare(environment);
  std::cout << name << ": " << polygons.size() << " faces, " << database.report.pieces
            << " pieces, prepared in " << database.report.seconds << " s\n";
  MachineOptions options;
  options.raster = kRaster;
  FunctionalMachine machine(database, options);
  const Sphere& sphere = database.systems[0].sphere;
  Random random(1);
  Comparison sum;
  for (int v = 0; v < 4; ++v) {
    SCOPED_TRACE("view " + std::to_string(v));
    Viewpoint viewpoint;
    viewpoint.eye =
        look_at(sphere.centre + random_direction(random) * (2.5 * sphere.radius), sphere.centre);
    viewpoint.fov = 50;
    std::vector<std::uint32_t> got;
    for (const std::uint32_t colour : machine.compute(viewpoint, 0).colours)
      got.push_back(colour & 0xffffff);
    compare(polygons, frame_calculator::view_transform(viewpoint, kRaster), got, sum);
  }
  check_sum(sum);
}

class EmbreeMesh : public ::testing::TestWithParam<const char*> {};
TEST_P(EmbreeMesh, ShowsTheRightFaces) { check_mesh(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Cgal, EmbreeMesh,
                         ::testing::Values("star", "sphere", "joint", "eight", "pig", "helmet",
                                           "anchor", "rotor", "knot1", "triceratops"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace cigsim::test
