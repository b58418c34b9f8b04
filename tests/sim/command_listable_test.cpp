// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

const std::string kScenes = CIGSIM_SOURCE_DIR "/scenes/";

TEST_F(CommandTest, ListableFindsStumpsCircuit) {
  const Outcome outcome = cigsim({"listable", kScenes + "stump-not-listable.json", "--json"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const Json r = Json::parse(outcome.out);
  EXPECT_EQ(r["listable"], false);
  const Json& fault = r["faults"][0];
  EXPECT_EQ(fault["circuits"][0]["objects"], Json({2, 3, 4})) << "B, C, D";
  EXPECT_EQ(fault["witness"]["counts"], Json({0, 2, 2, 2}));
  EXPECT_EQ(fault["machine_circuit"], Json({2, 3, 4})) << "the machine agrees";
  ASSERT_TRUE(fault["witness"]["eye"].is_array());
  // The witness asked for by itself.
  std::string eye;
  for (const Json& c : fault["witness"]["eye"]) {
    if (!eye.empty()) eye += ',';
    eye += c.dump();
  }
  const Outcome again =
      cigsim({"listable", kScenes + "stump-not-listable.json", "--eye=" + eye, "--json"});
  EXPECT_EQ(Json::parse(again.out)["from_eye"]["counts"], Json({0, 2, 2, 2}));
}

TEST_F(CommandTest, ListableNamesTheCircuitInWords) {
  const Outcome outcome = cigsim({"listable", kScenes + "stump-not-listable.json"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("objects 2 (B) -> 3 (C) -> 4 (D) -> 2 (B)"), std::string::npos)
      << outcome.out;
}

TEST_F(CommandTest, ListableProvesTheReassignedTable) {
  const Outcome outcome =
      cigsim({"listable", kScenes + "stump-reassigned.json", "--eye=-14,-16,14", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const Json r = Json::parse(outcome.out);
  EXPECT_EQ(r["listable"], true);
  EXPECT_EQ(r["from_eye"]["counts"], Json({0, 1, 2, 3})) << "as he prints";
}

TEST_F(CommandTest, ListableProvesDecksScenesAndDatabases) {
  for (const char* scene : {"stump-case-1.deck", "stump-case-2.deck", "stump-case-3.deck",
                            "levine-city.json", "fuchs-overlap.json"})
    EXPECT_EQ(cigsim({"listable", kScenes + scene}).exit_code, 0) << scene;
  ASSERT_EQ(cigsim({"generate", "brushes", "--objects", "300", "-o", "a.json"}).exit_code, 0);
  ASSERT_EQ(cigsim({"prepare", "a.json", "-o", "a.cbor"}).exit_code, 0);
  const Outcome outcome = cigsim({"listable", "a.cbor", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  const Json r = Json::parse(outcome.out);
  EXPECT_GT(r["groups"], 4);
  EXPECT_GT(r["side_tests"], 300);
  EXPECT_EQ(r["side_faults"], 0);
}

TEST_F(CommandTest, ListableNamesAPairWithoutPlane) {
  Json scene = Json::parse(R"({"cigsim": 1, "objects": []})");
  const Json source = Json::parse(test::bytes_of(kScenes + "stump-not-listable.json"));
  scene["objects"] = source["objects"];
  scene["separation"] = source["separation"];
  scene["separation"][0]["pairs"].erase(0);
  put("a.json", scene.dump());
  const Outcome outcome = cigsim({"listable", "a.json"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("pair 2 (B), 3 (C) stands on no plane"), std::string::npos)
      << outcome.out;
}

TEST_F(CommandTest, ListableRefusesWhatItCannotUse) {
  expect_unusable({"listable", "none.json"}, "none.json");
  expect_unusable({"listable", kScenes + "stump-case-1.deck", "--eye", "1,2"}, "--eye");
  // A table whose objects are not where its pairs say.
  Json scene = Json::parse(test::bytes_of(kScenes + "stump-reassigned.json"));
  scene["separation"][0]["distance"] = 5;
  put("a.json", scene.dump());
  expect_unusable({"listable", "a.json"}, "object 3 is listed as TRUE at separation plane 1");
}

}  // namespace
}  // namespace cigsim
