// SPDX-License-Identifier: MIT
// Lines of edges in 128-bit whole numbers against rational numbers: projected end points and the
// line between them, which is another road than the plane through the eyepoint. And against the
// road of GMP. Where the numbers are too long there must be no line; where they are short there
// must be one.
#include "models/edge_orderer/short_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "models/edge_orderer/exact_line.hpp"
#include "models/environment/random.hpp"
#include "models/frame_calculator/functional.hpp"

namespace cigsim::test {
namespace {

using edge_orderer::ExactLine;
using edge_orderer::ShortLine;
using edge_orderer::ShortView;

struct Segment {
  Vec3 a, b;
};

// The first element at or right of the projected line on each of the lines asked for. Empty: an
// end has no projection, or the line is level.
std::vector<std::int32_t> by_rationals(const ViewTransform& view, const Segment& segment,
                                       const std::vector<int>& lines) {
  Exact x[2], y[2];
  for (const int end : {0, 1}) {
    const ExactVec p =
        convert<Exact>(view.rotation) *
        (convert<Exact>(end == 0 ? segment.a : segment.b) - convert<Exact>(view.eye));
    if (p.x == 0) return {};
    x[end] = Exact(view.raster.width) / 2 + Exact(view.focal) * p.y / p.x;
    y[end] = Exact(view.raster.height) / 2 - Exact(view.focal) * p.z / p.x;
  }
  if (y[0] == y[1]) return {};
  std::vector<std::int32_t> elements;
  for (const int line : lines) {
    const Exact sample = line + Exact(1, 2);
    const Exact column = x[0] + (x[1] - x[0]) * (sample - y[0]) / (y[1] - y[0]) - Exact(1, 2);
    elements.push_back(ceil_clamped(column, 0, view.raster.width));
  }
  return elements;
}

ExactLine by_gmp(const ViewTransform& view, const Segment& segment, int first_line) {
  FaceSet set;
  set.vertices = {segment.a, segment.b};
  EdgeList<Certified> list;
  list.view = view;
  list.sets[0] = &set;
  Edge<Certified> edge;
  edge.first_line = first_line;
  edge.to = 1;
  return ExactLine(list, ExactAxes(view), edge);
}

struct Tally {
  int lines = 0, held = 0;
  double share() const { return static_cast<double>(held) / lines; }
};

// Both roads where there is a short line.
void check(const ViewTransform& view, const Segment& segment, Random& random, Tally& tally) {
  const int height = view.raster.height;
  const int first = static_cast<int>(random.below(static_cast<std::uint64_t>(height)));
  const std::vector<int> lines = {first, (first + height) / 2, height - 1};
  const std::vector<std::int32_t> want = by_rationals(view, segment, lines);
  if (want.empty()) return;
  const ExactLine gmp = by_gmp(view, segment, first);
  const auto line = ShortView(view).line(segment.a, segment.b, first);
  ++tally.lines;
  tally.held += line.has_value();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(gmp.element(lines[i], view.raster.width), want[i]) << "line " << lines[i];
    if (line) {
      EXPECT_EQ(line->element(lines[i], view.raster.width), want[i]) << "line " << lines[i];
    }
  }
}

Raster any_raster(Random& random) {
  const auto side = [&] {
    return random.below(4) == 0 ? 16384 : 1 + static_cast<int>(random.below(1100));
  };
  const int height = side();
  return {side(), height};
}

double whole_between(Random& random, double low, double high) {
  return std::round(random.between(low, high));
}

Vec3 whole_point(Random& random, double reach) {
  return {whole_between(random, -reach, reach), whole_between(random, -reach, reach),
          whole_between(random, -reach, reach)};
}

Viewpoint along_an_axis(Random& random, const Vec3& eye, double fov) {
  Viewpoint viewpoint;
  viewpoint.eye.position = eye;
  viewpoint.eye.heading = 90.0 * static_cast<double>(random.below(4));
  viewpoint.eye.pitch = 90 * (static_cast<double>(random.below(3)) - 1);
  viewpoint.eye.roll = 90.0 * static_cast<double>(random.below(4));
  viewpoint.fov = fov;
  return viewpoint;
}

// In general position, or parallel to an axis.
Segment segment_in(Random& random, double reach) {
  Segment segment{whole_point(random, reach), whole_point(random, reach)};
  const std::uint64_t axis = random.below(6);
  if (axis != 0 && axis < 4) segment.b.x = segment.a.x;
  if (axis != 1 && axis < 4) segment.b.y = segment.a.y;
  if (axis != 2 && axis < 4) segment.b.z = segment.a.z;
  return segment;
}

// `count` segments of whole coordinates below `reach`, times `scale` (rounded), plus `offset`.
Tally along_axes(std::uint64_t seed, int count, double reach, double scale, const Vec3& offset,
                 double fov) {
  Tally tally;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t own = seed + static_cast<std::uint64_t>(i);
    SCOPED_TRACE("seed " + std::to_string(own));
    Random random(own);
    const Vec3 eye = whole_point(random, reach) * scale + offset;
    Segment segment = segment_in(random, reach);
    segment.a = segment.a * scale + offset;
    segment.b = segment.b * scale + offset;
    const Viewpoint viewpoint = along_an_axis(random, eye, fov);
    check(frame_calculator::view_transform(viewpoint, any_raster(random)), segment, random, tally);
  }
  return tally;
}

