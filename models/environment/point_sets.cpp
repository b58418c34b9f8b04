// SPDX-License-Identifier: MIT
#include "models/environment/point_sets.hpp"

#include <cmath>
#include <numbers>

#include "models/environment/random.hpp"

namespace cigsim {
namespace {

constexpr std::array<std::uint32_t, 8> kSizes{25, 50, 100, 200, 400, 800, 1600, 3200};

// Normal numbers within ±limit, two from two uniform ones (Levine 1975, ch. VII).
class NormalNumbers {
 public:
  NormalNumbers(Random& random, double limit) : random_(random), limit_(limit) {}

  double next() {
    for (;;) {
      const double value = draw();
      if (std::abs(value) < limit_) return value;
    }
  }

 private:
  double draw() {
    if (has_second_) {
      has_second_ = false;
      return second_;
    }
    const double t1 = std::sqrt(-2 * std::log(1 - random_.unit()));
    const double t2 = 2 * std::numbers::pi * random_.unit();
    second_ = t1 * std::cos(t2);
    has_second_ = true;
    return t1 * std::sin(t2);
  }

  Random& random_;
  double limit_;
  double second_ = 0;
  bool has_second_ = false;
};

// Where a distribution is cut off, in standard deviations; 0: it is uniform.
double limit_of(PointDistribution distribution) {
  switch (distribution) {
    case PointDistribution::kCube1:
    case PointDistribution::kSphere1:
      return 1;
    case PointDistribution::kCube2:
    case PointDistribution::kSphere2:
      return 2;
    case PointDistribution::kCube4:
    case PointDistribution::kSphere4:
      return 4;
    case PointDistribution::kPolyhedron:
    case PointDistribution::kEllipse:
      break;
  }
  return 0;
}

Vec3 uniform_point(PointDistribution distribution, Random& random) {
  // Braces evaluate from left to right.
  if (distribution == PointDistribution::kPolyhedron)
    return Vec3{random.between(0, 2), random.between(0, 2), random.between(0, 2)};
  return Vec3{random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
}

}  // namespace

std::string_view name_of(PointDistribution distribution) {
  constexpr std::array<std::string_view, 8> kNames{"cube-1",   "cube-2",   "cube-4",   "polyhedron",
                                                   "sphere-1", "sphere-2", "sphere-4", "ellipse"};
  return kNames.at(static_cast<std::size_t>(distribution));
}

std::span<const std::uint32_t> published_sizes(PointDistribution distribution) {
  switch (distribution) {
    case PointDistribution::kCube1:
    case PointDistribution::kCube2:
    case PointDistribution::kCube4:
      return kSizes;
    case PointDistribution::kPolyhedron:
    case PointDistribution::kEllipse:
      return std::span(kSizes).first(7);
    case PointDistribution::kSphere1:
    case PointDistribution::kSphere2:
    case PointDistribution::kSphere4:
      break;
  }
  return std::span(kSizes).first(6);
}

bool inside(PointDistribution distribution, const Vec3& p) {
  const double limit = limit_of(distribution);
  switch (distribution) {
    case PointDistribution::kCube1:
    case PointDistribution::kCube2:
    case PointDistribution::kCube4:
      return std::abs(p.x) <= limit && std::abs(p.y) <= limit && std::abs(p.z) <= limit;
    case PointDistribution::kSphere1:
    case PointDistribution::kSphere2:
    case PointDistribution::kSphere4:
      return dot(p, p) <= limit * limit;
    case PointDistribution::kPolyhedron:
      return p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x <= 2 && p.y <= 1 && p.z <= 1;
    case PointDistribution::kEllipse:
      break;
  }
  return p.x * p.x / 4 + p.y * p.y + p.z * p.z <= 1;
}

std::vector<Vec3> random_points(PointDistribution distribution, std::size_t count,
                                std::uint64_t seed, std::uint32_t case_number) {
  // One generator a case: its state is the bits of another one, so that near numbers are far apart.
  Random spread(seed + (std::uint64_t{case_number} << 8) +
                static_cast<std::uint64_t>(distribution));
  Random random(spread.bits() ^ count);
  const double limit = limit_of(distribution);
  NormalNumbers normal(random, limit);
  std::vector<Vec3> points;
  points.reserve(count);
  while (points.size() < count) {
    const Vec3 p = limit > 0 ? Vec3{normal.next(), normal.next(), normal.next()}
                             : uniform_point(distribution, random);
    if (inside(distribution, p)) points.push_back(p);
  }
  return points;
}

}  // namespace cigsim
