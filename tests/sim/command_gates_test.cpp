// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

TEST_F(CommandTest, GatesTellsTableAndJsonOfTheSameCircuits) {
  const std::vector<std::string> sizes{"gates", "--size", "2x1", "--faces", "64"};
  const Outcome table = cigsim(sizes);
  ASSERT_EQ(table.exit_code, 0) << table.err;
  std::vector<std::string> with_json = sizes;
  with_json.push_back("--json");
  const Outcome outcome = cigsim(with_json);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const nlohmann::json figures = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(figures["line_cycles"], 260);
  EXPECT_EQ(figures["frame_cycles"], 266667);
  std::vector<std::string> modules;
  for (const auto& circuit : figures["circuits"]) {
    modules.push_back(circuit["module"]);
    EXPECT_NE(table.out.find(circuit["module"]), std::string::npos);
    EXPECT_GT(circuit["gates"], 0);
    EXPECT_GT(circuit["packages"], 0);
    if (circuit["ram_bits"] == 0) {
      EXPECT_EQ(circuit["delay_ns"]["74S"], 3 * circuit["levels"].get<double>());
    }
  }
  EXPECT_EQ(modules, (std::vector<std::string>{"so_pair", "so_row", "so_matrix", "object_counters",
                                               "active_set", "priority_resolver"}));
  for (const auto& way : figures["ordering"]) {
    EXPECT_EQ(way["cycles_of_a_step"], 1);
    EXPECT_LT(way["objects_in_a_line"], way["objects_in_a_frame"]);
  }
  EXPECT_NE(table.out.find("74S: 3 ns a gate level"), std::string::npos);
}

TEST_F(CommandTest, ManualQuotesTheTableThatGatesPrints) {
  std::ifstream file(CIGSIM_SOURCE_DIR "/docs/machine/gates.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  ASSERT_NE(page.find("so_matrix         64 x 64"), std::string::npos);
  const Outcome outcome = cigsim({"gates", "--size", "5x4", "--faces", "64"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);)
    EXPECT_NE(page.find(line + "\n"), std::string::npos) << line;
}

TEST_F(CommandTest, UnusableGatesAreRefused) {
  expect_unusable({"gates", "--size", "64"}, "--size 64: is not OBJECTSxPLANES");
  expect_unusable({"gates", "--size", "1x4"}, "--size");
  expect_unusable({"gates", "--size", "4x257"}, "--size");
  expect_unusable({"gates", "--size", ""}, "--size");
  expect_unusable({"gates", "--faces", "100"}, "--faces 100: is no multiple of 32");
  expect_unusable({"gates", "--faces", "32"}, "--faces");
  expect_unusable({"gates", "--machine", "unlimited"}, "has no fixed line and frame");
}

TEST_F(CommandTest, GatesWithoutYosysSaysWhatToInstall) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  expect_unusable({"gates"}, "yosys is not installed; apt-get install yosys");
  setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace cigsim
