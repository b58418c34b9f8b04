// SPDX-License-Identifier: MIT
#include "sim/scene.hpp"

#include <gtest/gtest.h>

#include "sim/arguments.hpp"

namespace cigsim {
namespace {

ReadResult part(const std::string& name, bool moving) {
  ReadResult result;
  Environment& e = result.environment;
  e.name = name;
  if (moving) e.systems.push_back({name + " system", {}, {{0, {}}, {1, {}}}});
  e.models = {{name + " fixed", 0}, {name + " own", moving ? 1u : 0u}};
  e.objects = {{name + " a", 0, {}, {}}, {name + " b", 1, {}, {}}};
  e.ground = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {1, 2, 3}}};
  result.notices = {{"dropped", 2}, {name, 1}};
  return result;
}

TEST(Scene, ASeparationTableIsNotMerged) {
  std::vector<ReadResult> parts{part("one", false), part("two", false)};
  parts[1].environment.separation = {{{1, 0, 0}, 0, {{1, 2}}}};
  EXPECT_THROW(merge(parts), UsageError);
  parts.erase(parts.begin());
  EXPECT_EQ(merge(parts).environment.separation.size(), 1u);
}

TEST(Scene, MergingKeepsOrderAndReferences) {
  std::vector<ReadResult> parts{part("one", true), part("two", false), part("three", true)};
  parts[1].environment.view = DefaultView{{{1, 2, 3}, 0, 0, 0}, 30};
  parts[2].environment.view = DefaultView{};
  parts[2].environment.sun = Sun{10, 20};
  parts[2].environment.background = {9, 9, 9};
  const ReadResult whole = merge(parts);
  const Environment& e = whole.environment;
  EXPECT_EQ(e.name, "one");
  ASSERT_EQ(e.systems.size(), 3u);
  EXPECT_EQ(e.systems[2].name, "three system");
  ASSERT_EQ(e.objects.size(), 6u);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      const Object& object = e.objects[2 * i + k];
      const std::string& name = parts[i].environment.name;
      EXPECT_EQ(object.name, name + (k == 0 ? " a" : " b"));
      const Model& model = e.models[object.model];
      EXPECT_EQ(model.name, name + (k == 0 ? " fixed" : " own"));
      const std::string system = k == 1 && i != 1 ? name + " system" : "environment";
      EXPECT_EQ(e.systems[model.system].name, system);
    }
  EXPECT_EQ(e.ground.size(), 3u);
  EXPECT_EQ(e.view->fov, 30);
  EXPECT_EQ(e.sun, (Sun{10, 20}));
  EXPECT_EQ(e.background, Environment{}.background);
  EXPECT_EQ(whole.notices,
            (std::vector<Notice>{{"dropped", 6}, {"one", 1}, {"two", 1}, {"three", 1}}));
}

TEST(Scene, WithoutAFileItIsTheAirfield) {
  const LoadedScene scene = load_scene(std::nullopt, {});
  EXPECT_GT(scene.database.object_count, 100u);
  EXPECT_FALSE(scene.database.ground.faces.empty());
  ASSERT_TRUE(scene.facts);
  EXPECT_TRUE(scene.facts->sun);
  EXPECT_TRUE(scene.database.report.notices.empty());
}

}  // namespace
}  // namespace cigsim
