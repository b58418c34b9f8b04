// SPDX-License-Identifier: MIT
#include "sim/stability/extremes.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cigsim::stability {
namespace {

constexpr double kEarthRadius = 6.4e6;  // metres

double half_tangent(double fov) { return std::tan(fov * std::numbers::pi / 360); }

// Sets the one quantity that an axis changes.
void set(Extremes& extremes, Axis axis, double value) {
  switch (axis) {
    case Axis::kScale:
      extremes.scale = value;
      break;
    case Axis::kOffset:
      extremes.offset = value;
      break;
    case Axis::kNear:
      extremes.ulps = value;
      break;
    case Axis::kParallel:
      extremes.angle = value;
      break;
    case Axis::kSliver:
      extremes.aspect = value;
      break;
    case Axis::kEdgeOn:
      extremes.grazing = value;
      break;
    case Axis::kFov:  // what is seen stays as large on the raster
      extremes.distance *= half_tangent(extremes.fov) / half_tangent(value);
      extremes.fov = value;
      break;
    case Axis::kDistance:
      extremes.distance *= value / Extremes().distance;
      break;
    case Axis::kMixed:
      break;
  }
}

}  // namespace

std::string_view name_of(Axis axis) {
  switch (axis) {
    case Axis::kScale:
      return "scale";
    case Axis::kOffset:
      return "offset";
    case Axis::kNear:
      return "near";
    case Axis::kParallel:
      return "parallel";
    case Axis::kSliver:
      return "sliver";
    case Axis::kEdgeOn:
      return "edge-on";
    case Axis::kFov:
      return "fov";
    case Axis::kDistance:
      return "distance";
    case Axis::kMixed:
      break;
  }
  return "mixed";
}

std::string_view meaning_of(Axis axis) {
  switch (axis) {
    case Axis::kScale:
      return "all lengths times this";
    case Axis::kOffset:
      return "moved from the origin by this, environment units";
    case Axis::kNear:
      return "from where the decision changes, ulps of the largest coordinate";
    case Axis::kParallel:
      return "angle between planes or edges, radians";
    case Axis::kSliver:
      return "width over length, seen at angles from 1e-6 to 0.3 radians";
    case Axis::kEdgeOn:
      return "angle between a face and the line of sight, radians";
    case Axis::kFov:
      return "field of view, degrees";
    case Axis::kDistance:
      return "of the eyepoint, sizes of the thing";
    case Axis::kMixed:
      break;
  }
  return "all of them at once, each at random";
}

const std::vector<double>& values_of(Axis axis) {
  static const std::vector<double> scale{1e-12, 1e-9, 1e-6, 1e-3, 1, 1e3, 1e6, 1e9, 1e12};
  static const std::vector<double> offset{0, 1, 10, 100, 1e3, 1e4, 1e5, 1e6, kEarthRadius};
  static const std::vector<double> near{1e12, 1e9, 1e6, 1e4, 1000, 100, 10, 4, 2, 1, 0};
  static const std::vector<double> parallel{1, 0.1, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0};
  static const std::vector<double> sliver{1, 0.1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12};
  static const std::vector<double> edge_on{0.5, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 1e-15, 0};
  static const std::vector<double> fov{0.01, 0.1, 1, 10, 60, 120, 170, 178, 179};
  static const std::vector<double> distance{0.01, 0.1, 1, 3, 10, 100, 1e3, 1e4, 1e6};
  static const std::vector<double> mixed{0};
  switch (axis) {
    case Axis::kScale:
      return scale;
    case Axis::kOffset:
      return offset;
    case Axis::kNear:
      return near;
    case Axis::kParallel:
      return parallel;
    case Axis::kSliver:
      return sliver;
    case Axis::kEdgeOn:
      return edge_on;
    case Axis::kFov:
      return fov;
    case Axis::kDistance:
      return distance;
    case Axis::kMixed:
      break;
  }
  return mixed;
}

double extremity(Axis axis, double value) {
  const Extremes benign;
  switch (axis) {
    case Axis::kScale:
      return std::abs(std::log(value / benign.scale));
    case Axis::kFov:
      return std::abs(std::log(half_tangent(value) / half_tangent(benign.fov)));
    case Axis::kDistance:
      return std::abs(std::log(value / benign.distance));
    case Axis::kOffset:
    case Axis::kMixed:
      return value;
    case Axis::kNear:
    case Axis::kParallel:
    case Axis::kSliver:
    case Axis::kEdgeOn:
      break;
  }
  return -value;
}

Extremes at(Axis axis, double value, Random& random) {
  Extremes extremes;
  if (axis != Axis::kMixed) {
    set(extremes, axis, value);
    // What a sliver leaves open of its plane tells at low angles only.
    if (axis == Axis::kSliver) extremes.grazing = std::pow(10, random.between(-6, -0.5));
    return extremes;
  }
  for (const Axis each : kAxes) {
    if (each == Axis::kMixed) continue;
    const std::vector<double>& values = values_of(each);
    set(extremes, each, values[random.below(values.size())]);
  }
  return extremes;
}

}  // namespace cigsim::stability
