// SPDX-License-Identifier: MIT
// The scenes that ship: each is read without complaint and holds what scenes/README.md says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include "models/environment/read.hpp"

namespace cigsim {
namespace {

struct Shipped {
  const char* file;
  std::size_t objects, faces, edges, ground_faces;
};

const Shipped kShipped[] = {
    {"stump-reassigned.json", 4, 24, 48, 0},   {"levine-towers.json", 336, 2592, 5760, 1},
    {"airfield.json", 158, 1011, 1957, 116},   {"levine-cubes-4.json", 4, 24, 48, 0},
    {"levine-cubes-8.json", 8, 48, 96, 0},     {"levine-cubes-16.json", 16, 96, 192, 0},
    {"levine-cubes-24.json", 24, 144, 288, 0}, {"levine-cubes-32.json", 32, 192, 384, 0},
    {"levine-cubes-48.json", 48, 288, 576, 0}, {"levine-city.json", 16, 96, 192, 0},
    {"fuchs-overlap.json", 3, 3, 12, 0},       {"stump-case-1.deck", 2, 12, 24, 0},
    {"stump-case-2.deck", 4, 24, 48, 0},       {"stump-case-3.deck", 5, 30, 60, 0},
    {"stump-not-listable.json", 4, 24, 48, 0}, {"fuchs-house.json", 2, 11, 21, 0},
    {"fuchs-blocks.json", 12, 72, 144, 0},
};

std::filesystem::path scenes() { return std::filesystem::path(CIGSIM_SOURCE_DIR) / "scenes"; }

std::size_t edges_of(const Object& object) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Face& face : object.faces)
    for (std::size_t i = 0; i < face.vertices.size(); ++i)
      edges.insert(std::minmax(face.vertices[i], face.vertices[(i + 1) % face.vertices.size()]));
  return edges.size();
}

class ShippedScene : public testing::TestWithParam<Shipped> {};

TEST_P(ShippedScene, IsReadWithoutNoticesAndHoldsWhatItsTableSays) {
  const ReadResult result = read_environment(scenes() / GetParam().file);
  EXPECT_TRUE(result.notices.empty());
  std::size_t faces = 0, edges = 0;
  for (const Object& object : result.environment.objects) {
    faces += object.faces.size();
    edges += edges_of(object);
  }
  EXPECT_EQ(result.environment.objects.size(), GetParam().objects);
  EXPECT_EQ(faces, GetParam().faces);
  EXPECT_EQ(edges, GetParam().edges);
  EXPECT_EQ(result.environment.ground.size(), GetParam().ground_faces);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScene, testing::ValuesIn(kShipped), [](const auto& info) {
  std::string name = info.param.file;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
});

TEST(ShippedScenes, EverySceneFileIsInTheTable) {
  std::set<std::string> listed, found;
  for (const Shipped& scene : kShipped) listed.insert(scene.file);
  for (const auto& entry : std::filesystem::directory_iterator(scenes()))
    if (entry.path().extension() == ".json" || entry.path().extension() == ".deck")
      found.insert(entry.path().filename().string());
  EXPECT_EQ(found, listed);
}

TEST(Airfield, HasAViewASunAndTwoMovingSystems) {
  const Environment airfield = read_environment(scenes() / "airfield.json").environment;
  EXPECT_TRUE(airfield.view && airfield.sun);
  ASSERT_EQ(airfield.systems.size(), 3u);
  EXPECT_FALSE(airfield.systems[1].motion.empty());
  EXPECT_FALSE(airfield.systems[2].motion.empty());
}

}  // namespace
}  // namespace cigsim
