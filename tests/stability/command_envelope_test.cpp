// SPDX-License-Identifier: MIT
// run's warning outside of an envelope, and the envelope as stability tells it.
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

class EnvelopeCommand : public CommandTest {
 protected:
  // A wall an earth radius from the origin, from five units away.
  Outcome run_far_away(const std::string& number, const std::string& out) {
    put("far.json", R"({"cigsim": 1, "models": [{"name": "m", "objects": [{"name": "wall",
        "vertices": [[6400000.3, 5, -1], [6400001.1, 5, -1], [6400001.1, 5, 1],
                     [6400000.3, 5, 1]], "faces": [[0, 1, 2, 3]]}]}]})");
    return cigsim({"run", "far.json", "--eye", "6400000.7,0,0", "--attitude", "0,0,0", "--raster",
                   "64x64", "--number", number, "--out", out});
  }
  Json envelope_of(const std::string& out) {
    return Json::parse(contents(out + "/stats.json"))["envelope"];
  }
};

TEST_F(EnvelopeCommand, RunWarnsOfFloatFarFromTheOrigin) {
  const Outcome outcome = run_far_away("float", "float");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("warning: outside the envelope of float: demand"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("--number double will do"), std::string::npos) << outcome.err;
  const Json envelope = envelope_of("float");
  EXPECT_EQ(envelope["inside"], false);
  EXPECT_EQ(envelope["excesses"][0]["quantity"], "demand");
  EXPECT_EQ(envelope["will_do"], "--number double");

  // And it is right: in float the wall stands elsewhere, in what will do it does not.
  const Outcome doubles = run_far_away("double", "double");
  ASSERT_EQ(run_far_away("exact", "exact").exit_code, 0);
  EXPECT_EQ(doubles.err.find("warning"), std::string::npos) << doubles.err;
  EXPECT_EQ(envelope_of("double")["inside"], true);
  EXPECT_EQ(contents("double/ids-0000.pgm"), contents("exact/ids-0000.pgm"));
  EXPECT_NE(contents("float/ids-0000.pgm"), contents("exact/ids-0000.pgm"));
}

TEST_F(EnvelopeCommand, RunIsSilentInside) {
  const std::vector<std::vector<std::string>> ways{
      {}, {"--path", "builtin", "--frames", "5"}, {"--number", "float"}, {"--number", "machine"}};
  for (const auto& way : ways) {
    std::vector<std::string> words{"run", "--raster", "64x64"};
    words.insert(words.end(), way.begin(), way.end());
    const Outcome outcome = cigsim(words);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(envelope_of("out")["known"], true);
    EXPECT_EQ(envelope_of("out")["inside"], true);
  }
}

TEST_F(EnvelopeCommand, StabilityTellsTheEnvelopeThatTheProgramCarries) {
  const Outcome outcome = cigsim({"stability", "--part", "envelope"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* words : {"Envelope (as the program carries it)", "demand", "float", "nasa1968"})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << outcome.out;
  const Json found = Json::parse(cigsim({"stability", "--part", "envelope", "--json"}).out);
  EXPECT_EQ(found["envelope"]["formats"].size(), 6u);
  for (const Json& format : found["envelope"]["formats"]) EXPECT_EQ(format["limits"].size(), 7u);
}

}  // namespace
}  // namespace cigsim
