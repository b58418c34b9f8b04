// SPDX-License-Identifier: MIT
// The separation program improved: what the published one gets wrong, proofs, least numbers of
// planes, further candidates and splits.
#include "models/database/separation_planes/separate.hpp"

#include <gtest/gtest.h>

#include <set>

#include "models/database/separation_planes/fewest.hpp"
#include "models/database/separation_planes/published.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/random.hpp"
#include "tests/database/separation_planes/decks.hpp"

namespace cigsim::separation_planes {
namespace {

using test::case_deck;
using test::deck_of;

// Every pair of bodies once, each body exactly on the side that its pairs say, and proved.
void expect_right(const SeparationResult& result) {
  const std::size_t n = result.bodies.size();
  std::set<std::pair<std::uint32_t, std::uint32_t>> met;
  for (const ResultPlane& plane : result.planes)
    for (const auto& [t, f] : plane.pairs) {
      EXPECT_TRUE(met.insert(std::minmax(t, f)).second);
      EXPECT_EQ(where(plane.plane, result.bodies[t - 1]), Where::kTrue);
      EXPECT_EQ(where(plane.plane, result.bodies[f - 1]), Where::kFalse);
    }
  EXPECT_EQ(met.size(), n * (n - 1) / 2);
  EXPECT_TRUE(result.proof.listable);
}

TEST(Separate, StumpsCasesNeedWhatHePrints) {
  const std::uint32_t planes[] = {1, 2, 4};
  for (int k = 1; k <= 3; ++k) {
    SCOPED_TRACE(k);
    const SeparationResult result = separate(case_deck(k));
    expect_right(result);
    EXPECT_EQ(result.planes.size(), planes[k - 1]);
    EXPECT_EQ(result.published, planes[k - 1]);
    EXPECT_EQ(result.greedy, planes[k - 1]);
    ASSERT_TRUE(result.least);
    EXPECT_TRUE(result.least->all_planes);
    EXPECT_EQ(result.least->any_table, planes[k - 1]) << "no table of any kind has fewer";
    EXPECT_EQ(result.least->division, planes[k - 1]);
  }
}

TEST(Separate, SmallScaleIsExact) {
  const double s = 0.0004;
  const SeparationResult result =
      separate(deck_of({{{0, 0, 0}, {s, s, s}}, {{2 * s, 0, 0}, {3 * s, s, s}}}));
  expect_right(result);
  EXPECT_EQ(result.planes.size(), 1u);
  EXPECT_FALSE(result.published) << "his tolerance finds nothing";
}

TEST(Separate, ObjectsThatReachIntoEachOtherAreNamed) {
  const StumpDeck deck = deck_of(
      {{{50, 0, 0}, {60, 10, 10}}, {{0, 0, 0}, {10, 10, 10}}, {{9.9991, 0, 0}, {20, 10, 10}}});
  try {
    separate(deck);
    ADD_FAILURE();
  } catch (const NotApart& error) {
    EXPECT_STREQ(error.what(), "no plane parts objects 2 and 3: they reach into each other");
  }
  EXPECT_THROW(separate(deck_of({{{0, 0, 0}, {9, 9, 9}}, {{1, 1, 1}, {2, 2, 2}}})), NotApart);
  EXPECT_THROW(separate(deck_of({{{0, 0, 0}, {9, 9, 9}}, {{0, 0, 0}, {9, 9, 9}}})), NotApart);
}

TEST(Separate, CollinearFirstVerticesDoNoHarm) {
  StumpDeck deck = deck_of({{{0, 0, 0}, {10, 10, 10}}, {{20, 0, 0}, {30, 10, 10}}});
  for (Object& object : deck.objects)
    for (Face& face : object.faces) {
      object.vertices.push_back(
          (object.vertices[face.vertices[0]] + object.vertices[face.vertices[1]]) * 0.5);
      face.vertices.insert(face.vertices.begin() + 1,
                           static_cast<std::uint32_t>(object.vertices.size() - 1));
      std::rotate(face.vertices.begin(), face.vertices.begin() + 3, face.vertices.end());
    }
  const SeparationResult result = separate(deck);
  expect_right(result);
  EXPECT_EQ(result.planes.size(), 1u);
  EXPECT_FALSE(result.published) << "he divides by zero";
}

// Faces wound either way: only the names of the sides change.
TEST(Separate, WindingTurnsOnlyTheSides) {
  StumpDeck deck = case_deck(3);
  for (Object& object : deck.objects)
    for (Face& face : object.faces) std::reverse(face.vertices.begin(), face.vertices.end());
  const SeparationResult result = separate(deck);
  expect_right(result);
  EXPECT_EQ(result.planes.size(), 4u);
  const PublishedTable published = PublishedProgram(deck, "turned").run();
  ASSERT_TRUE(published.found);
  EXPECT_EQ(published.planes.size(), 4u);
  EXPECT_EQ(published.planes[0].plane.normal.x, -1) << "his normals point inwards then";
}

// His rule takes a new plane where one that is chosen already would do.
TEST(Separate, PlanesAlreadyChosenComeFirst) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    GenerateOptions options;
    options.objects = 12;
    options.seed = seed;
    StumpDeck deck;
    deck.objects = generate_environment("city", options).objects;
    const SeparationResult result = separate(deck);
    expect_right(result);
    if (result.published) {
      EXPECT_LE(result.planes.size(), *result.published);
    }
  }
}

