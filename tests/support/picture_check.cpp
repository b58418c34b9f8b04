// SPDX-License-Identifier: MIT
#include "tests/support/picture_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <sstream>

#include "models/database/prepare.hpp"
#include "models/database/traversal.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/geometry_processor/functional.hpp"
#include "models/priority_resolver/coverage.hpp"
#include "models/video_processor/functional.hpp"
#include "sim/functional_machine.hpp"
#include "tests/support/viewpoints.hpp"

namespace cigsim::test {
namespace {

// The plane of a polygon relative to the eyepoint.
struct FacePlane {
  const OraclePolygon* polygon;
  Vec3 normal;
  double offset;
};

std::vector<FacePlane> planes_of(const std::vector<OraclePolygon>& polygons, std::uint32_t object,
                                 const Vec3& eye) {
  std::vector<FacePlane> planes;
  for (const OraclePolygon& p : polygons) {
    if (p.object != object) continue;
    const Vec3 a = p.vertices[0] - eye;
    Vec3 normal;
    for (std::size_t i = 2; i < p.vertices.size() && normal == Vec3{}; ++i)
      normal = cross(p.vertices[i - 1] - p.vertices[0], p.vertices[i] - p.vertices[0]);
    planes.push_back({&p, normal, dot(normal, a)});
  }
  return planes;
}

bool covers(const OraclePolygon& polygon, const Vec3& eye, const Vec3& ray) {
  int inside = 0, outside = 0;
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
    const Vec3 a = polygon.vertices[i] - eye,
               b = polygon.vertices[(i + 1) % polygon.vertices.size()] - eye;
    const double s = dot(cross(a, b), ray);
    inside += s >= 0;
    outside += s <= 0;
  }
  const int n = static_cast<int>(polygon.vertices.size());
  return inside == n || outside == n;
}

// The static faces of two objects as preparation left them.
std::vector<OraclePolygon> prepared_polygons(const Database& database, std::uint32_t a,
                                             std::uint32_t b) {
  const FaceSet& set = database.systems[0].set;
  std::vector<OraclePolygon> polygons;
  for (const Item& item : set.items)
    for (std::uint32_t f = item.first_face; f < item.first_face + item.face_count; ++f) {
      const PreparedFace& face = set.faces[f];
      if (face.object != a && face.object != b) continue;
      OraclePolygon& p = polygons.emplace_back();
      for (std::uint32_t c = 0; c < face.corner_count; ++c)
        p.vertices.push_back(set.vertices[item.first_vertex + set.corners[face.first_corner + c]]);
    }
  return polygons;
}

std::vector<std::uint16_t> machine_picture(const Database& database, const MachineOptions& options,
                                           const Viewpoint& viewpoint, double frame,
                                           std::uint32_t& faults) {
  FunctionalMachine machine(database, options);
  std::vector<std::uint16_t> numbers = machine.compute(viewpoint, frame).numbers;
  faults += machine.stats().faults;
  return numbers;
}

void expect_equal(const std::vector<std::uint16_t>& want, const std::vector<std::uint16_t>& got,
                  const Raster& raster, const char* name) {
  if (want == got) return;
  std::ostringstream text;
  int count = 0;
  for (std::size_t i = 0; i < want.size(); ++i) {
    if (want[i] == got[i] || ++count > 3) continue;
    text << " (" << i % raster.width << "," << i / raster.width << ") is " << got[i] << ", must be "
         << want[i] << ";";
  }
  ADD_FAILURE() << name << ":" << text.str() << " " << count << " in all";
}

std::string tell(const Viewpoint& v, const Raster& raster) {
  std::ostringstream text;
  text.precision(17);
  text << "eye " << v.eye.position.x << "," << v.eye.position.y << "," << v.eye.position.z
       << " attitude " << v.eye.heading << "," << v.eye.pitch << "," << v.eye.roll << " fov "
       << v.fov << " raster " << raster.width << "x" << raster.height;
  return text.str();
}

}  // namespace

bool near_an_edge(const std::vector<OraclePolygon>& polygons, const ViewTransform& view, int column,
                  int row, std::uint32_t a, std::uint32_t b) {
  if (distance_to_edge(polygons, view, column, row) <= 0.5) return true;
  const double x = column + 0.5 - view.raster.width / 2.0, y = row + 0.5 - view.raster.height / 2.0;
  std::array<Vec3, 5> rays;
  for (int k = 0; k < 5; ++k) {
    const double dx = k == 4 ? 0 : k & 1 ? 0.5 : -0.5, dy = k == 4 ? 0 : k & 2 ? 0.5 : -0.5;
    rays[k] = view.rotation.row[0] * view.focal + view.rotation.row[1] * (x + dx) -
              view.rotation.row[2] * (y + dy);
  }
  const auto covers_element = [&](const FacePlane& f) {
    return std::any_of(rays.begin(), rays.end(),
                       [&](const Vec3& ray) { return covers(*f.polygon, view.eye, ray); });
  };
  for (const FacePlane& p : planes_of(polygons, a, view.eye))
    for (const FacePlane& q : planes_of(polygons, b, view.eye)) {
      if (p.polygon == q.polygon || !covers_element(p) || !covers_element(q)) continue;
      int nearer = 0;
      for (int k = 0; k < 4; ++k)
        nearer += dot(p.normal, rays[k]) / p.offset > dot(q.normal, rays[k]) / q.offset;
      if (nearer != 0 && nearer != 4) return true;
    }
  return false;
}

