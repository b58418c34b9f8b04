// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "tests/sim/png_reader.hpp"
#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;
using Names = std::vector<std::string>;

TEST_F(CommandTest, RunWritesPicturesNumbersAndFigures) {
  const Outcome outcome = cigsim({"run", "--raster", "64x48", "--frames", "2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("out/frame-0000.png to frame-0001.png"), std::string::npos);
  EXPECT_EQ(files(), (Names{"out", "out/frame-0000.png", "out/frame-0001.png", "out/ids-0000.pgm",
                            "out/ids-0001.pgm", "out/stats.json"}));
  const RgbPicture picture = read_png(folder_ / "out/frame-0001.png");
  EXPECT_EQ(picture.width, 64);
  EXPECT_EQ(picture.height, 48);
  const std::string numbers = contents("out/ids-0000.pgm"), header = "P5\n64 48\n65535\n";
  EXPECT_EQ(numbers.substr(0, header.size()), header);
  EXPECT_EQ(numbers.size(), header.size() + 2 * 64 * 48);
}

TEST_F(CommandTest, StatsHaveTheFieldsThatScriptsRelyOn) {
  ASSERT_EQ(cigsim({"run", "--raster", "64x48", "--repeat", "3", "--out", "a/b"}).exit_code, 0);
  const Json stats = Json::parse(contents("a/b/stats.json"));
  EXPECT_EQ(stats["level"], "functional");
  EXPECT_TRUE(stats["seed"].is_null());
  EXPECT_EQ(stats["options"]["repeat"], 3);
  EXPECT_EQ(stats["options"]["raster"], Json({64, 48}));
  EXPECT_TRUE(stats["versions"]["cigsim"].is_string());
  EXPECT_GT(stats["preparation"]["objects"], 100);
  ASSERT_EQ(stats["frames"].size(), 1u);
  const Json& frame = stats["frames"][0];
  EXPECT_EQ(frame["picture"], "frame-0000.png");
  EXPECT_EQ(frame["ids"], "ids-0000.pgm");
  EXPECT_GT(frame["host_ms"], 0);
  EXPECT_EQ(frame["cycles"]["total"], 0);
  for (const char* count : {"edges", "crossings", "spans", "faces", "active_items"})
    EXPECT_GT(frame[count], 0) << count;
  EXPECT_LE(frame["worst_line_crossings"], frame["crossings"]);
  EXPECT_EQ(frame["faults"], 0);
  EXPECT_TRUE(frame["certified"].is_boolean());
  for (const char* stage : {"frame_calculator", "geometry_processor", "priority_processor",
                            "edge_orderer", "priority_resolver", "video_processor"})
    EXPECT_GE(frame["stages"][stage], 0) << stage;
}

TEST_F(CommandTest, AListabilityFaultIsNamedAndThePictureMade) {
  const std::string scene = CIGSIM_SOURCE_DIR "/scenes/stump-not-listable.json";
  const Outcome outcome = cigsim({"run", scene, "--raster", "32x32"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Decisions 1 listability faults"), std::string::npos);
  EXPECT_NE(outcome.out.find("Fault     objects 2 -> 3 -> 4 -> 2"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/frame-0000.png"));
  const Json frame = Json::parse(contents("out/stats.json"))["frames"][0];
  EXPECT_EQ(frame["faults"], 1);
  EXPECT_EQ(frame["listability"],
            Json::parse(R"([{"group": 0, "objects": [1, 2, 3, 4], "circuit": [2, 3, 4],
                             "unresolved": []}])"));

  const Outcome measured = cigsim({"requirements", scene, "--raster", "32x32", "--json"});
  EXPECT_EQ(Json::parse(measured.out)["database"]["pairs"], 6);
}

TEST_F(CommandTest, JsonPutsTheFiguresOnStandardOutput) {
  const Outcome outcome = cigsim({"run", "--raster", "8x8", "--json"});
  ASSERT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, contents("out/stats.json"));
}

TEST_F(CommandTest, ANegativeFirstCoordinateIsAValue) {
  ASSERT_EQ(cigsim({"run", "--raster", "8x8", "--eye", "-5,0,3", "--look-at", "-5,10,3"}).exit_code,
            0);
  const Json view = Json::parse(contents("out/stats.json"))["frames"][0]["view"];
  EXPECT_EQ(view["eye"], Json({-5.0, 0.0, 3.0}));
  EXPECT_EQ(view["attitude"], Json({0.0, 0.0, 0.0}));
}

TEST_F(CommandTest, AllMethodsGiveTheSameNumbers) {
  const std::vector<Names> ways{{},
                                {"--resolver", "active-list"},
                                {"--priority", "so"},
                                {"--number", "exact"},
                                {"--number", "float"}};
  std::vector<std::string> pictures;
  for (const Names& way : ways) {
    Names words{"run", "--raster", "40x30"};
    words.insert(words.end(), way.begin(), way.end());
    ASSERT_EQ(cigsim(words).exit_code, 0);
    pictures.push_back(contents("out/ids-0000.pgm"));
  }
  EXPECT_EQ(pictures[1], pictures[0]);
  EXPECT_EQ(pictures[2], pictures[0]);
  EXPECT_EQ(pictures[3].size(), pictures[0].size());
  EXPECT_EQ(pictures[4].size(), pictures[0].size());
}

TEST_F(CommandTest, APathIsFlownRowByRowOrInEvenSteps) {
  put("path.csv", "x,y,z,heading,pitch,roll,fov\n0,-300,30,0,0,0,40\n0,-200,20,0,-4,0,60\n");
  ASSERT_EQ(cigsim({"run", "--raster", "8x8", "--path", "path.csv", "--out", "rows"}).exit_code, 0);
  EXPECT_EQ(Json::parse(contents("rows/stats.json"))["frames"].size(), 2u);
  ASSERT_EQ(
      cigsim({"run", "--raster", "8x8", "--path", "path.csv", "--frames", "5", "--out", "even"})
          .exit_code,
      0);
  const Json frames = Json::parse(contents("even/stats.json"))["frames"];
  ASSERT_EQ(frames.size(), 5u);
  EXPECT_EQ(frames[2]["view"]["eye"], Json({0.0, -250.0, 25.0}));
  EXPECT_EQ(frames[2]["view"]["fov"], 50.0);
  EXPECT_EQ(frames[2]["position"], 0.5);
  EXPECT_EQ(contents("rows/frame-0001.png"), contents("even/frame-0004.png"));
  EXPECT_EQ(cigsim({"run", "--raster", "8x8", "--path", "builtin", "--frames", "3"}).exit_code, 0);
}

TEST_F(CommandTest, AnObjectNumberAloneFillsTheViewOfItsInside) {
  put("wall.json", R"({"cigsim": 1, "models": [{"name": "m", "objects": [{"name": "wall",
      "vertices": [[-9, 5, -9], [9, 5, -9], [9, 5, 9], [-9, 5, 9]], "faces": [[0, 1, 2, 3]]}]}]})");
  const Outcome outcome =
      cigsim({"run", "wall.json", "--eye", "0,0,0", "--attitude", "0,0,0", "--raster", "4x4"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string numbers = contents("out/ids-0000.pgm");
  std::string ones;
  for (int i = 0; i < 16; ++i) ones += std::string("\0\1", 2);
  EXPECT_EQ(numbers.substr(numbers.size() - 32), ones);
}

TEST_F(CommandTest, RunDoesNotOverwriteItsScene) {
  std::filesystem::create_directory(folder_ / "out");
  const std::string scene =
      R"({"cigsim": 1, "objects": [{"vertices": [[0, 5, 0], [1, 5, 0], [0, 5, 1]],
          "faces": [[0, 1, 2]]}]})";
  put("out/stats.json", scene);
  expect_unusable({"run", "out/stats.json", "--out", "out"}, "out/stats.json is an input");
  EXPECT_EQ(contents("out/stats.json"), scene);
}

