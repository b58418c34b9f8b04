// SPDX-License-Identifier: MIT
#include "sim/view.hpp"

#include <gtest/gtest.h>

#include "sim/arguments.hpp"

namespace cigsim {
namespace {

// One item around (10, 20, 5), seen by default from (1, 2, 3).
Database database_with_an_item() {
  Database database;
  database.systems.resize(1);
  database.systems[0].set.items.push_back({0, 0, 0, 0, {{10, 20, 5}, 2}});
  database.view = {{{1, 2, 3}, 4, 5, 6}, 70};
  return database;
}

FrameView only_view(const ViewOptions& options) {
  const std::vector<FrameView> views = frame_views(options, {}, database_with_an_item());
  EXPECT_EQ(views.size(), 1u);
  return views.front();
}

TEST(View, WithoutOptionsItIsTheScenesOwn) {
  const FrameView view = only_view({});
  EXPECT_EQ(view.viewpoint.eye, (Placement{{1, 2, 3}, 4, 5, 6}));
  EXPECT_EQ(view.viewpoint.fov, 70);
}

TEST(View, AnEyeAloneLooksAtTheCentreOfTheScene) {
  ViewOptions options;
  options.eye = Vec3{10, -30, 5};
  EXPECT_EQ(only_view(options).viewpoint.eye, (Placement{{10, -30, 5}, 0, 0, 0}));
  options.eye = Vec3{10, 20, 5};
  EXPECT_EQ(only_view(options).viewpoint.eye, (Placement{{10, 20, 5}, 0, 0, 0})) << "north";
}

TEST(View, AttitudeTurnsTheEyeThatIsGivenOrTheScenesOwn) {
  ViewOptions options;
  options.attitude = Attitude{90, -10, 2};
  options.fov = 20;
  EXPECT_EQ(only_view(options).viewpoint.eye, (Placement{{1, 2, 3}, 90, -10, 2}));
  EXPECT_EQ(only_view(options).viewpoint.fov, 20);
  options.eye = Vec3{7, 8, 9};
  EXPECT_EQ(only_view(options).viewpoint.eye, (Placement{{7, 8, 9}, 90, -10, 2}));
}

TEST(View, LookingAtTheEyeItselfIsWrongUsage) {
  ViewOptions options;
  options.eye = options.look_at = Vec3{1, 1, 1};
  EXPECT_THROW(frame_views(options, {}, database_with_an_item()), UsageError);
  options.look_at = Vec3{2, 1, 1};
  EXPECT_NEAR(only_view(options).viewpoint.eye.heading, 90, 1e-12);
}

TEST(View, FramesWithoutAPathMoveOnlyTheModels) {
  ViewOptions options;
  options.frames = 3;
  const auto views = frame_views(options, {}, database_with_an_item());
  ASSERT_EQ(views.size(), 3u);
  EXPECT_EQ(views[2].position, 2);
  EXPECT_EQ(views[2].viewpoint.eye, views[0].viewpoint.eye);
}

TEST(View, APathGivesEyeAttitudeAndFieldOfView) {
  const std::vector<PathRow> path{{{{0, 0, 0}, 0, 0, 0}, 40}, {{{2, 0, 0}, 10, 0, 0}, 60}};
  ViewOptions options;
  EXPECT_EQ(frame_views(options, path, database_with_an_item()).size(), 2u);
  options.frames = 3;
  const auto views = frame_views(options, path, database_with_an_item());
  ASSERT_EQ(views.size(), 3u);
  EXPECT_EQ(views[1].position, 0.5);
  EXPECT_EQ(views[1].viewpoint.eye, (Placement{{1, 0, 0}, 5, 0, 0}));
  EXPECT_EQ(views[1].viewpoint.fov, 50);
  options.fov = 33;
  EXPECT_EQ(frame_views(options, path, database_with_an_item())[1].viewpoint.fov, 33);
}

TEST(View, APathWithoutFieldOfViewTakesTheScenes) {
  const std::vector<PathRow> path{{{{0, 0, 0}, 0, 0, 0}, {}}};
  EXPECT_EQ(frame_views({}, path, database_with_an_item())[0].viewpoint.fov, 70);
}

TEST(View, ASceneWithoutAnythingStillHasACentre) {
  Database database;
  database.systems.resize(1);
  ViewOptions options;
  options.eye = Vec3{0, -1, 0};
  EXPECT_EQ(frame_views(options, {}, database)[0].viewpoint.eye.heading, 0);
}

}  // namespace
}  // namespace cigsim
