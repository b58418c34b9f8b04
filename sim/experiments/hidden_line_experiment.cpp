// SPDX-License-Identifier: MIT
#include "sim/experiments/hidden_line_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "models/environment/generate.hpp"
#include "models/environment/placement.hpp"
#include "models/environment/random.hpp"
#include "models/environment/shapes.hpp"
#include "models/hidden_line/scene_parts.hpp"
#include "sim/host_time.hpp"

namespace cigsim {
namespace {

using hidden_line::HiddenLines;

// His axes in a scene's coordinates: x to the right, y up, z towards the eye.
struct Axes {
  Vec3 x, y, z;
};
constexpr Axes kLattice{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr Axes kCity{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};  // buildings stand along the scene's z

struct DataSet {
  std::string name;
  Environment environment;
  bool cubes;
  Axes axes;
};

// Unit cubes at places of which no two are closer than a unit in every coordinate, in the block
// that the lattice of 32 takes.
Environment random_cubes(std::uint64_t seed) {
  Environment out;
  out.models.push_back({"cubes", 0});
  Random random(seed);
  std::vector<Vec3> centres;
  while (centres.size() < 32) {
    const Vec3 p{random.between(0, 9), random.between(0, 3), random.between(0, 9)};
    const bool clear = std::all_of(centres.begin(), centres.end(), [&](const Vec3& q) {
      return std::abs(p.x - q.x) > 1.01 || std::abs(p.y - q.y) > 1.01 || std::abs(p.z - q.z) > 1.01;
    });
    if (clear) centres.push_back(p);
  }
  const Vec3 half{0.5, 0.5, 0.5};
  for (const Vec3& p : centres) out.objects.push_back(box(p - half, p + half));
  return out;
}

std::vector<DataSet> data_sets(std::uint64_t seed, const Environment& city) {
  std::vector<DataSet> sets;
  for (const std::uint32_t n : {4u, 8u, 16u, 24u, 32u, 48u})
    sets.push_back(
        {std::to_string(n) + " cubes", generate_environment("cubes", {n, 1}), true, kLattice});
  sets.push_back({"16 rectangles", city, false, kCity});
  sets.push_back({"32 random cubes", random_cubes(seed), false, kLattice});
  return sets;
}

struct Extent {
  Vec3 centre;
  double radius;
};

Extent extent_of(const Environment& environment) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec3 low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};
  for (const Object& object : environment.objects)
    for (const Vec3& v : object.vertices) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
  const Vec3 half = (high - low) * 0.5;
  return {(low + high) * 0.5, std::sqrt(dot(half, half))};
}

// The data turned by an angle about his y (yaw) or x (pitch) axis, seen from his z axis: the eye
// goes round instead.
ViewTransform view_of(const Axes& axes, const Extent& extent, double degrees, bool pitch) {
  const double s = sin_degrees(degrees), c = cos_degrees(degrees);
  const Vec3 towards = pitch ? axes.y * s + axes.z * c : axes.x * s + axes.z * c;
  const Vec3 right = pitch ? axes.x : axes.x * c - axes.z * s;
  const Vec3 up = pitch ? axes.y * c - axes.z * s : axes.y;
  // All of the sphere round the set is in view at a field of view of 60 degrees.
  ViewTransform view;
  view.eye = extent.centre + towards * (2.25 * extent.radius);
  view.rotation = {{towards * -1.0, right, up}};
  view.raster = {1024, 1024};
  view.focal = 512 / 0.5773502691896257;
  return view;
}

std::size_t edge_count(const HiddenLines& lines) {
  std::size_t edges = 0;
  for (const hidden_line::Part& part : lines.parts()) edges += part.edges.size();
  return edges;
}

HiddenLineFrame measure(HiddenLines& lines, const ViewTransform& view) {
  HostTime time;
  lines.compute(view);
  const double ms = time.lap();
  return {lines.counters(), ms};
}

}  // namespace

std::vector<HiddenLineDataSet> run_hidden_line_experiment(const ExperimentOptions& options,
                                                          const Environment& city, int step) {
  std::vector<HiddenLineDataSet> out;
  const std::vector<DataSet> sets = data_sets(options.seed, city);
  for (const DataSet& source : sets) {
    Notices notices;
    const std::vector<Placement> placements(source.environment.systems.size());
    HiddenLines lines(hidden_line::scene_parts(source.environment, placements, {}, notices));
    HiddenLineDataSet& set = out.emplace_back();
    set.name = source.name;
    set.cubes = source.cubes;
    set.objects = source.environment.objects.size();
    set.edges = edge_count(lines);
    const Extent extent = extent_of(source.environment);
    for (const bool pitch : {false, true})
      for (int degrees = 0; degrees < 360; degrees += step) {
        (pitch ? set.pitch : set.yaw)
            .push_back(measure(lines, view_of(source.axes, extent, degrees, pitch)));
        if (options.progress)
          options.progress(
              (static_cast<double>(out.size() - 1) + (pitch ? 0.5 : 0) + degrees / 720.0) /
              static_cast<double>(sets.size()));
      }
  }
  return out;
}

double average(const HiddenLineDataSet& set, std::uint64_t hidden_line::Counters::*counter) {
  double sum = 0;
  for (const auto* frames : {&set.yaw, &set.pitch})
    for (const HiddenLineFrame& frame : *frames)
      sum += static_cast<double>(frame.counters.*counter);
  return sum / static_cast<double>(set.yaw.size() + set.pitch.size());
}

double average_ms(const HiddenLineDataSet& set) {
  double sum = 0;
  for (const auto* frames : {&set.yaw, &set.pitch})
    for (const HiddenLineFrame& frame : *frames) sum += frame.ms;
  return sum / static_cast<double>(set.yaw.size() + set.pitch.size());
}

}  // namespace cigsim
