// SPDX-License-Identifier: MIT
// The golden model of the SO matrix against the matrix told plane by plane.
#include "models/priority_processor/so_golden.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/priority_processor/so_matrix.hpp"
#include "sim/cosim/so_cases.hpp"
#include "tests/rtl/so_specification.hpp"

namespace cigsim {
namespace {

using cosim::SoKind;
using priority_processor::SoAnswers;
using priority_processor::SoBits;
using priority_processor::SoGolden;
using priority_processor::SoRow;

std::string text(const SoAnswers& answers, const SoBits& active, unsigned objects, unsigned l) {
  std::string row(objects, '.');
  for (unsigned m = 0; m < objects; ++m) {
    if (m == l || !bit_of(active, l) || !bit_of(active, m)) continue;
    row[m] = bit_of(answers.hides, m)        ? '+'
             : bit_of(answers.hidden, m)     ? '-'
             : bit_of(answers.unresolved, m) ? '?'
                                             : '0';
  }
  return row;
}

TEST(SoGolden, LevinesWorkedExample) {
  const SignRows sepl{"0++-", "-+--", "++--", "-+-+", "--0-"};
  SoGolden golden(5, 4);
  for (unsigned o = 0; o < 5; ++o) golden.set_row(o, row_of(sepl[o]));
  golden.mark(bits_of("---+"), SoBits{31});
  const char* const expected[] = {".----", "+.+--", "+-.--", "+++.0", "+++0."};
  for (unsigned l = 0; l < 5; ++l)
    EXPECT_EQ(text(golden.row(l), SoBits{31}, 5, l), expected[l]) << "object " << l + 1;
}

TEST(SoGolden, MatrixToldPlaneByPlane) {
  const std::uint64_t seed = 20260904;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  Random random(seed);
  const std::pair<unsigned, unsigned> sizes[] = {{1, 1},   {2, 1},   {3, 3},     {5, 4},
                                                 {16, 9},  {64, 64}, {63, 65},   {65, 63},
                                                 {7, 200}, {130, 5}, {193, 129}, {256, 256}};
  for (const auto& [objects, planes] : sizes) {
    SoGolden golden(objects, planes);
    SoBits eye{};
    for (unsigned k = 0; k < static_cast<unsigned>(SoKind::kCount); ++k) {
      SCOPED_TRACE(testing::Message() << objects << " x " << planes << ", kind " << k);
      const auto rows = cosim::random_so_rows(random, static_cast<SoKind>(k), objects, planes);
      const SignRows sepl = signs_of(rows, planes);
      for (unsigned o = 0; o < objects; ++o) golden.set_row(o, rows[o]);
      for (int n = objects > 100 ? 1 : 8; n > 0; --n) {
        eye = cosim::random_so_eye(random, planes, eye);
        const SoBits active = cosim::random_so_active(random, objects);
        golden.mark(eye, active);
        std::vector<bool> is_active(objects);
        for (unsigned o = 0; o < objects; ++o) is_active[o] = bit_of(active, o);
        const std::string signs = signs_of(eye, planes);
        for (unsigned l = 0; l < objects; ++l) {
          const SoAnswers& answers = golden.row(l);
          const std::string expected = so_row_of(sepl, signs, is_active, l);
          ASSERT_EQ(text(answers, active, objects, l), expected) << "row " << l;
          ASSERT_EQ(answers.count, std::count(expected.begin(), expected.end(), '-'));
        }
      }
    }
  }
}

TEST(SoGolden, NothingIsToldBeyondTheSizeOrOfInactiveObjects) {
  SoGolden golden(10, 7);
  SoRow all;
  all.tells.fill(~std::uint64_t{0});
  for (unsigned o = 0; o < 10; ++o) golden.set_row(o, all);
  golden.mark({}, SoBits{0b1011});
  EXPECT_EQ(golden.row(0).unresolved, SoBits{0b1010});
  EXPECT_EQ(golden.row(2).unresolved, SoBits{});
  EXPECT_EQ(golden.row(0).hides, SoBits{});
  EXPECT_EQ(golden.row(0).hidden, SoBits{});
}

TEST(SoGolden, AgreesWithTheWordsOfThePriorityProcessor) {
  const std::uint64_t seed = 77;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  Random random(seed);
  SoGolden golden(64, 64);
  SoBits eye{};
  for (unsigned k = 0; k < static_cast<unsigned>(SoKind::kCount); ++k) {
    const auto rows = cosim::random_so_rows(random, static_cast<SoKind>(k), 64, 64);
    for (unsigned o = 0; o < 64; ++o) golden.set_row(o, rows[o]);
    eye = cosim::random_so_eye(random, 64, eye);
    golden.mark(eye, SoBits{~std::uint64_t{0}});
    const auto marked = [&](const SoRow& row) {
      return priority_processor::SeplRow{.r = row.tells[0] & ~(row.plus[0] ^ eye[0]),
                                         .s = row.tells[0]};
    };
    for (unsigned l = 0; l < 64; ++l) {
      const SoAnswers& answers = golden.row(l);
      for (unsigned m = 0; m < 64; ++m) {
        if (l == m) continue;
        using priority_processor::Separation;
        const Separation so = separating_object(marked(rows[l]), marked(rows[m]));
        ASSERT_EQ(bit_of(answers.hides, m), so == Separation::kHides);
        ASSERT_EQ(bit_of(answers.hidden, m), so == Separation::kHidden);
        ASSERT_EQ(bit_of(answers.unresolved, m), so == Separation::kUnresolved);
      }
    }
  }
}

}  // namespace
}  // namespace cigsim