std::vector<std::uint16_t> picture_by_traversal(const Database& database,
                                                const ViewTransform& view) {
  const PreparedSystem& system = database.systems[0];
  const std::vector<std::uint32_t> ranks =
      ranks_from(system.hierarchy, system.set.items.size(), view.eye);
  std::vector<ItemRef> items(ranks.size());
  for (std::uint32_t i = 0; i < ranks.size(); ++i) items[ranks[i]] = {SetId::kStatic, i};
  geometry_processor::Functional<Exact> geometry;
  EdgeList<Exact> edges;
  geometry.compute(view, {&system.set, nullptr, nullptr}, items, edges);
  priority_resolver::Coverage<Exact> coverage;
  priority_resolver::SpanLines spans;
  coverage.compute(edges, view.raster, spans);
  video_processor::Functional video;
  Picture picture;
  video.compute(spans, edges.faces, {}, view.raster, picture);
  return picture.numbers;
}

void check_machine(const std::vector<OraclePolygon>& polygons, const Database& database,
                   const Viewpoint& viewpoint, const Raster& raster, double frame,
                   Strictness strictness, const std::string& what, Tally& tally) {
  SCOPED_TRACE(what + " " + tell(viewpoint, raster));
  const ViewTransform view = frame_calculator::view_transform(viewpoint, raster);
  const std::vector<std::uint16_t> want = cast_rays(polygons, view);
  std::uint32_t faults = 0;
  MachineOptions options;
  options.raster = raster;
  const auto machine = [&](NumberType number, PriorityMethod priority, ResolverMethod resolver) {
    options.number = number;
    options.priority = priority;
    options.resolver = resolver;
    return machine_picture(database, options, viewpoint, frame, faults);
  };
  const auto expect_near_edges = [&](const std::vector<std::uint16_t>& got, const char* name) {
    for (std::size_t i = 0; i < want.size(); ++i) {
      if (got[i] == want[i]) continue;
      ++tally.rounded_mismatches;
      const int c = static_cast<int>(i) % raster.width, r = static_cast<int>(i) / raster.width;
      EXPECT_TRUE(near_an_edge(polygons, view, c, r, want[i], got[i]) ||
                  distance_to_edge(prepared_polygons(database, want[i], got[i]), view, c, r) <= 0.5)
          << name << ": element (" << c << "," << r << ") is " << got[i] << ", must be " << want[i];
    }
  };

  // Each resolver once, each priority method at least once.
  const auto machines = [&](NumberType number) {
    return std::array{machine(number, PriorityMethod::kCounters, ResolverMethod::kCoverage),
                      machine(number, PriorityMethod::kSoMatrix, ResolverMethod::kActiveList),
                      machine(number, PriorityMethod::kCounters, ResolverMethod::kPainter)};
  };
  const auto exact = machines(NumberType::kExact);
  if (strictness == Strictness::kEveryElement)
    expect_equal(want, exact[0], raster, "exact");
  else
    expect_near_edges(exact[0], "exact");
  expect_equal(exact[0], exact[1], raster, "exact, SO matrix and active list");
  expect_equal(exact[0], exact[2], raster, "exact, painter");

  const auto rounded = machines(NumberType::kDouble);
  expect_near_edges(rounded[0], "double");
  expect_equal(rounded[0], rounded[1], raster, "double, SO matrix and active list");
  expect_equal(rounded[0], rounded[2], raster, "double, painter");

  const auto certified = machines(NumberType::kCertified);
  expect_equal(exact[0], certified[0], raster, "certified");
  expect_equal(exact[0], certified[1], raster, "certified, SO matrix and active list");
  expect_equal(exact[0], certified[2], raster, "certified, painter");
  EXPECT_EQ(faults, 0u) << "listability";
  ++tally.pictures;
  tally.elements += want.size();
}

void check_picture(const World& world, const Database& database, const Viewpoint& viewpoint,
                   const Raster& raster, const std::string& what, Tally& tally) {
  const std::vector<OraclePolygon> polygons = polygons_of(world);
  check_machine(polygons, database, viewpoint, raster, 0, Strictness::kEveryElement, what, tally);
  SCOPED_TRACE(what + " " + tell(viewpoint, raster));
  const ViewTransform view = frame_calculator::view_transform(viewpoint, raster);
  expect_equal(cast_rays(polygons, view), picture_by_traversal(database, view), raster,
               "plain traversal");
}

void check_world(const World& world, Random& random, int views, int largest,
                 const std::string& what, Tally& tally) {
  const Database database = prepare(world.environment);
  for (int v = 0; v < views; ++v) {
    const Viewpoint viewpoint = random_viewpoint(world.environment, random);
    check_picture(world, database, viewpoint, random_raster(random, largest),
                  what + " view " + std::to_string(v), tally);
  }
}

void check_rate(const Tally& tally) {
  std::ostringstream text;
  text << tally.pictures << " pictures, " << tally.elements << " elements, "
       << tally.rounded_mismatches << " mismatches in double";
  std::cout << text.str() << "\n";
  EXPECT_LT(static_cast<double>(tally.rounded_mismatches),
            1e-4 * static_cast<double>(tally.elements))
      << text.str();
}

}  // namespace cigsim::test
