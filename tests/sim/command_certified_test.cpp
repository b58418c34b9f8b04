// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

TEST_F(CommandTest, CertifiedFramesAreTheExactOnesAndTellWhatWasRedone) {
  const auto run = [&](const char* number) {
    return cigsim({"run", "--number", number, "--path", "builtin", "--frames", "3", "--raster",
                   "81x61", "--out", number});
  };
  const Outcome outcome = run("certified");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("certified numbers"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("3 of 3 frames certified"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\nRedone    "), std::string::npos) << outcome.out;
  ASSERT_EQ(run("exact").exit_code, 0);
  for (const char* name : {"/ids-0000.pgm", "/ids-0001.pgm", "/ids-0002.pgm", "/frame-0002.png"})
    EXPECT_EQ(contents(std::string("certified") + name), contents(std::string("exact") + name));
  const Json stats = Json::parse(contents("certified/stats.json"));
  EXPECT_EQ(stats["options"]["number"], "certified");
  for (const Json& frame : stats["frames"]) {
    EXPECT_EQ(frame["certified"], true);
    const Json& redone = frame["redone"];
    ASSERT_TRUE(redone.is_object());
    EXPECT_EQ(redone["edges"], frame["edges"]);
    EXPECT_EQ(redone["crossings"], frame["crossings"]);
    EXPECT_EQ(redone["exact_tests"], frame["exact_tests"]);
    EXPECT_GT(redone["vertices"], 0);
    EXPECT_GE(redone["faces"], frame["faces"]);
    for (const char* part : {"vertices", "faces", "crossings"})
      EXPECT_LE(redone[std::string(part) + "_redone"], redone[part]) << part;
    EXPECT_LT(redone["share"], 0.01);
  }
  EXPECT_TRUE(Json::parse(contents("exact/stats.json"))["frames"][0]["redone"].is_null());
}

TEST_F(CommandTest, CertifiedNumbersAreNotTheMachinesOwn) {
  expect_unusable({"run", "--number", "certified", "--level", "timed"},
                  "stages that know time compute on machine words");
  expect_unusable({"run", "--number", "certified", "--machine", "asupt1975"},
                  "a machine computes on machine words");
}

}  // namespace
}  // namespace cigsim
