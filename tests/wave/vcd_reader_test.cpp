// SPDX-License-Identifier: MIT
#include "sim/wave/vcd_reader.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

using Changes = std::vector<WaveChange>;

// In blocks of `block` bytes, so that words lie across their borders.
ByteSource source(const std::string& text, std::size_t block) {
  return [text, block, at = std::size_t{0}](char* out, std::size_t size) mutable {
    const std::size_t count = std::min({size, block, text.size() - at});
    std::memcpy(out, text.data() + at, count);
    at += count;
    return count;
  };
}

Wave read(const std::string& text, const std::vector<std::size_t>& wanted,
          const WaveWindow& window = {}, std::size_t block = 4096) {
  VcdReader reader(source(text, block), "w.vcd");
  return reader.read(wanted, window);
}

std::string error_of(const std::string& text, const WaveWindow& window = {}) {
  return test::message_of([&] { read(text, {}, window); });
}

const std::string kHead =
    "$date today $end\n"
    "$timescale\n 100 ps\n$end\n"
    "$scope module top $end\n"
    "$var wire 1 ! clock $end\n"
    "$scope module unit $end\n"
    "$var reg 4 \" count [3:0] $end\n"
    "$var wire 4 \" same [3:0] $end\n"
    "$var real 64 % level $end\n"
    "$upscope $end\n"
    "$upscope $end\n"
    "$enddefinitions $end\n";
const std::string kBody =
    "#0\n$dumpvars\n0!\nbx \"\nr0.5 %\n$end\n"
    "#10\n1!\nb0 \"\n"
    "#20\n0!\nb1 \"\n"
    "#30\n1!\nb1010 \"\nb1100 \"\nr2.5 %\n"
    "#40\n$comment nothing 1! happens $end\n0!\nbz1 \"\n";

TEST(VcdReader, DeclarationsKeepScopesRangesAndKinds) {
  VcdReader reader(source(kHead, 4096), "w.vcd");
  EXPECT_EQ(reader.signals(), (std::vector<WaveSignal>{{"top.clock", "", 1, false},
                                                       {"top.unit.count", "[3:0]", 4, false},
                                                       {"top.unit.same", "[3:0]", 4, false},
                                                       {"top.unit.level", "", 64, true}}));
}

TEST(VcdReader, EverySignalHasItsChangesWhateverTheBlocks) {
  for (const std::size_t block : {1, 2, 3, 7, 4096}) {
    const Wave wave = read(kHead + kBody, {0, 1, 2, 3}, {}, block);
    EXPECT_DOUBLE_EQ(wave.unit_ns, 0.1);
    EXPECT_EQ(wave.first, 0u);
    EXPECT_EQ(wave.last, 40u);
    EXPECT_EQ(wave.traces[0].changes,
              (Changes{{0, "0"}, {10, "1"}, {20, "0"}, {30, "1"}, {40, "0"}}));
    const Changes count{{0, "xxxx"}, {10, "0000"}, {20, "0001"}, {30, "1100"}, {40, "zzz1"}};
    EXPECT_EQ(wave.traces[1].changes, count) << "filled up with 0, x or z; the last of a time";
    EXPECT_EQ(wave.traces[2].changes, count) << "of the same code";
    EXPECT_EQ(wave.traces[3].changes, (Changes{{0, "0.5"}, {30, "2.5"}}));
  }
}

TEST(VcdReader, AWindowBeginsWithTheValueFromBefore) {
  const Wave wave = read(kHead + kBody, {1}, {1.5, 3.2});
  EXPECT_EQ(wave.first, 15u);
  EXPECT_EQ(wave.last, 32u);
  EXPECT_EQ(wave.traces[0].changes, (Changes{{15, "0000"}, {20, "0001"}, {30, "1100"}}));
}

TEST(VcdReader, NothingIsReadBehindTheWindow) {
  const Wave wave = read(kHead + kBody + "this is no wave", {0}, {0.0, 3.0});
  EXPECT_EQ(wave.last, 30u);
  EXPECT_EQ(wave.traces[0].changes.size(), 4u);
}

TEST(VcdReader, ValuesAheadOfTheFirstTimeCountFromThere) {
  const Wave wave = read(kHead + "$dumpvars\n1!\nb11 \"\n$end\n#500\n0!\n#600\n", {0, 1});
  EXPECT_EQ(wave.first, 500u);
  EXPECT_EQ(wave.traces[0].changes, (Changes{{500, "0"}}));
  EXPECT_EQ(wave.traces[1].changes, (Changes{{500, "0011"}}));
}

