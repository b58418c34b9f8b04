// SPDX-License-Identifier: MIT
#include <algorithm>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

constexpr const char* kFormat = "format f\nsequencer\nfield cond 2\nTRUE 0\nfield a 8\n";
constexpr const char* kProgram = ".define N 3\nstart: a=N\nCJP start\n.cost round start start\n";

TEST_F(CommandTest, AssembleWritesTheImageOfAStage) {
  const Outcome made = cigsim({"assemble", "priority_processor", "-o", "pp.hex"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.out.find("words of"), std::string::npos) << made.out;
  const std::string image = contents("pp.hex");
  EXPECT_GT(std::count(image.begin(), image.end(), '\n'), 30);
  EXPECT_EQ(image.find_first_not_of("0123456789abcdef\n"), std::string::npos);
}

TEST_F(CommandTest, AssembleListsAFileWithItsCostsAndOtherConstants) {
  put("my.fmt", kFormat);
  put("my.mas", kProgram);
  const Outcome made = cigsim(
      {"assemble", "my.mas", "--format", "my.fmt", "--define", "N=7", "--listing", "-o", "my.hex"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.out.find("constant N = 7"), std::string::npos) << made.out;
  EXPECT_NE(made.out.find("cost round = 2 cycles"), std::string::npos) << made.out;
  // a = 7 from bit 20 on, op = CONT; then op = CJP.
  EXPECT_EQ(contents("my.hex"),
            "070000e\n"
            "0000003\n");
}

TEST_F(CommandTest, AssembleRefusesWhatItDoesNotKnow) {
  put("my.fmt", kFormat);
  put("bad.mas", "a=1\nb=1\n");
  expect_unusable({"assemble", "painter"}, "'painter' is not one of the stages");
  expect_unusable({"assemble", "bad.mas", "--format", "my.fmt"},
                  "bad.mas:2: there is no field 'b'");
  expect_unusable({"assemble", "absent.mas", "--format", "my.fmt"}, "absent.mas: no such file");
  expect_unusable({"assemble", "priority_processor", "--define", "N"}, "'N' is not NAME=VALUE");
  expect_unusable({"assemble", "priority_processor", "--define", "N=1"}, "'.define N'");
}

}  // namespace
}  // namespace cigsim