TEST(ShortLine, HoldsWholeCoordinates) {
  for (const double reach : {1.0, 8.0, 1000.0, 1e6}) {
    SCOPED_TRACE(reach);
    EXPECT_EQ(along_axes(1, 1000, reach, 1, {}, 90).share(), 1);
    EXPECT_EQ(along_axes(2000, 1000, reach, 0x1p-10, {}, 90).share(), 1);
  }
  EXPECT_EQ(along_axes(4000, 1000, 1000, 1, {}, 60).share(), 1);
}

TEST(ShortLine, HoldsWholeCoordinatesAnEarthRadiusAway) {
  for (const double scale : {1.0, 0.125, 1.0 / 1024}) {
    SCOPED_TRACE(scale);
    EXPECT_EQ(along_axes(6000, 1000, 1000, scale, {6371000, -6371000, 6371000}, 90).share(), 1);
  }
}

// Of these the ones that are parallel to an axis.
TEST(ShortLine, HoldsTenths) {
  for (const double reach : {20.0, 1e5}) {
    SCOPED_TRACE(reach);
    const Tally tally = along_axes(8000, 4000, reach, 0.1, {}, 90);
    EXPECT_GT(tally.share(), 0.4);
    EXPECT_LT(tally.share(), 1);
  }
}

TEST(ShortLine, IsRightAtEveryScale) {
  for (const double scale : {1e-300, 1e-12, 1e-3, 1e3, 1e12, 1e200}) {
    SCOPED_TRACE(scale);
    for (const double fov : {0.01, 60.0, 179.99}) along_axes(12000, 300, 100, scale, {}, fov);
    along_axes(14000, 300, 100, scale, {6.4e6, 1e-3, -7}, 90);
  }
}

TEST(ShortLine, IsRightInAnyAttitude) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Viewpoint viewpoint;
    viewpoint.eye.position = whole_point(random, 50);
    viewpoint.eye.heading = 45.0 * static_cast<double>(random.below(8));
    if (random.below(2)) viewpoint.eye.heading = random.between(-180, 180);
    if (random.below(2)) viewpoint.eye.pitch = random.between(-90, 90);
    if (random.below(2)) viewpoint.eye.roll = random.between(-180, 180);
    viewpoint.fov = random.below(2) ? 90 : random.between(1, 170);
    check(frame_calculator::view_transform(viewpoint, any_raster(random)), segment_in(random, 50),
          random, tally);
  }
  EXPECT_GT(tally.held, 0);
  EXPECT_LT(tally.share(), 1);
}

// A focal length of all the bits of a double, and so narrow a field of view that it counts.
TEST(ShortLine, IsRightWithLongFocalLengths) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    ViewTransform view =
        frame_calculator::view_transform(along_an_axis(random, {}, 90), any_raster(random));
    view.focal = std::ldexp(random.between(1, 2), static_cast<int>(random.below(100)) - 20);
    const double scale = std::ldexp(1, static_cast<int>(random.below(30)));
    check(view, segment_in(random, scale), random, tally);
  }
  EXPECT_GT(tally.share(), 0.1);
  EXPECT_LT(tally.share(), 1);
}

