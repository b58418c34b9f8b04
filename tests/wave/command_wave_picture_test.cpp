// SPDX-License-Identifier: MIT
// cigsim wave-picture as a process of its own.
#include "sim/program_pipe.hpp"
#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

constexpr const char* kWave =
    "$timescale 1 ns $end\n$scope module top $end\n"
    "$var wire 1 ! clock $end\n$var wire 8 \" count [7:0] $end\n"
    "$upscope $end\n$enddefinitions $end\n"
    "#0\n1!\nb0 \"\n#62\n0!\n#125\n1!\nb11 \"\n#187\n0!\n#250\n1!\nb11111111 \"\n#312\n0!\n#375\n";
constexpr const char* kView =
    "[*]\n@200\n-Clock\n@28\ntop.clock\n@200\n-Values\n@420\n+{how many} top.count[7:0]\n";

TEST_F(CommandTest, AWavePictureShowsWhatTheViewNames) {
  put("w.vcd", kWave);
  put("w.gtkw", kView);
  const Outcome outcome = cigsim({"wave-picture", "w.vcd", "--view", "w.gtkw", "-o", "w.svg"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string svg = contents("w.svg");
  for (const char* text : {">Clock<", ">clock<", ">how many<", ">0<", ">3<", ">-1<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

// The file with the names is looked for beside the view.
TEST_F(CommandTest, AWavePictureShowsValuesByName) {
  std::filesystem::create_directory(folder_ / "views");
  put("w.vcd", kWave);
  put("views/w.gtkw", "@2420\n^1 count.names\ntop.count[7:0]\n");
  const std::vector<std::string> words{"wave-picture", "w.vcd", "--view",
                                       "views/w.gtkw", "-o",    "w.svg"};
  expect_unusable(words, "count.names: no such file");
  put("views/count.names", "3 three\n-1 minus one\n");
  ASSERT_EQ(cigsim(words).exit_code, 0);
  const std::string svg = contents("w.svg");
  for (const char* text : {">0<", ">three<", ">minus one<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST_F(CommandTest, AWavePictureShowsTheWindowAndTheSignalsAskedFor) {
  put("w.vcd", kWave);
  ASSERT_EQ(cigsim({"wave-picture", "w.vcd", "--cycles", "--from", "1", "--to", "2", "--signal",
                    "count=dec", "-o", "cycles.svg"})
                .exit_code,
            0);
  ASSERT_EQ(cigsim({"wave-picture", "w.vcd", "--from", "125", "--to", "250", "--signal",
                    "top.count=dec", "-o", "ns.svg"})
                .exit_code,
            0);
  EXPECT_EQ(contents("cycles.svg"), contents("ns.svg"));
  EXPECT_NE(contents("ns.svg").find(">3<"), std::string::npos);
  EXPECT_EQ(contents("ns.svg").find(">255<"), std::string::npos);
  EXPECT_EQ(contents("ns.svg").find("clock"), std::string::npos);
}

TEST_F(CommandTest, AnFstFileGivesThePictureOfItsVcdFile) {
  if (!has_program("vcd2fst") || !has_program("fst2vcd"))
    GTEST_SKIP() << "vcd2fst and fst2vcd (Debian package gtkwave) are missing";
  const std::string vcd = put("w.vcd", kWave).string();
  {
    Pipe pipe({"vcd2fst", "-v", vcd, "-f", (folder_ / "w.fst").string()}, Pipe::End::kReads);
    ASSERT_TRUE(pipe.finish());
  }
  for (const char* file : {"w.vcd", "w.fst"}) {
    const Outcome outcome = cigsim({"wave-picture", file, "-o", std::string(file) + ".svg"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  EXPECT_EQ(contents("w.fst.svg"), contents("w.vcd.svg"));
  put("bad.fst", "no wave");
  expect_unusable({"wave-picture", "bad.fst", "-o", "a.svg"}, "bad.fst: fst2vcd cannot read it");
}

TEST_F(CommandTest, WavePictureRefusesWhatItCannotShow) {
  put("w.vcd", kWave);
  put("cut.vcd", std::string(kWave).substr(0, 60));
  put("empty.vcd", "");
  put("other.gtkw", "@28\ntop.clock\ntop.cuont[7:0]\n");
  const std::vector<std::string> before = files();
  expect_unusable({"wave-picture", "w.vcd"}, "--output is required");
  expect_unusable({"wave-picture", "w.vcd", "-o", "w.png"}, "must end in .svg");
  expect_unusable({"wave-picture", "w.txt", "-o", "w.svg"}, "must end in .vcd or .fst");
  expect_unusable({"wave-picture", "absent.vcd", "-o", "w.svg"}, "absent.vcd: no such file");
  expect_unusable({"wave-picture", "cut.vcd", "-o", "w.svg"}, "cut.vcd:3: ends within $var");
  expect_unusable({"wave-picture", "empty.vcd", "-o", "w.svg"}, "empty.vcd: is empty");
  expect_unusable({"wave-picture", "w.vcd", "--view", "other.gtkw", "-o", "w.svg"},
                  "other.gtkw:3: w.vcd: there is no signal 'top.cuont[7:0]'; near it are "
                  "top.count, top.clock");
  expect_unusable({"wave-picture", "w.vcd", "--signal", "clokc", "-o", "w.svg"},
                  "near it are top.clock");
  expect_unusable({"wave-picture", "w.vcd", "--signal", "clock=roman", "-o", "w.svg"},
                  "choose from bin, oct, hex");
  expect_unusable({"wave-picture", "w.vcd", "--from", "9", "--to", "9", "-o", "w.svg"}, "--to");
  expect_unusable({"wave-picture", "w.vcd", "--from", "400", "-o", "w.svg"}, "w.vcd: ends at 375");
  EXPECT_EQ(files(), before);
}

}  // namespace
}  // namespace cigsim