TEST_F(CommandTest, CtrlCLeavesWholeFilesAndFigures) {
  const pid_t child = start({"run", "--raster", "64x64", "--frames", "100000"});
  for (int i = 0; i < 3000 && !std::filesystem::exists(folder_ / "out/ids-0002.pgm"); ++i)
    usleep(10000);
  kill(child, SIGINT);
  EXPECT_EQ(finish(child).exit_code, 130);
  const Json stats = Json::parse(contents("out/stats.json"));
  EXPECT_TRUE(stats["interrupted"]);
  const std::size_t frames = stats["frames"].size();
  EXPECT_GE(frames, 3u);
  EXPECT_EQ(files().size(), 2 * frames + 2) << "pictures, numbers, the folder, stats.json";
  EXPECT_EQ(read_png(folder_ / fmt::format("out/frame-{:04}.png", frames - 1)).width, 64);
}

TEST_F(CommandTest, AFullDiskLeavesNoPartOfAFile) {
  expect_unusable({"run", "--raster", "256x256"}, "out/", {.file_size = 700, .memory = {}});
  EXPECT_EQ(files(), Names{"out"});
}

TEST_F(CommandTest, FiguresOfAnEarlierRunDoNotOutliveAFailure) {
  ASSERT_EQ(cigsim({"run", "--raster", "8x8"}).exit_code, 0);
  expect_unusable({"run", "--raster", "256x256"}, "out/", {.file_size = 700, .memory = {}});
  EXPECT_EQ(files(), (Names{"out", "out/frame-0000.png", "out/ids-0000.pgm"}));
}

TEST_F(CommandTest, AFolderThatCannotBeMadeIsNamed) {
  put("taken", "a file");
  expect_unusable({"run", "--raster", "8x8", "--out", "taken"}, "taken: cannot make this folder");
  EXPECT_EQ(contents("taken"), "a file");
}

#ifndef __SANITIZE_ADDRESS__
TEST_F(CommandTest, TooLittleMemoryIsSaidInOneLine) {
  expect_unusable({"run", "--raster", "16384x16384"}, "not enough memory",
                  {.file_size = {}, .memory = 400u << 20});
}
#endif

}  // namespace
}  // namespace cigsim
