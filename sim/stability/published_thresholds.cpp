// SPDX-License-Identifier: MIT
#include "sim/stability/published_thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "models/database/separation_planes/body.hpp"
#include "models/database/separation_planes/published.hpp"
#include "models/database/separation_planes/separate.hpp"
#include "models/environment/generators.hpp"
#include "models/environment/input_error.hpp"
#include "models/numeric/plane.hpp"

namespace cigsim::stability {
namespace {

using separation_planes::PublishedProgram;
using separation_planes::UnitPlane;

constexpr double kApart = 3;  // of the prisms' middles; their spheres have radius 1.2
constexpr double kReach = 0x1p-30;

// Six corners on a circle. The first three are 60 degrees apart times `share`.
Object turned_prism(const Vec3& middle, double share, Random& random) {
  const Mat3 turn = random_rotation(random);
  const double high = random.between(0.2, 0.6), step = std::numbers::pi / 3;
  const double angles[] = {0, step * share, 2 * step * share, 3 * step, 4 * step, 5 * step};
  Object object;
  for (const double level : {-high, high})
    for (const double angle : angles)
      object.vertices.push_back(middle + turn * Vec3{std::cos(angle), std::sin(angle), level});
  object.faces.push_back({{6, 7, 8, 9, 10, 11}, {}});
  object.faces.push_back({{5, 4, 3, 2, 1, 0}, {}});
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t next = (i + 1) % 6;
    object.faces.push_back({{i, next, next + 6, i + 6}, {}});
  }
  // His program takes the last three of a face listed anticlockwise: the cards have it clockwise.
  std::rotate(object.faces[0].vertices.begin(), object.faces[0].vertices.begin() + 3,
              object.faces[0].vertices.end());
  return object;
}

StumpDeck make_deck(double scale, double share, int objects, Random& random) {
  StumpDeck deck;
  for (int o = 0; o < objects; ++o) {
    const Vec3 middle{kApart * o, random.between(-1, 1), random.between(-1, 1)};
    Object object = turned_prism(middle, share, random);
    for (Vec3& v : object.vertices) v = v * scale;
    deck.objects.push_back(std::move(object));
  }
  return deck;
}

// The plane of a candidate without rounding: through nodes 1, 2 and 3 of the card.
Plane exact_plane(const Object& object, const Face& face) {
  const std::size_t n = face.vertices.size();
  const auto node = [&](std::size_t i) { return object.vertices[face.vertices[n - i]]; };
  return plane_through(node(2), node(1), node(3));
}

// +1, -1, or 0: cut, or in the plane altogether.
int exact_state(const Plane& plane, const Object& object) {
  bool plus = false, minus = false;
  for (const Vec3& v : object.vertices) {
    const int s = side(plane, v);
    plus = plus || s > 0;
    minus = minus || s < 0;
  }
  return plus == minus ? 0 : plus ? 1 : -1;
}

void judge_sides(const StumpDeck& deck, const PublishedProgram& program, ThresholdPoint& point) {
  std::size_t candidate = 0;
  for (std::size_t owner = 0; owner < deck.objects.size(); ++owner)
    for (const Face& face : deck.objects[owner].faces) {
      const Plane plane = exact_plane(deck.objects[owner], face);
      ++point.faces;
      for (std::size_t o = 0; o < deck.objects.size(); ++o) {
        const int told = program.state(candidate, o);
        if (o == owner) {
          point.own_cut += told == 0;
          continue;
        }
        const int right = exact_state(plane, deck.objects[o]);
        ++point.decisions;
        point.wrong_sides += told == -right && right != 0;
        point.missed_cuts += right == 0 && told != 0;
        point.false_cuts += right != 0 && told == 0;
      }
      ++candidate;
    }
}

// Whether no vertex reaches across by more than kReach of the deck's size.
bool parts(const UnitPlane& plane, const std::vector<Vec3>& on_true,
           const std::vector<Vec3>& on_false, double size) {
  const ExactVec n = convert<Exact>(plane.normal);
  const Exact distance(plane.distance), reach(kReach * size);
  const auto height = [&](const Vec3& v) { return Exact(dot(n, convert<Exact>(v)) - distance); };
  return std::all_of(on_true.begin(), on_true.end(),
                     [&](const Vec3& v) { return height(v) >= -reach; }) &&
         std::all_of(on_false.begin(), on_false.end(),
                     [&](const Vec3& v) { return height(v) <= reach; });
}

bool is_right(const separation_planes::PublishedTable& table, const StumpDeck& deck, double size) {
  for (const separation_planes::ChosenPlane& chosen : table.planes)
    for (const ObjectPair& pair : chosen.pairs)
      if (!parts(chosen.plane, deck.objects[pair.true_object - 1].vertices,
                 deck.objects[pair.false_object - 1].vertices, size))
        return false;
  return true;
}

bool is_right(const separation_planes::SeparationResult& result) {
  for (const separation_planes::ResultPlane& chosen : result.planes)
    for (const ObjectPair& pair : chosen.pairs) {
      const auto on = [&](std::uint32_t object, int wrong) {
        const auto& corners = result.bodies[object - 1].corners;
        return std::none_of(corners.begin(), corners.end(), [&](const auto& c) {
          return (c.exact ? side(chosen.plane, *c.exact) : side(chosen.plane, c.rounded)) == wrong;
        });
      };
      if (!on(pair.true_object, -1) || !on(pair.false_object, 1)) return false;
    }
  return true;
}

void judge_tables(const StumpDeck& deck, const PublishedProgram* program, double size,
                  ThresholdPoint& point) {
  if (program != nullptr) {
    const separation_planes::PublishedTable table = program->run();
    point.found += table.found;
    point.right += table.found && is_right(table, deck, size);
  }
  separation_planes::SeparateOptions options;
  options.most_steps = 1000;
  options.most_corner_planes = 0;
  try {
    const separation_planes::SeparationResult exact = separation_planes::separate(deck, options);
    ++point.exact_found;
    point.exact_right += is_right(exact);
  } catch (const separation_planes::NotApart&) {
  } catch (const separation_planes::NotToBeSplit&) {
  }
}

ThresholdPoint judge(ThresholdAxis axis, double value, const ThresholdOptions& options) {
  ThresholdPoint point;
  point.axis = axis;
  point.value = value;
  const double scale = axis == ThresholdAxis::kScale ? value : 1;
  const double share = axis == ThresholdAxis::kSliver ? value : 1;
  // The same bodies at every value.
  Random random(options.seed);
  for (int d = 0; d < options.decks; ++d) {
    const StumpDeck deck = make_deck(scale, share, options.objects, random);
    const double size = kApart * options.objects * scale;
    ++point.decks;
    try {
      const PublishedProgram program(deck, "deck");
      judge_sides(deck, program, point);
      judge_tables(deck, &program, size, point);
    } catch (const InputError&) {
      ++point.refused;
      judge_tables(deck, nullptr, size, point);
    }
  }
  return point;
}

}  // namespace

std::string_view name_of(ThresholdAxis axis) {
  return axis == ThresholdAxis::kScale ? "scale" : "sliver";
}

std::vector<double> threshold_values(ThresholdAxis axis) {
  if (axis == ThresholdAxis::kScale)
    return {1e-12, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1, 1e2, 1e4, 1e6, 1e9, 1e12};
  return {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-10, 1e-12};
}

std::vector<ThresholdPoint> measure_thresholds(const ThresholdOptions& options) {
  if (options.objects < 2 || options.objects > 8)
    throw std::invalid_argument("objects: 2..8 of a deck");
  std::vector<ThresholdPoint> points;
  const std::size_t all = threshold_values(ThresholdAxis::kScale).size() +
                          threshold_values(ThresholdAxis::kSliver).size();
  for (const ThresholdAxis axis : {ThresholdAxis::kScale, ThresholdAxis::kSliver})
    for (const double value : threshold_values(axis)) {
      points.push_back(judge(axis, value, options));
      if (options.progress)
        options.progress(static_cast<double>(points.size()) / static_cast<double>(all));
    }
  return points;
}

}  // namespace cigsim::stability
