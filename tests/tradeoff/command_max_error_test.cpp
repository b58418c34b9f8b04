// SPDX-License-Identifier: MIT
// cigsim run --max-error as a process of its own.
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

class MaxErrorTest : public CommandTest {
 protected:
  void SetUp() override { ::setenv("CIGSIM_BUDGET_CACHE", (folder_ / "cache").c_str(), 1); }

  // `cigsim run --max-error budget` on the approach, small.
  Outcome approach(const std::string& budget, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"run",      "--path", "builtin",     "--frames", "6",
                                       "--raster", "64x48",  "--max-error", budget};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return cigsim(arguments);
  }
  Json budget() const { return Json::parse(contents("out/stats.json"))["budget"]; }

  // A machine of words too narrow, and a path that looks at the sky in every frame that is sampled
  // of ten (0, 2, 5, 7, 9) and at the airfield in all others.
  void put_planted_case() {
    Json machine = Json::parse(cigsim({"machines", "unlimited", "--json"}).out);
    machine["figures"]["formats"]["coordinate_bits"]["value"] = 16;
    machine["figures"]["formats"]["quotient_fraction"]["value"] = 8;
    machine["figures"]["formats"]["raster_fraction"]["value"] = 4;
    put("narrow.json", machine.dump(1));
    std::string path = "x,y,z,heading,pitch,roll\n";
    for (const bool sky : {true, false, true, false, false, true, false, true, false, true})
      path += sky ? "0,-900,60,0,90,0\n" : "0,-900,60,0,-3,0\n";
    put("path.csv", path);
  }
};

TEST_F(MaxErrorTest, TakesTheFastestThatKeepsTheBudgetAndSaysWhy) {
  const Outcome outcome = approach("elements=5%");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Budget    "), std::string::npos);
  EXPECT_NE(outcome.out.find("the fastest of the"), std::string::npos);
  EXPECT_NE(outcome.out.find("kept on 3 frames held back"), std::string::npos);
  const Json b = budget();
  EXPECT_EQ(b["kept"], true);
  EXPECT_EQ(b["sampled"], Json({0, 3, 5}));
  EXPECT_EQ(b["held_back"].size(), 3u);
  double chosen_ms = -1;
  for (const Json& one : b["candidates"])
    if (one["name"] == b["chosen"]) chosen_ms = one["frame_ms"]["median"];
  for (const Json& one : b["candidates"])
    EXPECT_TRUE(one["keeps"] == false || one["frame_ms"]["median"] >= chosen_ms) << one["name"];
}

TEST_F(MaxErrorTest, EvidenceIsMeasuredOnce) {
  ASSERT_EQ(approach("elements=5%").exit_code, 0);
  const Json first = budget();
  EXPECT_EQ(first["host"]["from_earlier_run"], false);
  EXPECT_TRUE(std::filesystem::exists(first["host"]["evidence"].get<std::string>()));
  ASSERT_EQ(approach("elements=5%").exit_code, 0);
  const Json again = budget();
  EXPECT_EQ(again["host"]["from_earlier_run"], true);
  EXPECT_EQ(again["candidates"], first["candidates"]);
  EXPECT_EQ(again["chosen"], first["chosen"]);
  // Another raster is another measurement.
  ASSERT_EQ(approach("elements=5%", {"--raster", "48x48"}).exit_code, 2);  // given twice
  ASSERT_EQ(cigsim({"run", "--path", "builtin", "--frames", "6", "--raster", "48x48", "--max-error",
                    "elements=5%"})
                .exit_code,
            0);
  EXPECT_EQ(budget()["host"]["from_earlier_run"], false);
}

TEST_F(MaxErrorTest, NothingAllowedIsCertifiedAndTheSameAsExact) {
  ASSERT_EQ(approach("0").exit_code, 0);
  const Json stats = Json::parse(contents("out/stats.json"));
  EXPECT_EQ(stats["options"]["number"], "certified");
  for (const Json& frame : stats["frames"]) EXPECT_EQ(frame["certified"], true);
  ASSERT_EQ(cigsim({"run", "--path", "builtin", "--frames", "6", "--raster", "64x48", "--number",
                    "exact", "--detail", "most", "--out", "exact"})
                .exit_code,
            0);
  for (int frame = 0; frame < 6; ++frame) {
    const std::string name = "frame-000" + std::to_string(frame) + ".png";
    EXPECT_EQ(contents("out/" + name), contents("exact/" + name)) << name;
  }
}

TEST_F(MaxErrorTest, NoneIsTheFastestWithoutACheck) {
  const Outcome outcome = approach("none");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json b = budget();
  EXPECT_TRUE(b["held_back"].empty());
  for (const Json& one : b["candidates"]) EXPECT_EQ(one["keeps"], true);
}

TEST_F(MaxErrorTest, ARunOfOneFrameHoldsNoneBack) {
  const Outcome outcome = cigsim({"run", "--raster", "48x32", "--max-error", "elements=5%"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("no frame was held back"), std::string::npos);
  EXPECT_EQ(budget()["kept"], true);
}

// The planted bad case: frames that are easy where they are sampled, and not where held back.
TEST_F(MaxErrorTest, ABrokenBudgetIsReportedWithExitCodeOne) {
  put_planted_case();
  const Outcome outcome = cigsim({"run", "--path", "path.csv", "--raster", "96x64", "--machine",
                                  "narrow.json", "--max-error", "elements=0"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("BROKEN on 5 of 5 frames held back"), std::string::npos)
      << outcome.out;
  const Json b = budget();
  EXPECT_EQ(b["kept"], false);
  for (const Json& frame : b["held_back"]) {
    EXPECT_EQ(frame["kept"], false);
    EXPECT_GT(frame["elements"], 0);
  }
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/frame-0009.png"));
}

TEST_F(MaxErrorTest, WhereNothingKeepsTheBudgetTheNearestAreNamed) {
  put_planted_case();
  expect_unusable({"run", "--eye", "0,-900,60", "--attitude", "0,-3,0", "--raster", "96x64",
                   "--machine", "narrow.json", "--max-error", "elements=0"},
                  "no setting keeps elements=0 on this scene; nearest: machine");
}

TEST_F(MaxErrorTest, EvidenceThatCannotBeKeptServesTheRun) {
  put("cache", "a file where a folder should be");
  const Outcome outcome = approach("elements=5%");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("it could not be kept"), std::string::npos);
  EXPECT_NE(outcome.err.find("evidence is not kept"), std::string::npos);
}

TEST_F(MaxErrorTest, ContradictionsAreRefused) {
  for (const auto& [knob, value] :
       std::vector<std::pair<std::string, std::string>>{{"--number", "double"},
                                                        {"--level", "timed"},
                                                        {"--detail", "2"},
                                                        {"--resolver", "painter"},
                                                        {"--priority", "so"},
                                                        {"--retrieval", "off"},
                                                        {"--timeline", "x.svg"}})
    expect_unusable({"run", "--max-error", "none", knob, value}, knob + " excludes --max-error");
  expect_unusable({"run", "--max-error", "0", "--machine", "asupt1975"}, "leave out --machine");
  expect_unusable({"run", "--max-error", "elements=2"}, "must be a share");
  expect_unusable({"run", "--max-error", "speed=1%"}, "'speed'");
}

}  // namespace
}  // namespace cigsim
