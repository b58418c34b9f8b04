// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

// What the page carries.
Json data_of(const std::string& page) {
  const std::string open = "<script type=\"application/json\" id=\"data\">";
  const std::size_t from = page.find(open) + open.size();
  return Json::parse(page.substr(from, page.find("</script>", from) - from));
}

class ReportTest : public CommandTest {
 protected:
  void run(std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"run", "--raster", "48x36"});
    const Outcome outcome = cigsim(more);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  void change_stats(const std::string& pointer, const Json& value) {
    Json stats = Json::parse(contents("out/stats.json"));
    stats[Json::json_pointer(pointer)] = value;
    put("out/stats.json", stats.dump());
  }
};

TEST_F(ReportTest, OfARunSaysWhatItWrote) {
  run({"--path", "builtin", "--frames", "5"});
  const Outcome outcome = cigsim({"report", "out", "--frames", "3"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("3 of 5 frames"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("out/report.html"), std::string::npos);
  const Json data = data_of(contents("out/report.html"));
  EXPECT_EQ(data["run"]["shown"].size(), 3u);
  EXPECT_EQ(data["run"]["table"].size(), 5u);
  EXPECT_TRUE(data["run"]["notes"].empty());
  for (const Json& frame : data["run"]["shown"]) {
    EXPECT_EQ(frame["difference"]["elements"], 48 * 36);
    EXPECT_EQ(frame["crossings"].size(), 36u);
    EXPECT_GT(frame["faces"].size(), 0u);
  }
}

TEST_F(ReportTest, IsTheSameEachTime) {
  run();
  const Outcome outcome = cigsim({"report", "out", "-o", "a.html", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json told = Json::parse(outcome.out);
  EXPECT_EQ(told["page"], "a.html");
  EXPECT_EQ(told["bytes"], contents("a.html").size());
  EXPECT_EQ(told["frames"], 1);
  ASSERT_EQ(cigsim({"report", "out", "-o", "b.html"}).exit_code, 0);
  EXPECT_EQ(contents("a.html"), contents("b.html"));
}

TEST_F(ReportTest, OfEachKindOfRunAgreesWithItsPicture) {
  const std::vector<std::vector<std::string>> kinds = {
      {"--number", "float"},
      {"--number", "certified", "--retrieval", "off", "--coherence", "off"},
      {"--number", "exact", "--priority", "so", "--resolver", "active-list"},
      {"--detail", "most", "--sun", "100,20", "--contact-tolerance", "0"},
      {"--machine", "nasa1968", "--overload", "cut"},
      {"--machine", "nasa1968", "--level", "timed", "--path", "builtin", "--frames", "3"}};
  for (const auto& kind : kinds) {
    run(kind);
    ASSERT_EQ(cigsim({"report", "out", "--no-difference"}).exit_code, 0);
    const Json run_data = data_of(contents("out/report.html"))["run"];
    EXPECT_TRUE(run_data["notes"].empty()) << kind[1] << run_data["notes"];
    EXPECT_TRUE(run_data["shown"][0]["difference"].is_null());
    EXPECT_EQ(run_data["machine"].is_null(), kind[0] != "--machine");
  }
}

// The functional level, which computes the frame again, knows no deadline.
TEST_F(ReportTest, AgreesWithAPictureWhoseFacesADeadlineDropped) {
  Json machine = Json::parse(cigsim({"machines", "asupt1975", "--json"}).out);
  machine["figures"]["frame_cycles"]["value"] = 60000;
  machine["figures"]["line_cycles"]["value"] = 0;
  put("short.json", machine.dump());
  run({"--machine", "short.json", "--level", "timed", "--path", "builtin", "--frames", "3"});
  ASSERT_EQ(cigsim({"report", "out"}).exit_code, 0);
  const Json data = data_of(contents("out/report.html"))["run"];
  EXPECT_TRUE(data["notes"].empty()) << data["notes"];
  std::size_t dropped = 0, wrong = 0;
  for (const Json& frame : data["shown"]) {
    dropped += frame["figures"]["overload"]["dropped_faces"].get<std::size_t>();
    wrong += frame["difference"]["wrong"].get<std::size_t>();
    EXPECT_EQ(frame["faces"].size(), frame["figures"]["faces"]);
  }
  EXPECT_GT(dropped, 0u);
  EXPECT_GT(wrong, 0u);
}

TEST_F(ReportTest, TellsThatTheSceneIsAnotherOne) {
  const auto generate = [&](const char* seed) {
    return cigsim({"generate", "random", "--objects", "9", "--seed", seed, "-o", "s.json"})
        .exit_code;
  };
  const auto report = [&] {
    const Outcome outcome = cigsim({"report", "out"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  ASSERT_EQ(generate("1"), 0);
  run({"s.json"});
  EXPECT_EQ(report().find("Note"), std::string::npos);
  ASSERT_EQ(generate("2"), 0);
  EXPECT_NE(report().find("not the one of this run"), std::string::npos);
  ASSERT_EQ(generate("1"), 0);
  EXPECT_EQ(report().find("Note"), std::string::npos);
  Json scene = Json::parse(contents("s.json"));
  scene["background"] = {1, 2, 3};
  put("s.json", scene.dump());
  EXPECT_NE(report().find("not the one of this run"), std::string::npos);
  std::filesystem::remove(folder_ / "s.json");
  EXPECT_NE(report().find("cannot be had any more"), std::string::npos);
}

TEST_F(ReportTest, OfExperimentsTakesTheirFiguresAndDrawings) {
  std::filesystem::create_directory(folder_ / "e");
  put("e/a.json", R"({"experiment": "a", "seed": 1})");
  put("e/other.json", "[1, 2]");
  put("e/b.svg", "<svg/>");
  put("e/broken.json", "{\n\"experiment\": 1,\n}");
  put("e/deep.json", std::string(100000, '['));
  put("e/empty.json", "");
  const Outcome outcome = cigsim({"report", "e"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("other.json tells of no experiment"), std::string::npos);
  for (const char* words :
       {"broken.json:3: not valid JSON", "deep.json:1: is nested", "empty.json"})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("json.exception"), std::string::npos) << outcome.out;
  const Json data = data_of(contents("e/report.html"));
  EXPECT_TRUE(data["run"].is_null());
  EXPECT_EQ(data["experiments"]["experiments"].size(), 1u);
  EXPECT_EQ(data["experiments"]["experiments"][0]["figures"]["seed"], 1);
  EXPECT_EQ(data["experiments"]["drawings"][0]["uri"], "data:image/svg+xml;base64,PHN2Zy8+");
}

TEST_F(ReportTest, RefusesWhatItCannotUse) {
  expect_unusable({"report"}, "DIR");
  expect_unusable({"report", "nowhere"}, "is no folder");
  std::filesystem::create_directory(folder_ / "empty");
  expect_unusable({"report", "empty"}, "neither a run nor an experiment");
  put("empty/x.json", "{");
  expect_unusable({"report", "empty"}, "x.json:1: not valid JSON");
  run();
  expect_unusable({"report", "out", "--frames", "0"}, "--frames");
  expect_unusable({"report", "out", "-o", "page.pdf"}, "-o");
  expect_unusable({"report", "out", "-o", "no/folder/page.html"}, "page.html");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/report.html"));
}

TEST_F(ReportTest, RefusesFiguresThatAreNoRuns) {
  run();
  const std::string good = contents("out/stats.json");
  for (const auto& [pointer, value] :
       std::vector<std::pair<std::string, Json>>{{"/frames/0/picture", "../secret.png"},
                                                 {"/frames/0/ids", "/etc/passwd"},
                                                 {"/frames/0/view", nullptr},
                                                 {"/frames", 7},
                                                 {"/options/raster", {0, 36}},
                                                 {"/options/raster", {1e9, 36}},
                                                 {"/options/number", "octal"},
                                                 {"/scene", 1}}) {
    change_stats(pointer, value);
    expect_unusable({"report", "out"}, "is not what cigsim run of this version writes");
    put("out/stats.json", good);
  }
  Json without = Json::parse(good);
  without["frames"][0].erase("picture");
  put("out/stats.json", without.dump(1));
  const Outcome outcome = cigsim({"report", "out"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("frames/0: key 'picture' not found; repeat"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.err.find("json.exception"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("stats.json: "), std::string::npos) << outcome.err;  // has a line
  put("out/stats.json", good.substr(0, good.size() / 2));
  expect_unusable({"report", "out"}, "not valid JSON");
  put("out/stats.json", good);
  put("out/frame-0000.png", "no picture");
  expect_unusable({"report", "out"}, "is no PNG of 48 x 36");
  std::filesystem::remove(folder_ / "out/frame-0000.png");
  expect_unusable({"report", "out"}, "frame-0000.png");
}

TEST_F(ReportTest, TellsTheLineOfARecordedMachineThatIsNone) {
  run({"--machine", "nasa1968"});
  const std::string good = contents("out/stats.json");
  for (const auto& [pointer, value, reason] :
       std::vector<std::tuple<std::string, Json, std::string>>{
           {"/machine/figures/clock_ns/value", -1, "machine: clock_ns is -1"},
           {"/options/raster", {32, 36}, "machine: the machine's raster is not"},
           {"/machine", nullptr, "machine: "}}) {
    change_stats(pointer, value);
    const std::string stats = Json::parse(contents("out/stats.json")).dump(1);
    put("out/stats.json", stats);
    const std::string before = stats.substr(0, stats.find("\"machine\": "));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const Outcome outcome = cigsim({"report", "out"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("stats.json:" + std::to_string(line) + ": "), std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("; repeat the run"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("add it"), std::string::npos) << outcome.err;
    put("out/stats.json", good);
  }
}

}  // namespace
}  // namespace cigsim
