// SPDX-License-Identifier: MIT
// Foreign dumps in a file of ours, held to what the reader finds there. The dumps are made by hand.
#include "sim/wave/rtl_part.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "sim/wave/vcd_reader.hpp"
#include "sim/wave/vcd_writer.hpp"

namespace cigsim {
namespace {

using Changes = std::vector<WaveChange>;

constexpr const char* kDeclarations =
    "$version a program $end\n$date $end $comment $var is no declaration here $end\n"
    "$timescale 1ps $end\n"
    " $scope module rtl $end\n"
    "  $var wire  1 # clk_i $end\n  $var wire  4 ~ word_o [3:0] $end\n"
    "  $scope module counter $end\n"
    "   $var wire  1 # clk_i $end\n   $var wire  4 ~ word_o [3:0] $end\n"
    "   $var wire 70 ! wide_q [69:0] $end\n   $var real 64 r share $end\n"
    "   $scope module row[1] $end $var wire 8 ~! memory_q[12] [7:0] $end\n"
    "    $var wire 1 1 flag $end $var wire 1 # clk_i $end $upscope $end\n"
    "  $upscope $end\n $upscope $end\n$enddefinitions $end\n";

/// Gives a text a sample, and the declarations in two pieces.
class Script : public WavePart {
 public:
  Script(std::vector<std::string> texts, int& closed, std::string declarations = kDeclarations)
      : texts_(std::move(texts)), declarations_(std::move(declarations)), closed_(closed) {}
  void open(RtlModel::WriteWave write) override {
    write_ = std::move(write);
    const std::string_view text = declarations_;
    write_(text.substr(0, text.size() / 2));
    write_(text.substr(text.size() / 2));
  }
  void sample(Cycle n) override {
    const std::string_view text = texts_.at(static_cast<std::size_t>(n));
    write_(text.substr(0, text.size() / 3));
    write_(text.substr(text.size() / 3));
  }
  void close() override {
    ++closed_;
    write_("$comment the end $end\n");
  }

