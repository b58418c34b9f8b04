// SPDX-License-Identifier: MIT
// Evidence is found again by all that it depends on, and only then.
#include "sim/budget/cache.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "models/database/prepare.hpp"
#include "models/environment/input_error.hpp"
#include "models/environment/random.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/worlds.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

class BudgetCache : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("CIGSIM_BUDGET_CACHE", scratch_.folder().c_str(), 1);
    Random random(1);
    database_ = prepare(test::disjoint_world(random, 5).environment, {});
    evidence_[0].name = "float";
    evidence_[0].worst.cycles = 0.25;
    settings_[0].name = "float";
  }
  Json key() const { return evidence_key(database_, views_, settings_, Level::kRtl); }

  test::Scratch scratch_;
  Database database_;
  std::vector<FrameView> views_ = std::vector<FrameView>(2);
  std::vector<Setting> settings_ = std::vector<Setting>(1);
  std::vector<Evidence> evidence_ = std::vector<Evidence>(1);
};

TEST_F(BudgetCache, GivesBackWhatWasKept) {
  const auto file = evidence_file(key());
  EXPECT_EQ(file.parent_path(), scratch_.folder());
  EXPECT_FALSE(read_evidence(file, key()));
  write_evidence(file, key(), evidence_);
  EXPECT_EQ(read_evidence(file, key()), evidence_);
}

TEST_F(BudgetCache, TheSamePreparationHasTheSameKey) {
  const Json before = key();
  Random random(1);
  database_ = prepare(test::disjoint_world(random, 5).environment, {});
  database_.report.seconds = 1e9;
  EXPECT_EQ(key(), before);
}

TEST_F(BudgetCache, EveryPartOfTheKeyCounts) {
  const Json before = key();
  std::vector<Json> keys{before};
  const auto differs = [&] {
    keys.push_back(key());
    for (std::size_t i = 0; i + 1 < keys.size(); ++i)
      EXPECT_NE(evidence_file(keys[i]), evidence_file(keys.back())) << i;
  };
  database_.systems[0].set.vertices[0].x += 1e-9;
  differs();
  views_[1].viewpoint.eye.heading = 1e-12;
  differs();
  settings_[0].machine.raster.width = 640;
  differs();
  settings_[0].machine.detail = 2;
  differs();
  settings_[0].machine.number = NumberType::kMachine;
  settings_[0].machine.description = machine_preset("unlimited");
  differs();
  settings_[0].machine.description.hither += 1;
  differs();
  keys.push_back(evidence_key(database_, views_, settings_, Level::kClocked));
  EXPECT_NE(evidence_file(keys.back()), evidence_file(key()));
}

TEST_F(BudgetCache, WhatIsNotWholeIsNothing) {
  const Json known = key();
  const auto file = evidence_file(known);
  write_evidence(file, known, evidence_);
  const std::string whole = test::bytes_of(file);
  Random random(2);
  for (int cut = 0; cut < 200; ++cut) {
    std::ofstream(file, std::ios::binary) << whole.substr(0, random.below(whole.size() - 1));
    EXPECT_FALSE(read_evidence(file, known));
  }
  for (const char* other : {"[]", "7", "{\"key\": 1}", "\xff\xfe"}) {
    std::ofstream(file, std::ios::binary) << other;
    EXPECT_FALSE(read_evidence(file, known));
  }
  Json wrong = Json::parse(whole);
  wrong["evidence"][0]["elements"] = "many";
  std::ofstream(file) << wrong;
  EXPECT_FALSE(read_evidence(file, known));
  wrong = Json::parse(whole);
  wrong["evidence"][0]["elements"] = 0.125;  // a figure that nobody measured
  std::ofstream(file) << wrong;
  EXPECT_FALSE(read_evidence(file, known));
  wrong["evidence"] = Json::array();
  std::ofstream(file) << wrong;
  EXPECT_FALSE(read_evidence(file, known));
}

TEST_F(BudgetCache, AFolderThatCannotBeMadeIsAnInputError) {
  scratch_.write("file", "x");
  ::setenv("CIGSIM_BUDGET_CACHE", (scratch_.path("file") / "below").c_str(), 1);
  EXPECT_NE(test::message_of([&] { write_evidence(evidence_file(key()), key(), evidence_); }),
            "nothing");
}

}  // namespace
}  // namespace cigsim
