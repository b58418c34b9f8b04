// SPDX-License-Identifier: MIT
// Pictures whose geometry was computed in machine words, beside those in double. All other stages
// are the same, so that a difference is the geometry processor's.
#include <gtest/gtest.h>

#include "models/database/prepare.hpp"
#include "models/edge_orderer/functional.hpp"
#include "models/environment/read.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/geometry_processor/functional.hpp"
#include "models/geometry_processor/functional_words.hpp"
#include "models/machine/scale.hpp"
#include "models/priority_processor/functional.hpp"
#include "models/priority_resolver/functional.hpp"
#include "models/video_processor/functional.hpp"
#include "tests/support/picture_check.hpp"
#include "tests/support/viewpoints.hpp"
#include "tests/support/worlds.hpp"

namespace cigsim::test {
namespace {

template <class N>
void show(const EdgeList<N>& edges, const Raster& raster, Picture& picture) {
  edge_orderer::OrderedCrossings crossings;
  edge_orderer::Functional<N>().compute(edges, raster, crossings);
  priority_resolver::SpanLines spans;
  priority_resolver::Functional().compute(crossings, edges.faces.size(), raster, spans);
  picture.fit(raster);
  video_processor::Functional().compute(spans, edges.faces, {}, raster, picture);
}

struct Pair {
  ViewTransform view;
  Picture in_double, in_words;
  geometry_processor::Figures figures;
  std::uint64_t view_overflows = 0;
};

Pair pictures(const Database& database, const Viewpoint& viewpoint,
              const MachineDescription& machine, double frame) {
  Pair pair;
  const Raster& raster = machine.raster;
  ActiveEnvironment active;
  FaceSet moving;
  frame_calculator::Functional(database).compute(viewpoint, raster, frame, active, moving);
  pair.view = active.view;
  PriorityList list;
  priority_processor::Functional<double>(priority_processor::Method::kCounters)
      .compute(database.systems[0].hierarchy, database.systems[0].set, active, database.ground,
               list);
  EdgeList<double> edges;
  geometry_processor::Functional<double>().compute(
      active.view, {&database.systems[0].set, &moving, &database.ground}, list.items, edges);
  show(edges, raster, pair.in_double);

  using geometry_processor::FaceMemory;
  const int scale = coordinate_scale(database, machine.formats);
  const FaceMemory memories[3] = {FaceMemory(database.systems[0].set, scale, machine),
                                  FaceMemory(moving, scale, machine),
                                  FaceMemory(database.ground, scale, machine)};
  const geometry_processor::GeometryBank bank{
      view_words(active.view, scale, machine.formats, pair.view_overflows),
      {&memories[0], &memories[1], &memories[2]}};
  std::vector<ItemWord> items;
  for (const ItemRef& item : list.items) items.push_back({item.set, item.item, false});
  EdgeList<MachineWord> words;
  geometry_processor::FunctionalWords(machine).compute(bank, items, words, pair.figures);
  show(words, raster, pair.in_words);
  return pair;
}

TEST(GeometryWords, PicturesDifferFromThoseInDoubleNearEdgesOnly) {
  std::uint64_t elements = 0, different = 0;
  int views = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const World world = seed % 4 == 0   ? disjoint_world(random, 8)
                        : seed % 4 == 1 ? touching_world(random)
                        : seed % 4 == 2 ? grid_boxes(random, 6)
                                        : body_soup(random, 5);
    const std::vector<OraclePolygon> polygons = polygons_of(world);
    const Database database = prepare(world.environment);
    for (int v = 0; v < 4; ++v) {
      MachineDescription machine;
      machine.hither = 16;
      machine.raster = random_raster(random, 100);
      const Pair pair = pictures(database, plain_viewpoint(world.environment, random), machine, 0);
      if (pair.view_overflows != 0) continue;  // so far out that the eyepoint is not where it was
      ++views;
      int far = 0;
      for (int r = 0; r < machine.raster.height; ++r)
        for (int c = 0; c < machine.raster.width; ++c) {
          const std::size_t i = static_cast<std::size_t>(r * machine.raster.width + c);
          const std::uint16_t a = pair.in_double.numbers[i], b = pair.in_words.numbers[i];
          ++elements;
          if (a == b) continue;
          ++different;
          far += !near_an_edge(polygons, pair.view, c, r, a, b);
        }
      EXPECT_EQ(far, 0) << "view " << v << ", overflows " << pair.figures.overflows;
    }
  }
  EXPECT_GT(views, 150);
  EXPECT_LT(different * 10000, elements);
}

TEST(GeometryWords, TheAirfieldIsTheSameButForFewElements) {
  const Database database =
      prepare(read_environment(CIGSIM_SOURCE_DIR "/scenes/airfield.json").environment);
  MachineDescription machine;
  machine.raster = {1024, 1023};
  std::uint64_t different = 0;
  constexpr int kViews = 8;
  for (int f = 0; f < kViews; ++f) {
    Viewpoint v{database.view.eye, database.view.fov};
    v.eye.position.y += 90.0 * f;
    v.eye.position.z -= 3.0 * f;
    v.eye.heading += 40.0 * (f / 4);
    const Pair pair = pictures(database, v, machine, f);
    EXPECT_EQ(pair.figures.overflows, 0u);
    std::uint64_t here = 0;
    for (std::size_t i = 0; i < pair.in_double.numbers.size(); ++i)
      here += pair.in_double.numbers[i] != pair.in_words.numbers[i];
    different += here;
  }
  EXPECT_LT(different, 10u * kViews);
}

}  // namespace
}  // namespace cigsim::test
