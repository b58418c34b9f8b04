// SPDX-License-Identifier: MIT
#include "models/environment/generate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "models/environment/generators.hpp"

namespace cigsim {
namespace {

using Generator = void (*)(Environment&, std::uint32_t, Random&);

struct Kind {
  GenerateKind kind;
  Generator generator;
};

constexpr Kind kKinds[] = {
    {{"city", "buildings on a street grid, some of them turned, on flat ground"}, generate_city},
    {{"cubes", "Levine's unit cubes, two units apart (his sets: 4, 8, 16, 24, 32, 48)"},
     generate_cubes},
    {{"random", "disjoint convex solids, turned at random, of sizes over three decades"},
     generate_random},
    {{"brushes", "touching convex solids: walls with doors, floors, stairs, wedges"},
     generate_brushes},
    {{"soup", "triangles, parallelograms and tetrahedra that pass through each other"},
     generate_soup}};

/// A view from the south-west and above that sees every object: the sphere about their bounds fits
/// into the field of view.
DefaultView view_of(const Environment& environment) {
  const double infinity = std::numeric_limits<double>::infinity();
  Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  for (const Object& object : environment.objects)
    for (const Vec3& v : object.vertices) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
  const Vec3 centre = (low + high) * 0.5, half = (high - low) * 0.5;
  const double distance = 2.25 * std::sqrt(dot(half, half));
  const Vec3 direction{0.36, 0.78, -0.51};
  DefaultView view;
  view.eye.position = on_grid(centre - direction * distance);
  constexpr double kDegrees = 180 / std::numbers::pi;
  view.eye.heading = on_grid(std::atan2(direction.x, direction.y) * kDegrees);
  view.eye.pitch =
      on_grid(std::atan2(direction.z, std::hypot(direction.x, direction.y)) * kDegrees);
  return view;
}

}  // namespace

double on_grid(double value) { return std::floor(value * 1024 + 0.5) / 1024; }
Vec3 on_grid(const Vec3& value) { return {on_grid(value.x), on_grid(value.y), on_grid(value.z)}; }

Mat3 random_rotation(Random& random) {
  double w, x, y, z, norm;
  do {
    w = random.between(-1, 1);
    x = random.between(-1, 1);
    y = random.between(-1, 1);
    z = random.between(-1, 1);
    norm = w * w + x * x + y * y + z * z;
  } while (norm > 1 || norm < 0.01);
  const double s = 2 / norm;
  return {{{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
           {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
           {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}}};
}

std::uint32_t root_up(std::uint32_t n, int power) {
  std::uint64_t m = 1;
  while ((power == 2 ? m * m : m * m * m) < n) ++m;
  return static_cast<std::uint32_t>(m);
}

const std::vector<GenerateKind>& generate_kinds() {
  static const std::vector<GenerateKind> kinds = [] {
    std::vector<GenerateKind> list;
    for (const Kind& k : kKinds) list.push_back(k.kind);
    return list;
  }();
  return kinds;
}

Environment generate_environment(std::string_view kind, const GenerateOptions& options) {
  const auto* const found = std::find_if(std::begin(kKinds), std::end(kKinds),
                                         [&](const Kind& k) { return k.kind.name == kind; });
  if (found == std::end(kKinds)) {
    std::string known;
    for (const Kind& k : kKinds) known += (known.empty() ? "" : ", ") + std::string(k.kind.name);
    throw std::invalid_argument("unknown kind \"" + std::string(kind) + "\"; choose " + known);
  }
  if (options.objects == 0)
    throw std::invalid_argument("a scene needs at least one object; ask for 1 or more");
  Environment environment;
  environment.name = std::string(kind) + " of " + std::to_string(options.objects) + ", seed " +
                     std::to_string(options.seed);
  environment.models.push_back({std::string(kind), 0});
  environment.objects.reserve(options.objects);
  Random random(options.seed);
  found->generator(environment, options.objects, random);
  environment.view = view_of(environment);
  return environment;
}

}  // namespace cigsim
