// SPDX-License-Identifier: MIT
// Levels of detail: which description is shown against rational arithmetic, and pictures against
// the oracle on the objects that are then to be seen, in worlds where choices lie apart, touch, and
// pass through other things and each other.
#include "models/environment/detail.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "models/database/database_json.hpp"
#include "models/database/prepare.hpp"
#include "models/environment/placement.hpp"
#include "models/frame_calculator/detail.hpp"
#include "models/frame_calculator/functional.hpp"
#include "sim/functional_machine.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/cases.hpp"
#include "tests/support/picture_check.hpp"
#include "tests/support/viewpoints.hpp"

namespace cigsim::test {
namespace {

using frame_calculator::description_shown;

// The rule in rational numbers: thresholds that the projected radius is above.
std::uint32_t exact_description(const Sphere& sphere, const std::vector<double>& thresholds,
                                const ViewTransform& view, double scale) {
  const ExactVec d = convert<Exact>(sphere.centre) - convert<Exact>(view.eye);
  const Exact u = dot(convert<Exact>(view.rotation.row[0]), d);
  std::uint32_t description = 0;
  for (const double threshold : thresholds)
    description +=
        u <= 0 || Exact(view.focal) * Exact(sphere.radius) / u > Exact(threshold) * Exact(scale);
  return description;
}

TEST(DetailChoice, IsLevinesProjectedRadiusAgainstTheThresholds) {
  // Eye at the origin looking north; focal length 100 elements, radius 2, 50 ahead: 4 elements.
  ViewTransform view;
  view.rotation = body_axes({});
  view.focal = 100;
  const Sphere sphere{{7, 50, -3}, 2};
  const double above = std::nextafter(4.0, 5.0), below = std::nextafter(4.0, 3.0);
  const auto shown = [&](std::vector<double> thresholds, double scale = 1) {
    return description_shown(sphere, thresholds, view, scale);
  };
  EXPECT_EQ(shown({}), 0u);
  EXPECT_EQ(shown({4, 40}), 0u) << "up to and with the threshold";
  EXPECT_EQ(shown({above, 40}), 0u);
  EXPECT_EQ(shown({below, 40}), 1u);
  EXPECT_EQ(shown({1, 2}), 2u);
  EXPECT_EQ(shown({2, 4}, 2), 0u);
  EXPECT_EQ(shown({2, 4}, 0.5), 2u);
  EXPECT_EQ(shown({1e300, 1.5e300}, 0), 2u);
  for (const double y : {0.0, -50.0})  // beside and behind the eyepoint
    EXPECT_EQ(description_shown({{7, y, 0}, 2}, std::vector<double>{1e9}, view, 1), 1u);
}

TEST(DetailChoice, IsExactForAllDoubles) {
  constexpr std::uint64_t kSeed = 20261101;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  std::uint64_t near = 0;
  for (unsigned i = 0; i < cases(20000); ++i) {
    const int decades = i % 3 == 0 ? 250 : 3;
    const auto size = [&] { return std::pow(10, random.between(-decades, decades)); };
    ViewTransform view;
    view.eye = random_direction(random) * size();
    view.rotation = body_axes({{}, random.between(-180, 180), random.between(-90, 90), 0});
    view.focal = size();
    const double distance = size();
    const Sphere sphere{
        view.eye + view.rotation.row[0] * distance + random_direction(random) * (distance / 2),
        size()};
    const double scale = random.below(2) ? 1 : size();
    // At the radius as rounded, an ulp off, and anywhere.
    const double u = dot(view.rotation.row[0], sphere.centre - view.eye);
    double threshold = view.focal * sphere.radius / u / scale;
    if (!(threshold > 0) || !std::isfinite(threshold)) threshold = size();
    const std::vector<double> thresholds{
        threshold / 2, std::nextafter(threshold, 0.0), threshold,
        std::nextafter(threshold, std::numeric_limits<double>::infinity())};
    const std::uint32_t want = exact_description(sphere, thresholds, view, scale);
    near += want == 1 || want == 2 || want == 3;
    ASSERT_EQ(description_shown(sphere, thresholds, view, scale), want) << "case " << i;
  }
  EXPECT_GT(near, cases(20000) / 20);
}

// What the worlds met; a test that met nothing would prove nothing.
struct Met {
  std::uint64_t kept = 0, given_up = 0, cut = 0, nested = 0, empty = 0;
  std::vector<std::uint32_t> shown = std::vector<std::uint32_t>(8, 0);
};

// Throws some objects of a world into choices, some of them within others. Each choice has
// thresholds of its own, by which it is found again in the database.
void add_choices(World& world, Random& random, std::uint32_t count) {
  Environment& e = world.environment;
  count = std::min(count, static_cast<std::uint32_t>(e.objects.size()));
  for (std::uint32_t c = 0; c < count; ++c) {
    Choice choice;
    choice.name = std::to_string(c);
    const std::size_t descriptions = 2 + random.below(3);
    while (choice.thresholds.size() + 1 < descriptions)
      choice.thresholds.push_back(std::pow(10, random.between(-1, 3)));
    std::sort(choice.thresholds.begin(), choice.thresholds.end());
    const auto random_place = [&](std::uint32_t in) {
      return DescriptionRef{
          in, static_cast<std::uint32_t>(random.below(e.choices[in].thresholds.size() + 1))};
    };
    if (c > 0 && random.below(3) == 0)
      choice.within = random_place(static_cast<std::uint32_t>(random.below(c)));
    e.choices.push_back(choice);
  }
  for (std::size_t o = 0; o < e.objects.size(); ++o) {
    const auto in = static_cast<std::uint32_t>(o < count ? o : random.below(2 * count));
    if (in >= count) continue;
    const std::uint32_t last = static_cast<std::uint32_t>(e.choices[in].thresholds.size());
    e.objects[o].within =
        DescriptionRef{in, o < count ? last : static_cast<std::uint32_t>(random.below(last + 1))};
  }
}

// The description of each choice that must be shown: of those given up the last.
std::vector<std::uint32_t> shown_descriptions(const Environment& e, const Database& database,
                                              const ViewTransform& view, Met& met) {
  std::vector<std::uint32_t> shown;
  for (const Choice& choice : e.choices) {
    const std::uint32_t s = e.models[choice.model].system;
    const PreparedSystem& system = database.systems[s];
    const auto& kept = system.hierarchy.choices;
    const auto at = std::find_if(kept.begin(), kept.end(), [&](const PreparedChoice& c) {
      return c.thresholds == choice.thresholds;
    });
    if (at == kept.end()) {
      shown.push_back(static_cast<std::uint32_t>(choice.thresholds.size()));
      continue;
    }
    Sphere sphere = at->sphere;
    if (s > 0) sphere.centre = Placing(frame_calculator::placement_at(system, 0))(sphere.centre);
    shown.push_back(exact_description(sphere, choice.thresholds, view, 1));
    ++met.shown[shown.back()];
  }
  return shown;
}

World only_shown(const World& world, const std::vector<std::uint32_t>& shown) {
  World out = world;
  for (Object& object : out.environment.objects)
    for (std::optional<DescriptionRef> at = object.within; at;
         at = world.environment.choices[at->choice].within)
      if (at->description != shown[at->choice]) object.faces.clear();
  return out;
}

void count(const World& world, const Database& database, Met& met) {
  for (const PreparedSystem& system : database.systems) {
    std::vector<int> groups(system.hierarchy.choices.size(), 0);
    for (const Group& group : system.hierarchy.groups)
      if (group.choice != kNone) ++groups[group.choice];
    for (const int n : groups) {
      EXPECT_GT(n, 0);
      met.cut += n > 1;
    }
    met.kept += groups.size();
    for (const Member& member : system.hierarchy.members) met.empty += member.placeholder;
  }
  for (const Choice& choice : world.environment.choices) met.nested += choice.within.has_value();
  for (const Notice& notice : database.report.notices)
    if (notice.what.starts_with("choice that cannot")) met.given_up += notice.count;
}

// Every vertex of a choice, whatever its description, lies in its sphere.
void check_spheres(const Environment& e, const Database& database) {
  for (std::uint32_t c = 0; c < e.choices.size(); ++c)
    for (const PreparedSystem& system : database.systems)
      for (const PreparedChoice& choice : system.hierarchy.choices) {
        if (choice.thresholds != e.choices[c].thresholds) continue;
        for (const Object& object : e.objects) {
          if (!object.within || object.within->choice != c) continue;
          for (const Face& face : object.faces)
            for (const std::uint32_t v : face.vertices) {
              const ExactVec d =
                  convert<Exact>(object.vertices[v]) - convert<Exact>(choice.sphere.centre);
              EXPECT_LE(dot(d, d), Exact(choice.sphere.radius) * Exact(choice.sphere.radius));
            }
        }
      }
}

void check_choices_of(const World& world, Random& random, int views, const std::string& what,
                      Tally& tally, Met& met) {
  const Database database = prepare(world.environment);
  check_database(database);
  check_database(database_from_json(nlohmann::json::parse(database_to_json(database).dump())));
  count(world, database, met);
  check_spheres(world.environment, database);
  for (int v = 0; v < views; ++v) {
    const Viewpoint viewpoint = plain_viewpoint(world.environment, random);
    const Raster raster = random_raster(random, 24);
    const World shown = only_shown(
        world, shown_descriptions(world.environment, database,
                                  frame_calculator::view_transform(viewpoint, raster), met));
    check_machine(polygons_of(shown), database, viewpoint, raster, 0, Strictness::kEveryElement,
                  what + " view " + std::to_string(v), tally);
  }
}

template <class Make>
Met check_worlds(std::uint64_t first_seed, unsigned seeds, Make make) {
  Tally tally;
  Met met;
  for (std::uint64_t seed = first_seed; seed < first_seed + cases(seeds); ++seed) {
    Random random(seed);
    World world = make(random);
    add_choices(world, random, 1 + static_cast<std::uint32_t>(random.below(4)));
    check_choices_of(world, random, 4, "seed " + std::to_string(seed), tally, met);
    if (testing::Test::HasFailure()) break;
  }
  std::cout << tally.pictures << " pictures; choices " << met.kept << " kept, " << met.given_up
            << " given up, " << met.cut << " cut, " << met.nested << " within others, " << met.empty
            << " placeholders; shown";
  for (const std::uint32_t n : met.shown) std::cout << " " << n;
  std::cout << "\n";
  return met;
}

// A row of cells; in each a body, or a choice between a box that fills it, bodies, and nothing.
World cells_with_choices(Random& random) {
  World world;
  Environment& e = world.environment;
  for (int cell = 0; cell < 5; ++cell) {
    const Vec3 low{4.0 * cell, 0, 0}, high{4.0 * cell + 4, 4, 4}, middle = (low + high) * 0.5;
    if (random.below(4) == 0) {
      world.add(random_body(middle, 1.9, random));
      continue;
    }
    const auto c = static_cast<std::uint32_t>(e.choices.size());
    e.choices.push_back({"cell", 0, {}, {random.between(1, 9), random.between(10, 99)}});
    const auto add = [&](std::uint32_t description, Object object) {
      object.within = DescriptionRef{c, description};
      world.add(std::move(object));
    };
    if (random.below(3) != 0) add(0, box_between(low, high));
    if (random.below(3) != 0) add(1, random_hull(middle, 1.9, random));
    add(2, random_tetrahedron(middle - Vec3{0.9, 0, 0}, 0.8, random));
    add(2, random_tetrahedron(middle + Vec3{0.9, 0, 0}, 0.8, random));
  }
  return world;
}

TEST(DetailPictures, OfChoicesInCells) {
  Tally tally;
  Met met;
  for (std::uint64_t seed = 1; seed <= cases(20); ++seed) {
    Random random(seed);
    check_choices_of(cells_with_choices(random), random, 6, "seed " + std::to_string(seed), tally,
                     met);
  }
  EXPECT_EQ(met.given_up, 0u);
  EXPECT_EQ(met.cut, 0u);
  EXPECT_GT(met.empty, 0u);
  for (int d = 0; d < 3; ++d) EXPECT_GT(met.shown[d], 20u);
}

TEST(DetailPictures, OfTouchingBodies) {
  const Met met = check_worlds(100, 12, touching_world);
  EXPECT_GT(met.kept, 0u);
  EXPECT_GT(met.cut, 0u);
}

TEST(DetailPictures, OfBodiesThatPassThroughEachOther) {
  const Met met = check_worlds(200, 12, [](Random& random) {
    return body_soup(random, 2 + static_cast<int>(random.below(5)));
  });
  EXPECT_GT(met.kept, 0u);
}

TEST(DetailPictures, OfTrianglesThatPassThroughEachOther) {
  check_worlds(300, 12, [](Random& random) {
    return triangle_soup(random, 2 + static_cast<int>(random.below(6)));
  });
}

TEST(DetailPictures, OfGridBoxesWithCoplanarFaces) {
  check_worlds(400, 16, [](Random& random) {
    return grid_boxes(random, 2 + static_cast<int>(random.below(5)));
  });
}

TEST(DetailPictures, OfCoplanarPolygonsThatOverlap) {
  const Met met = check_worlds(500, 16, [](Random& random) {
    return coplanar_polygons(random, 2 + static_cast<int>(random.below(6)));
  });
  EXPECT_GT(met.given_up, 0u);
}

TEST(DetailPictures, OfLatticesWhereEverythingCoincides) {
  check_worlds(600, 16, [](Random& random) {
    return lattice_world(random, 2 + static_cast<int>(random.below(6)));
  });
}

TEST(DetailPictures, OfConcaveBodies) {
  check_worlds(700, 10, [](Random& random) { return cell_bodies(random, 3); });
}

TEST(DetailPictures, OfBodiesWithinBodies) { check_worlds(800, 8, nested_world); }

// Static choices, empty descriptions among them, and a moving model with a choice of its own.
TEST(DetailPictures, WithMovingModelsAmongAndWithChoices) {
  Tally tally;
  Met met;
  for (std::uint64_t seed = 900; seed < 900 + cases(24); ++seed) {
    Random random(seed);
    World world;
    Environment& e = world.environment;
    const auto add = [&](std::uint32_t model, std::optional<DescriptionRef> within, Object object) {
      object.model = model;
      object.within = within;
      world.add(std::move(object));
    };
    e.systems.push_back(
        {"moving",
         {},
         {{0,
           {random_direction(random) * 2, random.between(0, 360), random.between(-90, 90), 0}}}});
    e.models.push_back({"mover", 1});
    e.choices = {{"left", 0, {}, {random.between(1, 20)}},
                 {"right", 0, {}, {random.between(1, 20), random.between(21, 40)}},
                 {"mover", 1, {}, {random.between(1, 20)}}};
    add(0, DescriptionRef{0, 1}, random_tetrahedron({-3, 0, 0}, 2.5, random));
    add(0, DescriptionRef{1, 1}, random_tetrahedron({3, 0, 0}, 2.5, random));
    add(0, DescriptionRef{1, 2}, random_tetrahedron({4, 0, 0}, 1.4, random));
    add(0, DescriptionRef{1, 2}, random_tetrahedron({2, 0, 0}, 0.9, random));
    if (random.below(2)) add(0, {}, random_tetrahedron({0, 4, 0}, 2, random));
    add(1, DescriptionRef{2, 0}, random_tetrahedron({}, 3, random));
    add(1, DescriptionRef{2, 1}, random_tetrahedron({1, 0, 0}, 1.5, random));
    add(1, DescriptionRef{2, 1}, random_tetrahedron({-1, 0, 0}, 1.5, random));
    if (random.below(2)) add(1, {}, random_tetrahedron({0, 0, 2}, 1, random));
    const Database database = prepare(e);
    count(world, database, met);
    World placed = world;
    const Placing place(frame_calculator::placement_at(database.systems[1], 0));
    for (Object& object : placed.environment.objects)
      if (object.model == 1)
        for (Vec3& v : object.vertices) v = place(v);
    for (int v = 0; v < 6; ++v) {
      const Viewpoint viewpoint = plain_viewpoint(placed.environment, random);
      const Raster raster = random_raster(random, 24);
      const World shown = only_shown(
          placed, shown_descriptions(e, database,
                                     frame_calculator::view_transform(viewpoint, raster), met));
      check_machine(polygons_of(shown), database, viewpoint, raster, 0, Strictness::kEveryElement,
                    "seed " + std::to_string(seed) + " view " + std::to_string(v), tally);
    }
  }
  EXPECT_GT(met.empty, 0u);
  for (int d = 0; d < 3; ++d) EXPECT_GT(met.shown[d], 20u);
}

TEST(DetailMost, ForcedInPreparationIsTheSceneWithoutLevels) {
  for (std::uint64_t seed = 1; seed <= cases(10); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    World world = body_soup(random, 4);
    add_choices(world, random, 3);
    Environment plain = world.environment;
    for (Object& object : plain.objects) {
      if (!is_most_detailed(plain, object)) {
        object.vertices.clear();
        object.faces.clear();
      }
    }
    for (Object& object : plain.objects) object.within.reset();
    plain.choices.clear();
    PrepareOptions most;
    most.most_detailed = true;
    Database forced = prepare(world.environment, most), without = prepare(plain);
    forced.report.seconds = without.report.seconds = 0;
    EXPECT_EQ(database_to_json(forced), database_to_json(without));
  }
}

TEST(DetailMost, ForcedInRetrievalShowsTheSameInExactNumbers) {
  for (std::uint64_t seed = 20; seed < 20 + cases(10); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    World world = cells_with_choices(random);
    const Database levels = prepare(world.environment);
    const Database plain = prepare(most_detailed(world.environment));
    MachineOptions options;
    options.number = NumberType::kExact;
    options.raster = {24, 24};
    FunctionalMachine without(plain, options);
    options.detail = 0;
    FunctionalMachine most(levels, options);
    for (int v = 0; v < 6; ++v) {
      const Viewpoint viewpoint = plain_viewpoint(world.environment, random);
      EXPECT_EQ(most.compute(viewpoint, 0).numbers, without.compute(viewpoint, 0).numbers);
      EXPECT_EQ(most.stats().faces, without.stats().faces);
    }
  }
}

TEST(DetailPreparation, AChoiceWithoutItsMostDetailedFacesIsLeftOut) {
  World world;
  world.environment.choices = {{"c", 0, {}, {5}}};
  Object coarse = box_between({0, 0, 0}, {1, 1, 1}),
         fine = polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  coarse.within = DescriptionRef{0, 0};
  fine.within = DescriptionRef{0, 1};
  world.add(coarse);
  world.add(fine);
  const Database database = prepare(world.environment);
  EXPECT_TRUE(database.systems[0].set.items.empty());
  const auto left_out = [](const Notice& n) { return n.what.starts_with("choice left out"); };
  EXPECT_EQ(std::count_if(database.report.notices.begin(), database.report.notices.end(), left_out),
            1);
}

}  // namespace
}  // namespace cigsim::test