TEST(VcdReader, ARandomWalkIsReadBack) {
  const unsigned seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::string body;
  Changes expected;
  std::string last = "xxxx";
  for (WaveTime t = 0; t < 2000; t += 1 + random() % 5) {
    body += fmt::format("#{}\n", t);
    std::string value;
    for (int i = 0; i < 4; ++i) value += "01"[random() % 2];
    if (random() % 3 == 0) continue;
    body += fmt::format("b{} \"\n", value);
    if (value != last) expected.push_back({t, value});
    last = value;
  }
  EXPECT_EQ(read(kHead + body, {1}, {}, 11).traces[0].changes, expected);
}

TEST(VcdReader, DamageIsToldWithItsLine) {
  EXPECT_EQ(error_of("$scope module top $end\n$var wire"),
            "w.vcd:2: ends within $var; it is cut short");
  EXPECT_EQ(error_of("$timescale 1 ns $end\n"),
            "w.vcd:2: ends within its declarations; it is cut short");
  EXPECT_EQ(error_of("hello\n"),
            "w.vcd:1: 'hello' stands among the declarations; is this a VCD file?");
  EXPECT_EQ(error_of("$timescale 3 ns $end\n$enddefinitions $end\n"),
            "w.vcd:1: $timescale: '3ns' must be 1, 10 or 100 of s, ms, us, ns, ps or fs");
  EXPECT_EQ(error_of("$enddefinitions $end\n#0\n"), "w.vcd:1: has no $timescale");
  EXPECT_EQ(error_of("$upscope $end\n"), "w.vcd:1: $upscope: no scope is open");
  EXPECT_EQ(error_of("$var wire many ! a $end\n"),
            "w.vcd:1: $var: 'many' is no width from 0 to 65536");
  EXPECT_EQ(error_of("$var wire 1 ! a $end\n$var wire 2 ! b $end\n"),
            "w.vcd:2: $var: b shares the code '!' with a, which has another width");
  EXPECT_EQ(error_of(kHead), "w.vcd:14: has no times after its declarations; it is cut short");
  EXPECT_EQ(error_of(kHead + "#0\n1?\n"),
            "w.vcd:15: a value for the code '?', which no declaration has");
  EXPECT_EQ(error_of(kHead + "#0\nb1"), "w.vcd:15: ends within a value; it is cut short");
  EXPECT_EQ(error_of(kHead + "#0\n1"),
            "w.vcd:15: '1' has no code of a signal; the file is cut short");
  EXPECT_EQ(error_of(kHead + "#0\nb10101 \"\n"),
            "w.vcd:15: a value of 5 bits for top.unit.count, which has 4");
  EXPECT_EQ(error_of(kHead + "#0\nb12 \"\n"), "w.vcd:15: 'b12' is no binary value");
  EXPECT_EQ(error_of(kHead + "#0\n1\"\n"),
            "w.vcd:15: '1\"' is a value of one bit, but top.unit.count has 4");
  EXPECT_EQ(error_of(kHead + "#9\n#8\n"), "w.vcd:15: time goes back from 9 to 8");
  EXPECT_EQ(error_of(kHead + "#1x\n"),
            "w.vcd:14: '#1x' is no time; times are whole numbers after #");
  EXPECT_EQ(error_of(kHead + "#0\n?\n"), "w.vcd:15: '?' is neither a time nor a value");
}

// Read, or refused in one line, but never anything else.
TEST(VcdReader, NoDamageIsTooMuch) {
  const unsigned seed = 11;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::string whole = kHead + kBody;
  std::size_t refused = 0;
  for (int i = 0; i < 5000; ++i) {
    std::string text = whole.substr(0, 1 + random() % whole.size());
    for (int k = random() % 4; k > 0; --k)
      text[random() % text.size()] = "$#b01xz!\"% \n[]"[random() % 14];
    try {
      read(text, {}, {});
    } catch (const InputError& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).rfind("w.vcd:", 0), 0u);
    }
  }
  EXPECT_GT(refused, 1000u);
}

TEST(VcdReader, AWindowWithoutWavesIsRefused) {
  EXPECT_EQ(error_of(kHead + kBody, {5.0, 6.0}), "w.vcd: ends at 4 ns, before the window");
  EXPECT_EQ(error_of(kHead + "#100\n1!\n", {1.0, 2.0}), "w.vcd: begins at 10 ns, after the window");
}

}  // namespace
}  // namespace cigsim
