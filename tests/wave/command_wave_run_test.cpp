// SPDX-License-Identifier: MIT
// cigsim run --wave as a process of its own.
#include <csignal>
#include <set>

#include "firmware/programs.hpp"
#include "sim/level.hpp"
#include "sim/program_pipe.hpp"
#include "sim/wave/saved_view.hpp"
#include "sim/wave/value_names.hpp"
#include "sim/wave/wave_file.hpp"
#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Words = std::vector<std::string>;

Words small_run(const Words& more) {
  Words words{"run", "--raster", "64x48"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  const std::size_t begin = text.rfind('\n', end);
  return text.substr(begin + 1, end - begin);
}

Wave whole(const std::filesystem::path& path) {
  WaveFile file(path);
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < file.signals().size(); ++i) all.push_back(i);
  return file.read(all, {});
}

std::set<std::string> names_in(const std::filesystem::path& path) {
  std::set<std::string> names;
  const WaveFile file(path);
  for (const WaveSignal& signal : file.signals()) names.insert(signal.name + signal.range);
  return names;
}

TEST_F(CommandTest, EverySavedViewNamesSignalsThatThereAre) {
  const Outcome outcome =
      cigsim(small_run({"--level", "clocked", "--wave", "all.vcd", "--wave-cycles", "0:200"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(last_line(outcome.out), "gtkwave all.vcd all.gtkw");
  const std::set<std::string> names = names_in(folder_ / "all.vcd");
  std::size_t views = 0;
  for (const Stage stage : kAllStages) {
    if (!exists(stage, Level::kClocked)) continue;
    const std::string view =
        std::string(CIGSIM_SOURCE_DIR) + "/waves/" + std::string(name_of(stage)) + ".gtkw";
    for (const ViewRow& row : parse_saved_view(test::bytes_of(view), view))
      if (row.kind == ViewRow::Kind::kSignal) {
        EXPECT_EQ(names.count(row.text), 1u) << view << ": " << row.text;
      }
    ++views;
  }
  EXPECT_EQ(views, 5u);
  std::size_t clocks = 0;
  for (const ViewRow& row : parse_saved_view(contents("all.gtkw"), "all.gtkw")) {
    if (row.kind != ViewRow::Kind::kSignal) continue;
    EXPECT_EQ(names.count(row.text), 1u) << row.text;
    clocks += row.text == "cigsim.clock" ? 1 : 0;
  }
  EXPECT_EQ(clocks, 1u);
}

// The names of values lie beside the wave.
TEST_F(CommandTest, ASavedViewCanBeDrawnAtOnce) {
  ASSERT_EQ(cigsim(small_run({"--level", "priority_processor=clocked", "--wave", "w.vcd",
                              "--wave-cycles", "0:3000"}))
                .exit_code,
            0);
  const std::size_t size = firmware::stage_program("priority_processor").words.size();
  EXPECT_EQ(ValueNames::parse(contents("w.priority_processor.microprogram.names"), "names").size(),
            size);
  const Outcome outcome =
      cigsim({"wave-picture", "w.vcd", "--view", "w.gtkw", "--width", "9000", "-o", "w.svg"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(CommandTest, AWaveHasItsWindowAndItsStageAlone) {
  const Outcome outcome =
      cigsim(small_run({"--level", "priority_resolver=clocked,video_processor=clocked", "--wave",
                        "w.vcd", "--wave-cycles", "1000:1099", "--wave-scope", "video_processor"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Wave wave = whole(folder_ / "w.vcd");
  EXPECT_DOUBLE_EQ(static_cast<double>(wave.first) * wave.unit_ns, 1000 * 125.0);
  EXPECT_DOUBLE_EQ(static_cast<double>(wave.last) * wave.unit_ns, 1100 * 125.0);
  EXPECT_EQ(wave.traces.front().signal.name, "cigsim.clock");
  EXPECT_EQ(wave.traces.front().changes.size(), 200u);
  for (const std::string& name : names_in(folder_ / "w.vcd"))
    EXPECT_TRUE(name == "cigsim.clock" || name.rfind("cigsim.video_processor.", 0) == 0) << name;
}

TEST_F(CommandTest, AWaveChangesNoResult) {
  const Words mix{"--level", "priority_resolver=clocked", "--out"};
  Words plain = mix, waved = mix;
  plain.push_back("plain");
  waved.insert(waved.end(), {"waved", "--wave", "w.vcd"});
  ASSERT_EQ(cigsim(small_run(plain)).exit_code, 0);
  ASSERT_EQ(cigsim(small_run(waved)).exit_code, 0);
  EXPECT_EQ(contents("plain/frame-0000.png"), contents("waved/frame-0000.png"));
}

TEST_F(CommandTest, AFullDiskLeavesNoFstWave) {
  if (!has_program("vcd2fst")) GTEST_SKIP() << "vcd2fst (Debian package gtkwave) is missing";
  expect_unusable(small_run({"--level", "clocked", "--wave", "w.fst", "--wave-cycles", "0:99999"}),
                  "w.fst: is left incomplete by vcd2fst", {.file_size = 20000, .memory = {}});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "w.fst"));
}

TEST_F(CommandTest, AnFstWaveEqualsTheVcdWave) {
  const Words words{"--level", "priority_resolver=clocked", "--wave-cycles", "0:300", "--wave"};
  Words fst = words, vcd = words;
  fst.push_back("w.fst");
  vcd.push_back("w.vcd");
  if (!has_program("vcd2fst") || !has_program("fst2vcd")) {
    expect_unusable(small_run(fst), "install the Debian package gtkwave");
    GTEST_SKIP() << "vcd2fst and fst2vcd (Debian package gtkwave) are missing";
  }
  const Outcome outcome = cigsim(small_run(fst));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(last_line(outcome.out), "gtkwave w.fst w.gtkw");
  ASSERT_EQ(cigsim(small_run(vcd)).exit_code, 0);
  EXPECT_EQ(names_in(folder_ / "w.fst"), names_in(folder_ / "w.vcd"));
  const Wave a = whole(folder_ / "w.fst"), b = whole(folder_ / "w.vcd");
  EXPECT_EQ(a.last, b.last);
  EXPECT_EQ(a.traces.front().changes, b.traces.front().changes);
}

TEST_F(CommandTest, AStoppedRunLeavesAWholeWave) {
  const pid_t child = start({"run", "--path", "builtin", "--raster", "64x48", "--level", "clocked",
                             "--wave", "w.vcd", "--wave-scope", "video_processor"});
  for (int i = 0; i < 400 && !std::filesystem::exists(folder_ / "out" / "frame-0000.png"); ++i)
    ::usleep(50'000);
  ::kill(child, SIGINT);
  const Outcome outcome = finish(child);
  EXPECT_EQ(outcome.exit_code, 128 + SIGINT) << outcome.err;
  EXPECT_GT(whole(folder_ / "w.vcd").last, 0u);
  for (const std::string& name : files()) EXPECT_EQ(name.find(".part"), std::string::npos) << name;
}

TEST_F(CommandTest, AFullDiskLeavesNoWave) {
  expect_unusable(small_run({"--level", "clocked", "--wave", "w.vcd"}), "w.vcd: cannot be written",
                  {.file_size = 100'000, .memory = {}});
  for (const std::string& name : files()) EXPECT_EQ(name.find("w."), std::string::npos) << name;
}

TEST_F(CommandTest, WavesThatCannotBeAreRefusedAheadOfTheRun) {
  expect_unusable({"run", "--wave", "w.txt"}, "--wave: 'w.txt' must end in .vcd or .fst");
  expect_unusable({"run", "--wave", "w.vcd"},
                  "no stage is clocked or RTL in this run; add --level");
  expect_unusable({"run", "--wave", "w.vcd", "--level", "timed"}, "no stage is clocked");
  expect_unusable({"run", "--wave-cycles", "1:2"}, "--wave");
  const Words clocked{"run", "--level", "priority_resolver=clocked", "--wave", "w.vcd"};
  const auto with = [&](const std::string& option, const std::string& value) {
    Words words = clocked;
    words.insert(words.end(), {option, value});
    return words;
  };
  expect_unusable(with("--wave-cycles", "5"), "--wave-cycles: '5' must be A:B");
  expect_unusable(with("--wave-cycles", "5:4"), "must begin before it ends");
  expect_unusable(with("--wave-cycles", "a:4"), "'a' is not a whole number");
  expect_unusable(with("--wave-scope", "painter"), "'painter' is not known; choose from frame_");
  expect_unusable(with("--wave-scope", "edge_orderer"), "add --level edge_orderer=clocked");
  expect_unusable(with("--wave-scope", "frame_calculator"),
                  "frame_calculator has no clocked level");
  expect_unusable(small_run({"--level", "priority_resolver=clocked", "--wave", "absent/w.vcd"}),
                  "absent/w.vcd");
}

}  // namespace
}  // namespace cigsim
