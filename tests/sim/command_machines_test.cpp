// SPDX-License-Identifier: MIT
#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

TEST_F(CommandTest, MachinesListsThePresets) {
  const Outcome outcome = cigsim({"machines"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"nasa1968", "asupt1975", "unlimited"})
    EXPECT_NE(outcome.out.find(name), std::string::npos) << name;
}

TEST_F(CommandTest, MachinesTellsFiguresWithStandingAndSource) {
  const Outcome outcome = cigsim({"machines", "asupt1975"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  bool found = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("edge_capacity") == std::string::npos) continue;
    found = true;
    EXPECT_NE(line.find(" 2500 edges"), std::string::npos) << line;
    EXPECT_NE(line.find("recalled"), std::string::npos) << line;
    EXPECT_NE(line.find("ASUPT"), std::string::npos) << line;
  }
  EXPECT_TRUE(found);
  EXPECT_NE(outcome.out.find("687 cycles are vertical blanking"), std::string::npos);
}

TEST_F(CommandTest, AMachineCanBeSavedEditedAndReadBack) {
  std::string text = cigsim({"machines", "asupt1975", "--json"}).out;
  const std::string from = "\"edge_capacity\": {\"value\": 2500";
  ASSERT_NE(text.find(from), std::string::npos);
  text.replace(text.find(from), from.size(), "\"edge_capacity\": {\"value\": 4321");
  put("mine.json", text);
  const Outcome outcome = cigsim({"machines", "mine.json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(" 4321 edges"), std::string::npos);
}

TEST_F(CommandTest, UnusableMachinesAreRefused) {
  put("broken.json", "{\n\"format\": 1}");
  expect_unusable({"machines", "broken.json"}, "broken.json:2: is no machine description");
  expect_unusable({"machines", "cray"}, "cray: is neither a preset nor a file");
  expect_unusable({"machines", "--json"}, "--json needs");
}

}  // namespace
}  // namespace cigsim