 private:
  std::vector<std::string> texts_;
  std::string declarations_;
  int& closed_;
  RtlModel::WriteWave write_;
};

struct Read {
  std::vector<WaveSignal> signals;
  Wave wave;
  const Changes& changes(const std::string& name) const {
    for (std::size_t i = 0; i < signals.size(); ++i)
      if (signals[i].name == name) return wave.traces[i].changes;
    throw std::out_of_range(name);
  }
};

Read read(const std::string& text) {
  VcdReader reader(
      [&text, at = std::size_t{0}](char* block, std::size_t size) mutable {
        const std::size_t count = text.copy(block, size, at);
        at += count;
        return count;
      },
      "dump");
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < reader.signals().size(); ++i) all.push_back(i);
  return {reader.signals(), reader.read(all, {})};
}

const std::vector<std::string> kSamples{
    "#0\n$dumpvars\n0#\nbxxxx ~\nb1 !\nr0.25 r\nb0 ~!\nx1\n$end\n",
    "#10 $comment b1111 ~ is no value here $end\nb10z1 ~\nz1\n1#\n", "",
    "#30\nb1"
    "0000000000"
    "0000000000"
    "0000000000"
    "0000000000"
    "0000000000"
    "0000000000"
    "000000001 !\nR-1e-3 r\nb10100101 ~!\n11\n"};

TEST(RtlPart, ItsSignalsStandBelowTheStageAndKeepTheirValues) {
  int closed = 0;
  const std::uint16_t count = 7;
  std::ostringstream out;
  VcdWriter writer(out, 2, "machine.clock");
  writer.trace(count, "machine.stage.count", 4);
  writer.add_part("machine.stage.rtl", std::make_unique<Script>(kSamples, closed));
  writer.declare();
  for (Cycle n = 0; n < 4; ++n) writer.sample(n);
  EXPECT_EQ(closed, 0);
  writer.end(4);
  EXPECT_EQ(closed, 1);

  const Read got = read(out.str());
  EXPECT_EQ(got.signals,
            (std::vector<WaveSignal>{{"machine.clock", "", 1, false},
                                     {"machine.stage.count", "[3:0]", 4, false},
                                     {"machine.stage.rtl.clk_i", "", 1, false},
                                     {"machine.stage.rtl.word_o", "[3:0]", 4, false},
                                     {"machine.stage.rtl.wide_q", "[69:0]", 70, false},
                                     {"machine.stage.rtl.share", "", 64, true},
                                     {"machine.stage.rtl.row[1].memory_q[12]", "[7:0]", 8, false},
                                     {"machine.stage.rtl.row[1].flag", "", 1, false},
                                     {"machine.stage.rtl.row[1].clk_i", "", 1, false}}));
  const Changes clock{{0, "1"}, {1, "0"}, {2, "1"}, {3, "0"},
                      {4, "1"}, {5, "0"}, {6, "1"}, {7, "0"}};
  EXPECT_EQ(got.changes("machine.clock"), clock);
  EXPECT_EQ(got.changes("machine.stage.rtl.clk_i"), clock);
  EXPECT_EQ(got.changes("machine.stage.rtl.row[1].clk_i"), clock);
  EXPECT_EQ(got.changes("machine.stage.count"), (Changes{{0, "0111"}}));
  EXPECT_EQ(got.changes("machine.stage.rtl.word_o"), (Changes{{0, "xxxx"}, {2, "10z1"}}));
  const std::string zeros(68, '0');
  EXPECT_EQ(got.changes("machine.stage.rtl.wide_q"),
            (Changes{{0, "0" + zeros + "1"}, {6, "1" + zeros + "1"}}));
  EXPECT_EQ(got.changes("machine.stage.rtl.share"), (Changes{{0, "0.25"}, {6, "-1e-3"}}));
  EXPECT_EQ(got.changes("machine.stage.rtl.row[1].memory_q[12]"),
            (Changes{{0, "00000000"}, {6, "10100101"}}));
  EXPECT_EQ(got.changes("machine.stage.rtl.row[1].flag"), (Changes{{0, "x"}, {2, "z"}, {6, "1"}}));
}

// Own codes run through all characters, and both parts have the same ones.
TEST(RtlPart, CodesOfManySignalsAndOfSeveralPartsDiffer) {
  int closed = 0;
  std::vector<std::uint32_t> values(20'000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint32_t>(i);
  std::ostringstream out;
  VcdWriter writer(out, 125, "clock");
  for (std::size_t i = 0; i < values.size(); ++i)
    writer.trace(values[i], "values.v" + std::to_string(i), 32);
  const std::vector<std::string> others{"b1 ~\nb10 !\nr1 r\nb11 ~!\n01\n"};
  writer.add_part("a.rtl", std::make_unique<Script>(kSamples, closed));
  writer.add_part("b.rtl", std::make_unique<Script>(others, closed));
  writer.declare();
  writer.sample(0);
  writer.end(1);
  EXPECT_EQ(closed, 2);

  const Read got = read(out.str());
  const std::string zeros(24, '0');
  for (std::size_t i = 0; i < got.signals.size(); ++i) {
    if (!got.signals[i].name.starts_with("values.v")) continue;
    std::uint32_t value = 0;
    for (const char digit : got.wave.traces[i].changes.at(0).value)
      value = 2 * value + (digit == '1' ? 1 : 0);
    ASSERT_EQ("values.v" + std::to_string(value), got.signals[i].name);
  }
  EXPECT_EQ(got.changes("a.rtl.word_o").at(0).value, "xxxx");
  EXPECT_EQ(got.changes("b.rtl.word_o").at(0).value, "0001");
  EXPECT_EQ(got.changes("a.rtl.row[1].flag").at(0).value, "x");
  EXPECT_EQ(got.changes("b.rtl.row[1].flag").at(0).value, "0");
}

TEST(RtlPart, AWindowThatIsNeverReachedClosesThePart) {
  int closed = 0;
  std::ostringstream out;
  VcdWriter writer(out, 125, "clock");
  writer.add_part("a.rtl", std::make_unique<Script>(kSamples, closed));
  writer.declare();
  writer.end(5);
  EXPECT_EQ(closed, 1);
}

TEST(RtlPart, DamagedDumpsAreErrors) {
  int closed = 0;
  for (const char* text :
       {"", "$scope module rtl $end", "$scope rtl $end $enddefinitions $end",
        "$upscope $end $enddefinitions $end", "$var wire 1 # $end $enddefinitions $end"}) {
    SCOPED_TRACE(text);
    RtlPart part("a.rtl", "~", std::make_unique<Script>(kSamples, closed, text));
    EXPECT_THROW(part.declare("!"), std::runtime_error);
  }
  for (const char* text : {"b101", "1", "q!", "r", "hello !"}) {
    SCOPED_TRACE(text);
    RtlPart part("a.rtl", "~", std::make_unique<Script>(std::vector<std::string>{text}, closed));
    part.declare("!");
    std::ostringstream out;
    EXPECT_THROW(part.sample(0, out), std::runtime_error);
  }
}

}  // namespace
}  // namespace cigsim
