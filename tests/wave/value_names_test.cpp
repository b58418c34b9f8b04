// SPDX-License-Identifier: MIT
#include "sim/wave/value_names.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "firmware/assembler/listing.hpp"
#include "firmware/programs.hpp"
#include "sim/wave/embedded_views.hpp"
#include "sim/wave/saved_view.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

std::string source(const std::string& path) {
  return test::bytes_of(std::string(CIGSIM_SOURCE_DIR) + "/" + path);
}

ValueNames names_in(const std::string& file) {
  return ValueNames::parse(source("waves/" + file), file);
}

TEST(ValueNames, AValueIsShownByItsName) {
  const ValueNames names =
      ValueNames::parse("# comment\n0 Idle\n  1\tGo on  \r\n\n2A Far away", "f.names");
  EXPECT_EQ(names.size(), 3u);
  EXPECT_EQ(names.of("0"), "Idle");
  EXPECT_EQ(names.of("1"), "Go on");
  EXPECT_EQ(names.of("2a"), "Far away");
  EXPECT_EQ(names.of("3"), "3");
  EXPECT_EQ(names.of("x"), "x");
  EXPECT_EQ(test::message_of([] { ValueNames::parse("0 Idle\n1\n", "f.names"); }),
            "f.names:2: the value '1' has no name");
}

// Lines as GTKWave 3.3 writes them: a filter counts where the flags tell so.
TEST(ValueNames, AViewTellsWhoseNamesItShows) {
  const std::vector<ViewRow> rows = parse_saved_view(
      "@2024\n^1 a.names\ntop.a[3:0]\n^2 b c.names\n+{b} top.b[3:0]\n@24\ntop.c[3:0]\n"
      "@2022\n^>1 program\ntop.d[3:0]\n^0\ntop.e[3:0]\n",
      "v.gtkw");
  std::vector<std::string> names;
  for (const ViewRow& row : rows) names.push_back(row.names);
  EXPECT_EQ(names, (std::vector<std::string>{"a.names", "b c.names", "", "b c.names", ""}));
  EXPECT_EQ(rows[0].radix, Radix::kDecimal);
}

TEST(ValueNames, MicroaddressesAreThoseOfTheMicroprograms) {
  for (const std::string& stage : firmware::microcoded_stages()) {
    SCOPED_TRACE("cigsim assemble " + stage + " --names waves/" + stage + ".microprogram.names");
    const firmware::Program program = firmware::stage_program(stage);
    EXPECT_EQ(source("waves/" + stage + ".microprogram.names"), firmware::address_names(program));
    const ValueNames names = names_in(stage + ".microprogram.names");
    EXPECT_EQ(names.size(), program.words.size());
    for (const auto& [label, address] : program.labels)
      EXPECT_EQ(names.of(std::to_string(address)).find('+'), std::string::npos) << label;
  }
}

/// Every constant `Name = 3'd2` of the text has its name in the file.
void expect_constants(const std::string& text, const std::string& file) {
  const ValueNames names = names_in(file);
  const std::regex constant("([A-Za-z]+) = [0-9]+'d([0-9]+)");
  std::size_t found = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), constant), end; at != end; ++at, ++found) {
    std::string expected = (*at)[1], got = names.of((*at)[2]);
    for (std::string* name : {&expected, &got})
      for (char& c : *name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    EXPECT_EQ(got, expected);
  }
  EXPECT_GT(found, 3u);
}

TEST(ValueNames, StatesAndInstructionsAreThoseOfTheRtl) {
  const auto part = [](const std::string& file, const std::string& first, const std::string& end) {
    const std::string text = source(file);
    const std::size_t begin = text.find(first);
    EXPECT_NE(begin, std::string::npos) << first;
    return text.substr(begin, text.find(end, begin) - begin);
  };
  expect_constants(part("rtl/common/microsequencer.sv", "Jz = ", "logic [11:0]"),
                   "microsequencer.op.names");
  expect_constants(part("rtl/edge_orderer/edge_orderer.sv", "Idle = ", ";"),
                   "edge_orderer.fill.names");
}

TEST(ValueNames, EveryViewHasTheNamesThatItShows) {
  std::size_t named = 0;
  for (const EmbeddedFile& file : embedded_views()) {
    if (!file.path.ends_with(".gtkw")) continue;
    for (const ViewRow& row : parse_saved_view(file.text, std::string(file.path)))
      if (!row.names.empty()) {
        EXPECT_GT(ValueNames::parse(embedded_text(embedded_views(), row.names), row.names).size(),
                  0u);
        ++named;
      }
  }
  EXPECT_GE(named, 6u);
}

}  // namespace
}  // namespace cigsim