TEST(Separate, AWedgeRingNeedsNoSplit) {
  const SeparationResult result = separate(test::wedges());
  expect_right(result);
  EXPECT_TRUE(result.splits.empty());
  EXPECT_TRUE(result.pair_by_pair);
  EXPECT_EQ(result.planes.size(), 3u);
  EXPECT_FALSE(result.published) << "he gives up";
}

TEST(Separate, ARingOfBarsIsSplit) {
  const SeparationResult result = separate(test::ring_of_bars());
  expect_right(result);
  ASSERT_EQ(result.splits.size(), 1u);
  EXPECT_EQ(result.bodies.size(), 4u);
  const ResultSplit split = result.splits[0];
  EXPECT_EQ(split.true_part, 4u);
  EXPECT_EQ(result.bodies[3].object, split.object);
  EXPECT_TRUE(result.bodies[3].part);
  EXPECT_FALSE(result.published) << "he gives up";
  EXPECT_FALSE(result.least);
}

// Two tetrahedra that only a plane along an edge of each parts: no face of either does.
TEST(Separate, EdgesPartWhatNoFaceParts) {
  StumpDeck deck;
  const auto tetrahedron = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    Object object;
    object.vertices = {a, b, c, d};
    for (const auto& face :
         std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}})
      object.faces.push_back({face, std::nullopt});
    return object;
  };
  deck.objects.push_back(tetrahedron({-9, 0, 0}, {9, 0, 0}, {1, -9, -8}, {-1, 9, -8}));
  deck.objects.push_back(tetrahedron({0, -9, 1}, {0, 9, 1}, {-9, 1, 9}, {9, -1, 9}));
  const SeparationResult result = separate(deck);
  expect_right(result);
  ASSERT_EQ(result.planes.size(), 1u);
  EXPECT_EQ(result.planes[0].origin.kind, Origin::kEdges);
}

TEST(Separate, NothingToSeparate) {
  const SeparationResult result = separate(deck_of({{{0, 0, 0}, {1, 1, 1}}}));
  EXPECT_TRUE(result.planes.empty());
  EXPECT_TRUE(result.proof.listable);
}

TEST(Separate, AnObjectThatIsNotConvexIsNotSplit) {
  StumpDeck deck = test::ring_of_bars();
  for (Object& object : deck.objects) object.faces.pop_back();
  EXPECT_THROW(separate(deck), NotToBeSplit);
}

