// SPDX-License-Identifier: MIT
// Every algorithm of the survey against the machine's functional level in exact numbers and against
// ray casting in rational numbers, on every element.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/read.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/survey/visible_surface/algorithm.hpp"
#include "models/survey/visible_surface/frame.hpp"
#include "sim/functional_machine.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/cases.hpp"
#include "tests/support/viewpoints.hpp"
#include "tests/support/worlds.hpp"

namespace cigsim::test {
namespace {

using survey::Algorithm;
using survey::algorithms;
using survey::FaceList;
using survey::FacePicture;
using survey::Work;

Picture machine_picture(const Database& database, const Viewpoint& viewpoint, const Raster& raster,
                        double frame) {
  MachineOptions options;
  options.number = NumberType::kExact;
  options.raster = raster;
  FunctionalMachine machine(database, options);
  return machine.compute(viewpoint, frame);
}

// All algorithms give the machine's picture, and each the same faces.
void check_frame(const Database& database, const Viewpoint& viewpoint, const Raster& raster,
                 double frame = 0) {
  const Picture want = machine_picture(database, viewpoint, raster, frame);
  const FaceList list = survey::make_frame(database, viewpoint, raster, frame).list;
  FacePicture reference, got;
  Work none;
  survey::z_buffer(list, reference, none);
  for (const Algorithm& algorithm : algorithms()) {
    Work work;
    algorithm.compute(list, got, work);
    EXPECT_EQ(survey::differences(list, got, database.background, want), 0u) << algorithm.name;
    EXPECT_EQ(got.faces, reference.faces) << algorithm.name;
  }
}

void check_world(const World& world, Random& random, int views, int largest) {
  const Database database = prepare(world.environment);
  const std::vector<OraclePolygon> polygons = polygons_of(world);
  for (int v = 0; v < views; ++v) {
    SCOPED_TRACE("view " + std::to_string(v));
    const Viewpoint viewpoint = random_viewpoint(world.environment, random);
    check_frame(database, viewpoint, random_raster(random, largest));
  }
}

template <class Make>
void check_worlds(unsigned seed, unsigned worlds, Make make) {
  for (unsigned i = 0; i < cases(worlds); ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    Random random(seed + i);
    const World world = make(random);
    check_world(world, random, 4, 48);
  }
}

TEST(VisibleSurface, DisjointConvexWorlds) {
  check_worlds(100, 12, [](Random& r) { return disjoint_world(r, 1 + int(r.below(20))); });
}
TEST(VisibleSurface, TouchingWorlds) {
  check_worlds(200, 8, [](Random& r) { return touching_world(r); });
}
TEST(VisibleSurface, CoplanarPolygons) {
  check_worlds(300, 10, [](Random& r) { return coplanar_polygons(r, 6); });
}
TEST(VisibleSurface, LatticeWorlds) {
  check_worlds(400, 8, [](Random& r) { return lattice_world(r, 5); });
}
TEST(VisibleSurface, BodiesAndTrianglesThatWereCutWhereTheyMet) {
  check_worlds(500, 5, [](Random& r) { return triangle_soup(r, 8); });
  check_worlds(600, 5, [](Random& r) { return body_soup(r, 5); });
  check_worlds(700, 5, [](Random& r) { return grid_boxes(r, 6); });
}
TEST(VisibleSurface, ConcaveAndNestedBodies) {
  check_worlds(800, 5, [](Random& r) { return cell_bodies(r, 3); });
  check_worlds(900, 5, [](Random& r) { return nested_world(r); });
  check_worlds(950, 3, [](Random& r) { return mixed_world(r); });
}

TEST(VisibleSurface, ShippedScenes) {
  for (const char* name :
       {"airfield.json", "levine-city.json", "levine-cubes-48.json", "fuchs-overlap.json"}) {
    SCOPED_TRACE(name);
    const Database database =
        prepare(read_environment(std::string(CIGSIM_SOURCE_DIR) + "/scenes/" + name).environment);
    const Viewpoint viewpoint{database.view.eye, database.view.fov};
    check_frame(database, viewpoint, {160, 120}, 0);
    check_frame(database, viewpoint, {77, 200}, 40);
  }
}

TEST(VisibleSurface, GeneratedKinds) {
  for (const GenerateKind& kind : generate_kinds()) {
    SCOPED_TRACE(std::string(kind.name));
    const Database database = prepare(generate_environment(kind.name, {40, 3}));
    check_frame(database, {database.view.eye, database.view.fov}, {128, 96});
  }
}

// Polygons by themselves, without preparation: nothing is cut, and the list's priority means
// nothing.
class Loose {
 public:
  explicit Loose(std::vector<OraclePolygon> polygons) : polygons_(std::move(polygons)) {
    for (const OraclePolygon& p : polygons_) add(p);
  }

