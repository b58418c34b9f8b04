// SPDX-License-Identifier: MIT
// The assembler against words, costs and messages worked out by hand.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "firmware/assembler/listing.hpp"
#include "firmware/assembler/program.hpp"
#include "firmware/programs.hpp"
#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"

namespace cigsim::firmware {
namespace {

// op 0..3, pol 4, d 5, address 6..17, cond 18..20, a 21..28, wide 29..60, b 64..71 (it would have
// lain across bit 64).
constexpr const char* kFormat =
    "format toy ; a comment\n"
    "sequencer\n"
    "field cond 3\n"
    "  TRUE 0\n"
    "  READY 5\n"
    "field a 8 default 0x0f\n"
    "  ALL 255\n"
    "field wide 32\n"
    "field b 8\n";

Program assembled(std::string_view source, const Overrides& overrides = {}) {
  return assemble(parse_format("toy.fmt", kFormat), "toy.mas", source, overrides);
}

std::string message(std::string_view source, const Overrides& overrides = {}) {
  try {
    assembled(source, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string format_message(std::string_view text) {
  try {
    parse_format("toy.fmt", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Format, FieldsLieSideBySideAndNotAcrossBit64) {
  const Format format = parse_format("toy.fmt", kFormat);
  EXPECT_EQ(format.name, "toy");
  EXPECT_EQ(format.width, 72u);
  EXPECT_EQ(format.place("address").first, 6u);
  EXPECT_EQ(format.place("wide").first, 29u);
  EXPECT_EQ(format.place("b").first, 64u);
  EXPECT_EQ(format.value("cond", "READY"), 5u);
  EXPECT_EQ(format.value("op", "RPCT"), 9u);
  EXPECT_THROW(format.place("c"), std::invalid_argument);
  EXPECT_THROW(format.value("cond", "BUSY"), std::invalid_argument);
}

TEST(Format, MessagesNameTheLineAndWhatToDo) {
  const std::string head = "format f\nsequencer\nfield cond 2\nTRUE 0\n";
  const auto has = [&](const std::string& rest, const std::string& expected) {
    EXPECT_NE(format_message(head + rest).find(expected), std::string::npos)
        << format_message(head + rest);
  };
  has("field x 33\n", "toy.fmt:5: a field has 1 to 32 bits");
  has("field x 4\nV 16\n", "toy.fmt:6: 16 does not fit into the 4 bits of field 'x'");
  has("field cond 2\n", "toy.fmt:5: field 'cond' is there already");
  has("field x 4\nV 1\nV 2\n", "toy.fmt:7: field 'x' has a value 'V' already");
  has("field x 32\nfield y 32\nfield z 32\nfield w 32\n", "toy.fmt:8: field 'w' does not fit into");
  has("hello\n", "toy.fmt:5: 'hello' is not understood");
  has("field x 2 default -1\n", "toy.fmt:5: '-1' is no whole number");
  EXPECT_NE(format_message("sequencer\n").find("begin it with 'format NAME'"), std::string::npos);
  EXPECT_NE(format_message("format f\nsequencer\nfield cond 2\nA 0\n").find("'TRUE 0'"),
            std::string::npos);
}

TEST(Assembler, MakesTheWordsOfTheFormat) {
  const Program program = assembled(
      ".define N 3\n"
      "start: nop\n"
      "\n"
      "again: a=ALL, b=N*2+1 wide=0xffffffff ; all\n"
      "last:\n"
      "  RPCT again unless READY a=-1\n"
      "  CJP .+1 if READY\n"
      "  op=LDCT address=start+N-1 d=DATA\n");
  constexpr std::uint64_t kA = 0x0f << 21, kCont = 14;
  ASSERT_EQ(program.words.size(), 5u);
  EXPECT_EQ(program.words[0], (Microword{kCont | kA, 0}));
  EXPECT_EQ(program.words[1], (Microword{kCont | 0xffull << 21 | 0xffffffffull << 29, 7}));
  EXPECT_EQ(program.words[2], (Microword{9 | 1 << 4 | 1 << 6 | 5 << 18 | 0xffull << 21, 0}));
  EXPECT_EQ(program.words[3], (Microword{3 | 4 << 6 | 5 << 18 | kA, 0}));
  EXPECT_EQ(program.words[4], (Microword{12 | 1 << 5 | 2 << 6 | kA, 0}));
  EXPECT_EQ(program.address("last"), 2u);
  EXPECT_EQ(hex_image(program).substr(0, 19), "000000000001e0000e\n");
  EXPECT_EQ(program.format.place("wide").get(program.words[1]), 0xffffffffu);
}

TEST(Assembler, CallersGiveConstantsOtherValues) {
  const char* source = ".define N 3\n.define M N+1\nnop a=N b=M\n";
  const Program plain = assembled(source);
  EXPECT_EQ(plain.format.place("a").get(plain.words[0]), 3u);
  const Program other = assembled(source, {{"N", 9}});
  EXPECT_EQ(other.format.place("a").get(other.words[0]), 9u);
  EXPECT_EQ(other.format.place("b").get(other.words[0]), 10u);
  EXPECT_NE(message(source, {{"K", 1}}).find("'.define K'"), std::string::npos);
}

TEST(Assembler, MessagesNameTheLineAndWhatToDo) {
  const auto has = [](const std::string& source, const std::string& expected) {
    EXPECT_NE(message(source).find(expected), std::string::npos) << message(source);
  };
  has("nop\nc=1\n", "toy.mas:2: there is no field 'c'");
  has("a=256\n", "toy.mas:1: '256' is 256, which does not fit into the 8 bits of field 'a'");
  has("a=-129\n", "does not fit");
  has("a=1 a=1\n", "toy.mas:1: field 'a' is set twice");
  has("CJP 1 address=2\n", "field 'address' is set twice");
  has("x: nop\nx: nop\n", "toy.mas:2: 'x' is defined twice");
  has(".define x 1\nx: nop\n", "toy.mas:2: 'x' is defined twice");
  has("CJP away\n", "'away' is no value of field 'address', constant or label");
  has("GOTO 1\n", "'GOTO' is not understood");
  has(".org 3\n", "'.org' is no directive");
  has("CJP 0 if\n", "a condition is missing");
  has("a=1/0\n", "divides by zero");
  has("a=1++\n", "is no number");
  has("a=99999999999\n", "is beyond 32 bits");
  has(".define x y\n", "toy.mas:1: 'y' is not defined above");
  has(".define x\n", "'.define NAME EXPRESSION'");
  has("1x: nop\n", "'1x' is no name");
  std::string long_program;
  for (int i = 0; i < 4096; ++i) long_program += "nop\n";
  EXPECT_EQ(message(long_program), "no error");
  has(long_program + "nop\n", "toy.mas:4097: the program is longer");
}

TEST(Costs, FollowLoopsOfKnownCountAndSubroutines) {
  const Program program = assembled(
      ".define STEPS 4\n"
      "a:      LDCT STEPS-1\n"        // 1
      "b:      RPCT .\n"              // 4: it is executed until the counter was 0
      "        CJS sub\n"             // 1
      "        CJP c\n"               // 1
      "        nop\n"                 // not on the path
      "c:      PUSH 2\n"              // 1: counter 2
      "        nop\n"                 // 3
      "        RFCT\n"                // 3
      "d:      CJP . unless READY\n"  // 1 when it passes on at once
      "e:      LDCT d=DATA\n"         // 1
      "f:      RPCT f\n"              // 1 when it leaves at once
      "g:      JZ\n"
      "sub:    LDCT 1\n"      // 1
      "inner:  nop\n"         // 2
      "        RPCT inner\n"  // 2
      "        CRTN\n"        // 1
      ".cost first a b\n"
      ".cost all a d\n"
      ".cost wait d e fail d\n"
      ".cost tail e g fail f\n"
      ".cost sub sub inner\n");
  EXPECT_EQ(program.cost("first"), 1);
  EXPECT_EQ(program.cost("all"), 1 + 4 + 1 + (1 + 2 + 2 + 1) + 1 + 1 + 3 + 3);
  EXPECT_EQ(program.cost("wait"), 1);
  EXPECT_EQ(program.cost("tail"), 2);
  EXPECT_EQ(program.cost("sub"), 1);
  EXPECT_THROW(program.cost("none"), std::invalid_argument);
}

TEST(Costs, RefuseWhatDependsOnData) {
  const auto has = [](const std::string& source, const std::string& expected) {
    EXPECT_NE(message(source).find(expected), std::string::npos) << message(source);
  };
  has("a: CJP b if READY\nnop\nb: nop\n.cost x a b\n",
      "toy.mas:4: the path 'x' depends on data at address 0 (line 1)");
  has("a: LDCT 3 d=DATA\nl: RPCT l\nb: nop\n.cost x a b\n",
      "loops as often as data say at address 1");
  has("a: CRTN\nb: nop\n.cost x a b\n", "returns beyond its beginning");
  has("a: CJP a\nb: nop\n.cost x a b\n", "does not reach its end");
  has("a: CJP b d=DATA\nb: nop\n.cost x a b\n", "goes where data say");
  has("a: JMAP\nb: nop\n.cost x a b\n", "goes where data say");
  has("b: nop\na: nop\n.cost x a b\n", "leaves the program");
  has("a: nop\nb: nop\n.cost x a c\n", "there is no label 'c'");
  has("a: nop\nb: nop\n.cost x a b a\n", "'pass' or 'fail' is missing before 'a'");
  has("a: nop\nb: nop\n.cost x a b\n.cost x a b\n", "cost 'x' is there already");
  has(".cost x a\n", "'.cost NAME FROM TO");
}

TEST(Listing, ShowsAddressWordLabelSourceAndCosts) {
  const std::string text = listing(assembled("a: nop\nb: CJP a ; back\n.cost x a b\n"));
  EXPECT_NE(text.find("2 words of 72 bits"), std::string::npos) << text;
  EXPECT_NE(text.find("b:\n001  000000000001e00003     2  b: CJP a ; back\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("cost x = 1 cycles"), std::string::npos) << text;
}

TEST(Programs, OfTheStagesAssemble) {
  for (const std::string& stage : microcoded_stages())
    EXPECT_GT(stage_program(stage).words.size(), 0u) << stage;
  EXPECT_THROW(stage_program("painter"), std::invalid_argument);
}

// The manual's tables of costs: "| `name`, `other` | cycles | … |".
TEST(Programs, CostTheCyclesThatTheManualSays) {
  for (const std::string stage : {"priority_processor"}) {
    SCOPED_TRACE(stage);
    const Program program = stage_program(stage);
    std::map<std::string, Cycle, std::less<>> manual;
    std::istringstream page(
        read_whole_file(std::string(CIGSIM_SOURCE_DIR "/docs/machine/") + stage + ".md"));
    const std::regex row(R"(\| ((?:`\w+`(?:, )?)+) \| (\d+) \|.*)"), name(R"(`(\w+)`)");
    std::smatch match;
    for (std::string line; std::getline(page, line);) {
      if (!std::regex_match(line, match, row)) continue;
      const std::string names = match[1];
      for (std::sregex_iterator n(names.begin(), names.end(), name), end; n != end; ++n)
        manual[(*n)[1]] = std::stol(match[2]);
    }
    EXPECT_EQ(manual, program.costs);
  }
}

}  // namespace
}  // namespace cigsim::firmware