// Numbers of more and more bits: there is a line as long as they fit, and none beyond; where there
// is one it is right. Long in one coordinate, in all, by size or by a fraction.
TEST(ShortLine, EndsWhereTheNumbersAreTooLong) {
  Viewpoint viewpoint;
  viewpoint.fov = 90;
  Random random(1);
  for (const Raster& raster : {Raster{1, 1}, Raster{16384, 16384}, Raster{1023, 767}})
    for (int kind = 0; kind < 6; ++kind) {
      SCOPED_TRACE("kind " + std::to_string(kind));
      int longest = 0, shortest_missing = 200;
      for (int bits = 1; bits <= 120; ++bits) {
        SCOPED_TRACE("bits " + std::to_string(bits));
        const double far = std::ldexp(1, bits), near = std::nextafter(far, 0);
        Segment segment{{3, 7, 5}, {-2, 9, -4}};
        viewpoint.eye.position = {1, -1, 2};
        if (kind == 0) segment.b.x = far;
        if (kind == 1) segment.a = {-far, far, far};
        if (kind == 2) segment.a.y = segment.b.y = near;
        if (kind == 3) segment = {{-near, near, near}, {near, near, -near}};
        if (kind == 4) segment.a.x += std::ldexp(1, -std::min(bits, 51));
        if (kind == 5) viewpoint.eye.position.z = std::ldexp(1, -bits);
        const ViewTransform view = frame_calculator::view_transform(viewpoint, raster);
        Tally tally;
        check(view, segment, random, tally);
        if (tally.lines == 0) continue;
        if (tally.held)
          longest = bits;
        else
          shortest_missing = std::min(shortest_missing, bits);
      }
      EXPECT_GT(longest, 20);
      if (kind != 4) {
        EXPECT_LT(shortest_missing, 121);
      }
      if (kind == 0 || kind == 1 || kind == 5) {
        EXPECT_EQ(shortest_missing, longest + 1);
      }
    }
}

// At the limit of a coordinate, 2^100 units of the last place that any of them has.
TEST(ShortLine, TakesCoordinatesBelowTwoToThe100Units) {
  ViewTransform view;
  view.rotation = {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}};
  view.focal = 1;
  view.raster = {3, 3};
  const double limit = 0x1p100, below = std::nextafter(limit, 0);
  Random random(1);
  for (const double size : {below, limit, -below, -limit}) {
    SCOPED_TRACE(size);
    // Upright and straight ahead, so that nothing but the coordinate is long.
    const Segment segment{{0, size, 1}, {0, size, -1}};
    EXPECT_EQ(ShortView(view).line(segment.a, segment.b, 0).has_value(), std::abs(size) < limit);
    Tally tally;
    check(view, segment, random, tally);
    EXPECT_EQ(tally.held, std::abs(size) < limit);
  }
}

// What no whole numbers hold: the smallest doubles and the largest.
TEST(ShortLine, LeavesTheEndsOfDoublesToGmp) {
  ViewTransform view;
  view.rotation = {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}};
  const double smallest = std::numeric_limits<double>::denorm_min();
  const double largest = std::numeric_limits<double>::max();
  for (const double size : {smallest, -smallest, 0x1p-1030, largest, -largest, 0x1p1010})
    EXPECT_FALSE(ShortView(view).line({size, 1, 1}, {0, 2, -1}, 0)) << size;
  ViewTransform odd = view;
  odd.rotation.row[0].x = smallest;
  EXPECT_FALSE(ShortView(odd).line({1, 1, 1}, {0, 2, -1}, 0));
  odd = view;
  odd.rotation.row[0].x = 0x1p-101;  // too many bits beside the 1
  EXPECT_FALSE(ShortView(odd).line({1, 1, 1}, {0, 2, -1}, 0));
}

}  // namespace
}  // namespace cigsim::test
