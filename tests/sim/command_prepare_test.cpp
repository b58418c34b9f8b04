// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

constexpr const char* kTriangle =
    "o one\nv 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\no two\nv 5 9 0\nv 6 9 0\nv 5 9 1\nf 4 5 6\n";

TEST_F(CommandTest, APreparedDatabaseRendersAsItsScene) {
  ASSERT_EQ(cigsim({"generate", "city", "--objects", "30", "-o", "city.json"}).exit_code, 0);
  ASSERT_EQ(cigsim({"run", "city.json", "--raster", "90x60", "--out", "scene"}).exit_code, 0);
  for (const char* database : {"db.json", "db.cbor"}) {
    const Outcome outcome = cigsim({"prepare", "city.json", "-o", database});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("separation planes"), std::string::npos);
    ASSERT_EQ(cigsim({"run", database, "--raster", "90x60", "--out", "database"}).exit_code, 0);
    EXPECT_EQ(contents("database/frame-0000.png"), contents("scene/frame-0000.png"));
    EXPECT_EQ(contents("database/ids-0000.pgm"), contents("scene/ids-0000.pgm"));
  }
}

TEST_F(CommandTest, SeveralInputsBecomeOneEnvironment) {
  put("a.obj", kTriangle);
  put("b.obj", kTriangle);
  const Outcome outcome = cigsim({"prepare", "a.obj", "b.obj", "-o", "db.json", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report["objects"], 4);
  EXPECT_EQ(report["unclosed_objects"], 4);
  EXPECT_EQ(report["file"], "db.json");
  EXPECT_TRUE(report["notices"].is_array());
}

TEST_F(CommandTest, PrepareRefusesWhatItWouldSpoil) {
  put("a.obj", kTriangle);
  ASSERT_EQ(cigsim({"prepare", "a.obj", "-o", "db.json"}).exit_code, 0);
  const std::string before = contents("db.json");
  expect_unusable({"prepare", "a.obj", "-o", "db.txt"}, "must end in .json or .cbor");
  expect_unusable({"prepare", "db.json", "-o", "new.json"}, "db.json is prepared already");
  expect_unusable({"prepare", "db.json", "-o", "db.json"}, "is an input");
  expect_unusable({"prepare", "a.obj", "-o", "absent/db.json"}, "absent/db.json");
  expect_unusable({"run", "db.json", "--sun", "1,2"}, "--sun: db.json is prepared");
  expect_unusable({"run", "db.json", "--contact-tolerance", "0"}, "--contact-tolerance: db.json");
  EXPECT_EQ(contents("db.json"), before);
  EXPECT_EQ(files(), (std::vector<std::string>{"a.obj", "db.json"}));
}

TEST_F(CommandTest, AFullDiskLeavesTheOldDatabase) {
  put("a.obj", kTriangle);
  ASSERT_EQ(cigsim({"prepare", "a.obj", "-o", "db.json"}).exit_code, 0);
  const std::string before = contents("db.json");
  expect_unusable({"prepare", "a.obj", "-o", "db.json"}, "db.json",
                  {.file_size = 500, .memory = {}});
  EXPECT_EQ(contents("db.json"), before);
  EXPECT_EQ(files(), (std::vector<std::string>{"a.obj", "db.json"}));
}

TEST_F(CommandTest, ADamagedDatabaseIsRefused) {
  put("a.obj", kTriangle);
  ASSERT_EQ(cigsim({"prepare", "a.obj", "-o", "db.json"}).exit_code, 0);
  const std::string whole = contents("db.json");
  put("cut.json", whole.substr(0, whole.size() / 2));
  expect_unusable({"run", "cut.json"}, "cut.json:1: is damaged or cut short");
  Json other = Json::parse(whole);
  other["cigsim-database"] = 99;
  put("other.json", other.dump());
  expect_unusable({"run", "other.json"}, "cigsim-database: is a version");
}

TEST_F(CommandTest, TheSunChangesTheShades) {
  ASSERT_EQ(cigsim({"generate", "cubes", "--objects", "8", "-o", "a.json"}).exit_code, 0);
  ASSERT_EQ(cigsim({"run", "a.json", "--raster", "30x30", "--sun", "0,5"}).exit_code, 0);
  const std::string low = contents("out/frame-0000.png");
  ASSERT_EQ(cigsim({"prepare", "a.json", "--sun", "0,90", "-o", "db.json"}).exit_code, 0);
  ASSERT_EQ(cigsim({"run", "db.json", "--raster", "30x30"}).exit_code, 0);
  EXPECT_NE(contents("out/frame-0000.png"), low);
}

// A thing of one unit, an earth radius off the origin: no picture of it is right in floats.
TEST_F(CommandTest, PrepareHoldsTheSceneAgainstTheEnvelope) {
  put("near.obj", kTriangle);
  put("far.obj", "v 6400000 0 0\nv 6400001 0 0\nv 6400000 1 0\nf 1 2 3\n");
  for (const std::string scene : {"near", "far"}) {
    const Outcome outcome = cigsim({"prepare", scene + ".obj", "-o", scene + ".db.json", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json envelope = Json::parse(outcome.out)["envelope"];
    ASSERT_EQ(envelope.size(), 4u);
    EXPECT_EQ(envelope[0]["format"], "float");
    EXPECT_EQ(envelope[0]["inside"], scene == "near");
  }
  const Outcome told = cigsim({"prepare", "far.obj", "-o", "db.json"});
  EXPECT_NE(told.out.find("float  outside: demand"), std::string::npos) << told.out;
}

}  // namespace
}  // namespace cigsim
