// SPDX-License-Identifier: MIT
// Levels of detail at every level of fidelity: the same choices, pictures and figures, and between
// the timed and the clocked machine the same cycles.
#include <gtest/gtest.h>

#include <memory>

#include "models/database/prepare.hpp"
#include "models/environment/random.hpp"
#include "models/environment/read.hpp"
#include "sim/functional_machine.hpp"
#include "sim/systemc_machine.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/fresh_simulation.hpp"

namespace cigsim::test {
namespace {

// Choices among static bodies, one within another, one that may show nothing, and a moving model
// with a choice that passes through their places.
Environment environment(Random& random) {
  Environment e;
  e.systems.push_back({"moving", {}, {{0, {{-6, 0, 0}, 0, 0, 0}}, {8, {{6, 0, 0}, 90, 0, 20}}}});
  e.models = {{"static", 0}, {"mover", 1}};
  e.choices = {{"left", 0, {}, {4, 9}},
               {"inner", 0, DescriptionRef{0, 2}, {6}},
               {"right", 0, {}, {7}},
               {"mover", 1, {}, {3}}};
  const auto add = [&](std::uint32_t model, std::optional<DescriptionRef> within, Object object) {
    object.name = std::to_string(e.objects.size() + 1);
    object.model = model;
    object.within = within;
    e.objects.push_back(std::move(object));
  };
  add(0, DescriptionRef{0, 0}, box_between({-5, -2, -2}, {-1, 2, 2}));
  add(0, DescriptionRef{0, 1}, random_hull({-3, 0, 0}, 2, random));
  add(0, DescriptionRef{0, 2}, random_tetrahedron({-4, 0, 0}, 0.9, random));
  add(0, DescriptionRef{1, 0}, random_tetrahedron({-2, 0, 0}, 0.9, random));
  add(0, DescriptionRef{1, 1}, box_between({-2.5, -0.5, -0.5}, {-2, 0.5, 0.5}));
  add(0, DescriptionRef{1, 1}, box_between({-2, -0.5, -0.5}, {-1.5, 0.5, 0.5}));
  add(0, DescriptionRef{2, 1}, random_body({3, 0, 0}, 1.9, random));
  add(0, {}, random_body({0, 5, 0}, 2, random));
  add(1, DescriptionRef{3, 0}, random_tetrahedron({}, 1.5, random));
  add(1, DescriptionRef{3, 1}, random_tetrahedron({0.6, 0, 0}, 0.5, random));
  add(1, DescriptionRef{3, 1}, random_tetrahedron({-0.6, 0, 0}, 0.5, random));
  e.ground = {{{{-9, -9, -3}, {9, -9, -3}, {9, 9, -3}, {-9, 9, -3}}, {60, 90, 60}}};
  return e;
}

std::vector<FrameJob> approach(const Database& database, Random& random) {
  std::vector<FrameJob> jobs;
  for (int k = 0; k < 8; ++k) {
    const Vec3 eye{random.between(-3, 3), -40 + 4.5 * k, random.between(-1, 4)};
    jobs.push_back({&database, {look_at(eye, {0, 0, 0}), 50}, static_cast<double>(k)});
  }
  return jobs;
}

struct Result {
  std::vector<std::vector<std::uint32_t>> colours;
  std::vector<FrameStats> stats;
};

class DetailLevels : public testing::Test {
 protected:
  DetailLevels() { fresh_simulation(); }
};

TEST_F(DetailLevels, AgreeOnChoicesPicturesAndCycles) {
  constexpr std::uint64_t kSeed = 20261102;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  const Database database = prepare(environment(random));
  ASSERT_EQ(database.systems[0].hierarchy.choices.size(), 3u);
  ASSERT_EQ(database.systems[1].hierarchy.choices.size(), 1u);
  const std::vector<FrameJob> jobs = approach(database, random);
  PipelineOptions pipeline;
  pipeline.description = with_raster(machine_preset("unlimited"), {40, 32});
  const auto feed = [&](SystemcMachine& machine, Result& result) {
    machine.feed(
        [&jobs, next = std::size_t{0}]() mutable -> std::optional<FrameJob> {
          if (next == jobs.size()) return {};
          return jobs[next++];
        },
        [&result](const Picture& picture, const FrameStats& stats) {
          result.colours.push_back(picture.colours);
          result.stats.push_back(stats);
        });
  };
  for (const Stage stage : kAllStages) pipeline.levels[stage] = Level::kTimed;
  Result of_timed, of_clocked;
  SystemcMachine timed("timed", pipeline);
  for (std::size_t i = 1; i < kStageCount; ++i) pipeline.levels[kAllStages[i]] = Level::kClocked;
  SystemcMachine clocked("clocked", pipeline);
  feed(timed, of_timed);
  feed(clocked, of_clocked);
  SystemcMachine::simulate({&timed, &clocked});

  MachineOptions options;
  options.raster = pipeline.description.raster;
  options.description = pipeline.description;
  std::vector<FunctionalMachine> functional;
  for (const NumberType number :
       {NumberType::kMachine, NumberType::kDouble, NumberType::kFloat, NumberType::kExact}) {
    options.number = number;
    options.resolver =
        number == NumberType::kMachine ? ResolverMethod::kActiveList : ResolverMethod::kAuto;
    functional.emplace_back(database, options);
  }
  ASSERT_EQ(of_timed.stats.size(), jobs.size());
  ASSERT_EQ(of_clocked.stats.size(), jobs.size());
  std::vector<std::uint32_t> shown(3, 0);
  for (std::size_t f = 0; f < jobs.size(); ++f) {
    SCOPED_TRACE("frame " + std::to_string(f));
    EXPECT_EQ(functional[0].compute(jobs[f].viewpoint, jobs[f].position).colours,
              of_timed.colours[f]);
    EXPECT_EQ(of_timed.colours[f], of_clocked.colours[f]);
    EXPECT_EQ(of_timed.stats[f].timing->last_element, of_clocked.stats[f].timing->last_element);
    for (std::size_t s = 0; s < kStageCount; ++s) {
      const Activity &a = of_timed.stats[f].timing->activity[s],
                     &b = of_clocked.stats[f].timing->activity[s];
      EXPECT_EQ(a.start, b.start);
      EXPECT_EQ(a.finish, b.finish);
    }
    for (FunctionalMachine& machine : functional) {
      machine.compute(jobs[f].viewpoint, jobs[f].position);
      EXPECT_EQ(machine.stats().detail, of_timed.stats[f].detail);
      EXPECT_EQ(machine.stats().faults, 0u);
    }
    EXPECT_EQ(of_clocked.stats[f].detail, of_timed.stats[f].detail);
    for (std::size_t d = 0; d < of_timed.stats[f].detail.size(); ++d)
      shown[d] += of_timed.stats[f].detail[d];
  }
  for (const std::uint32_t n : shown) EXPECT_GT(n, 0u);
}

}  // namespace
}  // namespace cigsim::test