  FaceList list(const ViewTransform& view) const {
    std::vector<ItemRef> items;
    for (std::uint32_t i = 0; i < set_.items.size(); ++i) items.push_back({SetId::kStatic, i});
    const FaceSet* const sets[3] = {&set_, &set_, &set_};
    return survey::make_face_list(view, sets, items);
  }
  const std::vector<OraclePolygon>& polygons() const { return polygons_; }

 private:
  void add(const OraclePolygon& p) {
    const auto count = static_cast<std::uint32_t>(p.vertices.size());
    Item item;
    item.first_face = static_cast<std::uint32_t>(set_.faces.size());
    item.face_count = 1;
    item.first_vertex = static_cast<std::uint32_t>(set_.vertices.size());
    item.vertex_count = count;
    PreparedFace face;
    face.first_corner = static_cast<std::uint32_t>(set_.corners.size());
    face.corner_count = count;
    face.plane = static_cast<std::uint32_t>(set_.planes.size());
    face.object = p.object;
    face.two_sided = p.two_sided;
    for (std::uint32_t c = 0; c < count; ++c) set_.corners.push_back(c);
    set_.vertices.insert(set_.vertices.end(), p.vertices.begin(), p.vertices.end());
    set_.planes.push_back(plane_through(p.vertices[0], p.vertices[1], p.vertices[2]));
    set_.faces.push_back(face);
    set_.items.push_back(item);
  }