// Boxes of a random subdivision, some pushed together in rings: right however they lie.
TEST(Separate, RandomBricksAreAlwaysSeparated) {
  const std::uint64_t seed = 31;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  int split = 0;
  for (int k = 0; k < 60; ++k) {
    std::vector<std::pair<Vec3, Vec3>> boxes;
    for (int tries = 0; tries < 60 && boxes.size() < 9; ++tries) {
      const auto at = [&] { return static_cast<double>(random.below(7)); };
      Vec3 low{at(), at(), at()};
      Vec3 size{1, 1, 1};
      const std::uint32_t axis = random.below(3);
      (axis == 0 ? size.x : axis == 1 ? size.y : size.z) = 5;
      const Vec3 high = low + size;
      const bool free = std::none_of(boxes.begin(), boxes.end(), [&](const auto& b) {
        return low.x < b.second.x && b.first.x < high.x && low.y < b.second.y &&
               b.first.y < high.y && low.z < b.second.z && b.first.z < high.z;
      });
      if (free) boxes.push_back({low, high});
    }
    SeparateOptions options;
    options.most_corner_planes = 0;
    options.most_steps = 2000;
    const SeparationResult result = separate(deck_of(boxes), options);
    SCOPED_TRACE(k);
    expect_right(result);
    split += !result.splits.empty();
  }
  EXPECT_GT(split, 2);
}

// The parts of a cut body: closed, on their sides, and together as large as the whole.
TEST(Body, PartsAreClosedConvexBodies) {
  const std::uint64_t seed = 4;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int k = 0; k < 200; ++k) {
    const Body body = body_of(box({0, 0, 0}, {4, 4, 4}), 1);
    // Often through corners and along edges.
    const auto at = [&] { return static_cast<double>(random.below(5)); };
    const Vec3 a{at(), at(), at()}, b{at(), at(), at()}, c{at(), at(), at()};
    if (collinear(a, b, c)) continue;
    const Plane plane = plane_through(a, b, c);
    if (where(plane, body) != Where::kCut) continue;
    const auto [on_true, on_false] = split(plane, body);
    EXPECT_EQ(where(plane, on_true), Where::kTrue);
    EXPECT_EQ(where(plane, on_false), Where::kFalse);
    for (const Body* part : {&on_true, &on_false}) {
      std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
      for (const auto& face : part->faces) {
        ASSERT_GE(face.size(), 3u);
        for (std::size_t i = 0; i < face.size(); ++i)
          edges.insert({face[i], face[(i + 1) % face.size()]});
      }
      for (const auto& [u, v] : edges) EXPECT_EQ(edges.count({v, u}), 1u) << "closed";
    }
  }
}

TEST(Fewest, PlanesForPockets) {
  const std::uint32_t want[] = {0, 0, 1, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 5};
  for (std::uint64_t n = 0; n < 17; ++n) EXPECT_EQ(planes_for_pockets(n), want[n]) << n;
}

// Whether some k of the planes divide all objects: every choice of k tried.
bool divisible(const std::vector<SidePair>& planes, std::uint64_t set) {
  if ((set & (set - 1)) == 0) return true;
  for (const SidePair& p : planes)
    if ((set & ~(p.on_true | p.on_false)) == 0 && (set & p.on_true) && (set & p.on_false))
      return divisible(planes, set & p.on_true) && divisible(planes, set & p.on_false);
  return false;
}

TEST(Fewest, AgainstEveryChoiceOfPlanes) {
  const std::uint64_t seed = 17;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int k = 0; k < 300; ++k) {
    const std::uint32_t objects = 2 + random.below(5);
    const std::uint64_t all = (std::uint64_t{1} << objects) - 1;
    std::vector<SidePair> planes;
    for (int p = 0; p < 9; ++p) {
      const std::uint64_t t = random.bits() & all, cut = random.bits() & random.bits() & all;
      planes.push_back({t & ~cut, all & ~t & ~cut});
    }
    std::uint32_t want = 10;
    for (std::uint32_t choice = 0; choice < 512; ++choice) {
      std::vector<SidePair> few;
      for (std::uint32_t p = 0; p < 9; ++p)
        if (choice >> p & 1) few.push_back(planes[p]);
      if (few.size() < want && divisible(few, all)) want = static_cast<std::uint32_t>(few.size());
    }
    const std::vector<SidePair> kept = maximal(planes);
    const Fewest found = fewest_planes(objects, kept, 10, 1000000);
    ASSERT_EQ(found.division, want) << "case " << k;
    ASSERT_LE(found.any_table, want);
    if (want < 10) {
      ASSERT_EQ(found.planes.size(), want);
    }
  }
}

}  // namespace
}  // namespace cigsim::separation_planes
