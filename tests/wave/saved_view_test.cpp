// SPDX-License-Identifier: MIT
#include "sim/wave/saved_view.hpp"

#include <gtest/gtest.h>

#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

using Kind = ViewRow::Kind;

std::string error_of(const std::string& text) {
  return test::message_of([&] { parse_saved_view(text, "v.gtkw"); });
}

// Lines as GTKWave 3.3 writes them.
TEST(SavedView, RowsKeepOrderHeadingsLabelsAndRadix) {
  const std::vector<ViewRow> rows = parse_saved_view(
      "[*]\n[dumpfile] \"w.vcd\"\n[timestart] 0\n*-17.0 1250 -1 -1\n"
      "@28\ntop.clock\n"
      "@200\n-Inputs\n"
      "@22\ntop.bus[31:0]\n"
      "@24\n+{number} top.bus[31:0]\n"
      "@420\ntop.difference[7:0]\n"
      "@30\ntop.mode[5:0]\n"
      "@820\ntop.name[63:0]\n"
      "@c00200\n-Group\n@28\ntop.a\n@1401200\n-group_end\n"
      "@200\n-\n",
      "v.gtkw");
  const std::vector<ViewRow> expected{
      {Kind::kSignal, "top.clock", "", Radix::kBinary, 6},
      {Kind::kHeading, "Inputs", "", Radix::kHexadecimal, 8},
      {Kind::kSignal, "top.bus[31:0]", "", Radix::kHexadecimal, 10},
      {Kind::kSignal, "top.bus[31:0]", "number", Radix::kDecimal, 12},
      {Kind::kSignal, "top.difference[7:0]", "", Radix::kSigned, 14},
      {Kind::kSignal, "top.mode[5:0]", "", Radix::kOctal, 16},
      {Kind::kSignal, "top.name[63:0]", "", Radix::kText, 18},
      {Kind::kHeading, "Group", "", Radix::kHexadecimal, 20},
      {Kind::kSignal, "top.a", "", Radix::kBinary, 22},
      {Kind::kBlank, "", "", Radix::kHexadecimal, 26}};
  EXPECT_EQ(rows, expected);
}

TEST(SavedView, WhatCannotBeShownIsToldWithItsLine) {
  EXPECT_EQ(error_of("@28\n#{two} top.a top.b\n"),
            "v.gtkw:2: puts bits together to a signal; name whole signals");
  EXPECT_EQ(error_of("@2g\n"), "v.gtkw:1: '@2g' has no hexadecimal flags");
  EXPECT_EQ(error_of("@28\nnot a view\n"), "v.gtkw:2: 'not a view' is not the name of a signal");
  EXPECT_EQ(error_of("@28\n+{label}\n"),
            "v.gtkw:2: '+{label}' must be +{label} and the name of a signal");
  EXPECT_EQ(error_of("[*] nothing\n"), "v.gtkw: names no signals; save a view with signals in it");
}

}  // namespace
}  // namespace cigsim