  std::vector<OraclePolygon> polygons_;
  FaceSet set_;
};

// The algorithms that need no preparation, against the rays. Returns Newell's divisions.
std::uint64_t check_loose(const Loose& loose, const Viewpoint& viewpoint, const Raster& raster,
                          bool penetrating) {
  const ViewTransform view = frame_calculator::view_transform(viewpoint, raster);
  const std::vector<std::uint16_t> want = cast_rays(loose.polygons(), view);
  const FaceList list = loose.list(view);
  std::uint64_t divisions = 0;
  FacePicture got;
  for (const Algorithm& algorithm : algorithms()) {
    if (algorithm.name == "Schumacker" || (penetrating && algorithm.name == "Wylie")) continue;
    Work work;
    algorithm.compute(list, got, work);
    std::vector<std::uint16_t> numbers;
    for (const std::uint32_t f : got.faces)
      numbers.push_back(static_cast<std::uint16_t>(f == kNone ? 0 : list.faces[f].object));
    EXPECT_EQ(numbers, want) << algorithm.name;
    if (algorithm.name == "Newell") divisions = work.subdivisions;
  }
  return divisions;
}

Viewpoint from_above(double height) {
  Viewpoint viewpoint;
  viewpoint.eye.position = {0, 0, height};
  viewpoint.eye.pitch = -90;
  return viewpoint;
}

OraclePolygon quad(std::uint32_t object, const Vec3& a, const Vec3& b, const Vec3& c,
                   const Vec3& d) {
  return {{a, b, c, d}, object, true};
}

TEST(VisibleSurface, NewellDividesACyclicOverlap) {
  // Three planks that lie on each other in a ring.
  std::vector<OraclePolygon> planks;
  for (int i = 0; i < 3; ++i) {
    const double t = 2 * 3.14159265358979 * i / 3, c = std::cos(t), s = std::sin(t);
    const auto at = [&](double along, double across, double z) {
      return Vec3{c * (1 + across) - s * along, s * (1 + across) + c * along, z};
    };
    planks.push_back(quad(static_cast<std::uint32_t>(i + 1), at(-3, -0.4, -1), at(3, -0.4, 1),
                          at(3, 0.4, 1), at(-3, 0.4, -1)));
  }
  EXPECT_GE(check_loose(Loose(planks), from_above(10), {96, 96}, false), 1u);
}

TEST(VisibleSurface, PolygonsThatPassThroughEachOther) {
  std::uint64_t divisions = 0;
  for (unsigned seed = 1; seed <= cases(25); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const World world = triangle_soup(random, 2 + static_cast<int>(random.below(20)));
    const Loose loose(polygons_of(world));
    for (int v = 0; v < 3; ++v)
      divisions += check_loose(loose, random_viewpoint(world.environment, random),
                               random_raster(random, 64), true);
  }
  EXPECT_GT(divisions, 20u);
}

TEST(VisibleSurface, CoplanarStackWithAPolygonThroughIt) {
  // Of the coplanar ones the first is seen; the slanted one passes through all of them.
  std::vector<OraclePolygon> polygons;
  for (std::uint32_t i = 0; i < 5; ++i) {
    const double x = -2 + 0.5 * i;
    polygons.push_back(quad(5 - i, {x, -2, 0}, {x + 2, -2, 0}, {x + 2, 2, 0}, {x, 2, 0}));
  }
  std::swap(polygons[1], polygons[3]);
  polygons.push_back(quad(6, {-3, -1, -1}, {3, -1, 1}, {3, 1, 1}, {-3, 1, -1}));
  polygons.push_back(quad(7, {-1, -3, 1}, {-1, 3, -1}, {1, 3, -1}, {1, -3, 1}));
  std::sort(polygons.begin(), polygons.end(),
            [](const auto& a, const auto& b) { return a.object < b.object; });
  check_loose(Loose(polygons), from_above(6), {80, 60}, true);
}

TEST(VisibleSurface, EmptyOneEdgeOnDuplicatesAndHuge) {
  check_loose(Loose({}), from_above(5), {16, 16}, false);
  const OraclePolygon one = quad(1, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  check_loose(Loose({one}), from_above(5), {33, 17}, false);
  Viewpoint level = from_above(0);
  level.eye = {{0, -5, 0}, 0, 0, 0};
  check_loose(Loose({one}), level, {16, 16}, false);          // edge on
  check_loose(Loose({one}), from_above(0), {16, 16}, false);  // at the eyepoint
  std::vector<OraclePolygon> copies(4, one);
  for (std::uint32_t i = 0; i < 4; ++i) copies[i].object = i + 1;
  check_loose(Loose(copies), from_above(5), {20, 20}, false);
  check_loose(Loose(copies), from_above(5), {1, 1}, false);
  for (const double scale : {1e-150, 1e-30, 1e30, 1e150}) {
    std::vector<OraclePolygon> scaled = copies;
    scaled.push_back(quad(9, {-1, -1, -0.5}, {1, -1, 0.5}, {1, 1, 0.5}, {-1, 1, -0.5}));
    for (OraclePolygon& p : scaled)
      for (Vec3& v : p.vertices) v = v * scale;
    check_loose(Loose(scaled), from_above(5 * scale), {24, 24}, true);
  }
}

TEST(VisibleSurface, WorkIsCounted) {
  const Database database = prepare(generate_environment("city", {30, 1}));
  const FaceList list =
      survey::make_frame(database, {database.view.eye, database.view.fov}, {64, 64}, 0).list;
  FacePicture picture;
  for (const Algorithm& algorithm : algorithms()) {
    SCOPED_TRACE(std::string(algorithm.name));
    Work work;
    algorithm.compute(list, picture, work);
    EXPECT_GT(work.segments, 0u);
    EXPECT_GT(work.writes, 0u);
    EXPECT_EQ(work.depths == 0, algorithm.name == "Schumacker");
  }
  Work z, wylie, bouknight;
  survey::z_buffer(list, picture, z);
  std::uint64_t covered = 0;
  for (const survey::Row& row : list.rows) covered += std::uint64_t(row.end - row.first);
  std::uint64_t seen = 0;
  for (const std::uint32_t f : picture.faces) seen += f != kNone;
  EXPECT_EQ(z.depths, covered - seen);  // each element of a face but the first of its place
  survey::wylie(list, picture, wylie);
  survey::bouknight(list, picture, bouknight);
  EXPECT_LT(wylie.depths, bouknight.depths);
}

}  // namespace
}  // namespace cigsim::test
