// SPDX-License-Identifier: MIT
// The SO engine in RTL: Levine's example, all states of a small one, random vectors in lock-step,
// and faults on purpose.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "models/boundary/rtl_model.hpp"
#include "rtl/priority_processor/so_engine.pins.hpp"
#include "sim/cosim/so_vectors.hpp"
#include "tests/rtl/so_specification.hpp"

namespace cigsim {
namespace {

using cosim::SoVectorOptions;
using cosim::SoVectorResult;
using priority_processor::SoBits;
using Pins = rtl::so_engine::Pins;

std::string library(unsigned objects, unsigned planes) {
  return std::string(CIGSIM_RTL_LIBRARIES) + "/so_engine-Objects=" + std::to_string(objects) +
         "-Planes=" + std::to_string(planes) + ".so";
}

/// The engine driven by hand; at most 32 objects and planes.
class Engine {
 public:
  Engine(unsigned objects, unsigned planes, std::uint32_t seed = 1)
      : model_(library(objects, planes), sizeof(Pins), seed), pins(model_.pins<Pins>()) {
    pins.rst_i = true;
    edge();
    edge();
    pins.rst_i = false;
  }
  void edge() { model_.edge(); }
  void write(const SignRows& sepl) {
    pins.cfg_last_row_i = static_cast<std::uint32_t>(sepl.size() - 1);
    for (unsigned o = 0; o < sepl.size(); ++o) {
      pins.row_valid_i = true;
      pins.row_index_i = o;
      pins.row_tells_i[0] = static_cast<std::uint32_t>(row_of(sepl[o]).tells[0]);
      pins.row_plus_i[0] = static_cast<std::uint32_t>(row_of(sepl[o]).plus[0]);
      edge();
    }
    pins.row_valid_i = false;
  }
  /// The first row stands on the pins afterwards.
  void start(const std::string& eye, std::uint32_t active) {
    pins.start_valid_i = true;
    pins.start_eye_i[0] = static_cast<std::uint32_t>(bits_of(eye)[0]);
    pins.start_active_i[0] = active;
    EXPECT_TRUE(pins.start_ready_o);
    edge();
    pins.start_valid_i = false;
  }
  /// The row on the pins. '.' for the object itself and wherever one of the two is not active.
  std::string row(unsigned objects, std::uint32_t active) const {
    std::string row(objects, '.');
    const std::uint32_t l = pins.answer_row_o;
    for (unsigned m = 0; m < objects; ++m) {
      const unsigned answers = (pins.answer_hides_o[0] >> m & 1) |
                               (pins.answer_hidden_o[0] >> m & 1) << 1 |
                               (pins.answer_unresolved_o[0] >> m & 1) << 2;
      const bool asked = m != l && (active >> l & 1) && (active >> m & 1);
      if (asked || answers != 0) row[m] = "0+-X?XXX"[answers];
    }
    return row;
  }

 private:
  RtlModel model_;

 public:
  Pins& pins;
};

TEST(SoEngine, LevinesWorkedExampleAllTenPairs) {
  Engine engine(16, 16);
  engine.write({"0++-", "-+--", "++--", "-+-+", "--0-"});
  engine.start("---+", 31);
  const char* const expected[] = {".----", "+.+--", "+-.--", "+++.0", "+++0."};
  const unsigned counts[] = {4, 2, 3, 0, 0};
  for (unsigned l = 0; l < 5; ++l) {
    ASSERT_TRUE(engine.pins.answer_valid_o);
    EXPECT_EQ(engine.pins.answer_row_o, l);
    EXPECT_EQ(engine.row(5, 31), expected[l]) << "object " << l + 1;
    EXPECT_EQ(engine.pins.answer_count_o, counts[l]);
    EXPECT_EQ(engine.pins.answer_last_o, l == 4);
    if (l < 4) engine.edge();
  }
  // Neither of objects 4 and 5 can hide the other: both have count 0, which is no order.
  EXPECT_FALSE(engine.pins.answer_unique_o);
  EXPECT_TRUE(engine.pins.answer_resolved_o);
  engine.edge();
  EXPECT_FALSE(engine.pins.answer_valid_o);
}

TEST(SoEngine, EveryStateOfThreeObjectsAndThreePlanes) {
  constexpr unsigned kStates = 19683;  // 3^9
  Engine engine(3, 3);
  unsigned differing = 0;
  for (unsigned state = 0; state < kStates && differing == 0; ++state) {
    SignRows sepl(3, "000");
    for (unsigned n = 0, rest = state; n < 9; ++n, rest /= 3) sepl[n / 3][n % 3] = "0+-"[rest % 3];
    if (engine.pins.answer_valid_o) engine.edge();
    engine.write(sepl);
    for (unsigned sides = 0; sides < 8; ++sides) {
      std::string eye;
      for (unsigned n = 0; n < 3; ++n) eye += sides >> n & 1 ? '+' : '-';
      for (unsigned active = 0; active < 8; ++active) {
        const std::vector<bool> is_active{(active & 1) != 0, (active & 2) != 0, (active & 4) != 0};
        engine.start(eye, active);
        std::vector<long> counts;
        bool resolved = true;
        for (unsigned l = 0; l < 3; ++l) {
          if (l > 0) engine.edge();
          const std::string expected = so_row_of(sepl, eye, is_active, l);
          const long count = std::count(expected.begin(), expected.end(), '-');
          if (is_active[l]) counts.push_back(count);
          resolved = resolved && expected.find('?') == std::string::npos;
          differing += engine.row(3, active) != expected || engine.pins.answer_row_o != l ||
                       engine.pins.answer_count_o != count;
        }
        std::sort(counts.begin(), counts.end());
        bool unique = true;
        for (std::size_t n = 0; n < counts.size(); ++n)
          unique = unique && counts[n] == static_cast<long>(n);
        differing += engine.pins.answer_unique_o != unique ||
                     engine.pins.answer_resolved_o != resolved || !engine.pins.answer_last_o;
        ASSERT_EQ(differing, 0u) << sepl[0] << ' ' << sepl[1] << ' ' << sepl[2] << ", eye " << eye
                                 << ", active " << active;
      }
    }
  }
}

TEST(SoEngine, ResetEndsWhatIsAnswered) {
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    Engine engine(16, 16, seed);
    EXPECT_FALSE(engine.pins.answer_valid_o);
    engine.write(SignRows(16, std::string(16, '+')));
    engine.start(std::string(16, '-'), 65535);
    for (std::uint32_t row = 1; row < seed; ++row) engine.edge();
    EXPECT_TRUE(engine.pins.answer_valid_o);
    engine.pins.rst_i = true;
    engine.edge();
    engine.pins.rst_i = false;
    EXPECT_FALSE(engine.pins.answer_valid_o);
    EXPECT_TRUE(engine.pins.start_ready_o);
  }
}

// Objects in a row, parted by planes between neighbours: their counts are an order. Without one of
// the planes two of them share a count, whatever came between the two.
TEST(SoEngine, OneCountThatCameTwiceIsFoundAnywhere) {
  constexpr unsigned kObjects = 16;
  const std::uint32_t seed = 41, all = (1u << kObjects) - 1;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  Random random(seed);
  Engine engine(16, 16);
  for (unsigned n = 0; n < 3000; ++n) {
    std::vector<unsigned> place(kObjects);
    for (unsigned o = 0; o < kObjects; ++o) {
      place[o] = o;
      std::swap(place[o], place[random.below(o + 1)]);
    }
    const unsigned missing = random.below(kObjects);  // the last plane parts nobody
    SignRows sepl(kObjects, std::string(kObjects, '0'));
    for (unsigned o = 0; o < kObjects; ++o)
      for (unsigned plane = 0; plane + 1 < kObjects; ++plane)
        if (plane != missing) sepl[o][plane] = place[o] <= plane ? '-' : '+';
    if (engine.pins.answer_valid_o) engine.edge();
    engine.write(sepl);
    engine.start(std::string(kObjects, '+'), all);
    for (unsigned l = 0; l < kObjects; ++l) {
      if (l > 0) engine.edge();
      const unsigned nearer = kObjects - 1 - place[l];
      ASSERT_EQ(engine.pins.answer_count_o, nearer - (place[l] == missing && nearer > 0));
    }
    ASSERT_TRUE(engine.pins.answer_last_o);
    ASSERT_EQ(engine.pins.answer_unique_o, missing == kObjects - 1) << "case " << n;
    ASSERT_EQ(engine.pins.answer_resolved_o, missing == kObjects - 1) << "case " << n;
  }
}

TEST(SoEngine, RowsAreNotWrittenWhileOthersAreAnswered) {
  Engine engine(3, 3);
  engine.write({"+00", "-00", "000"});
  engine.start("+++", 7);
  engine.pins.row_valid_i = true;
  EXPECT_THROW(engine.edge(), std::runtime_error);
}

SoVectorResult run_and_expect_agreement(const SoVectorOptions& options) {
  const SoVectorResult result = run_so_vectors(options);
  std::cout << "seed " << options.seed << ": " << result.vectors << " vectors, " << result.pairs
            << " pairs, " << result.cycles << " cycles, " << result.cycles / result.seconds / 1e6
            << " MHz\n";
  EXPECT_TRUE(result.mismatch || result.vectors >= options.vectors);
  if (result.mismatch)
    ADD_FAILURE() << "vector " << result.mismatch->vector << ", cycle " << result.mismatch->cycle
                  << ", row " << result.mismatch->row << ", " << result.mismatch->field
                  << ": expected " << result.mismatch->expected << ", got " << result.mismatch->got;
  return result;
}

/// CIGSIM_VECTORS=N asks for N vectors instead.
std::uint64_t vectors(std::uint64_t usual) {
  const char* const asked = std::getenv("CIGSIM_VECTORS");
  return asked != nullptr ? std::strtoull(asked, nullptr, 10) : usual;
}

TEST(SoEngine, HundredMillionRandomPairsAgreeWithTheGoldenModel) {
  const SoVectorOptions options{.library = library(64, 64), .vectors = vectors(2'000'000)};
  const SoVectorResult result = run_and_expect_agreement(options);
  if (std::getenv("CIGSIM_VECTORS") == nullptr) {
    EXPECT_GE(result.pairs, 100'000'000u);
  }
}

TEST(SoEngine, OtherSizesAgreeAndRegistersMayBeginWithAnything) {
  for (const std::uint32_t seed : {2u, 3u, 4u}) {
    run_and_expect_agreement({.library = library(16, 16),
                              .objects = 16,
                              .planes = 16,
                              .vectors = vectors(200'000),
                              .seed = seed});
    run_and_expect_agreement({.library = library(3, 3),
                              .objects = 3,
                              .planes = 3,
                              .vectors = vectors(200'000),
                              .seed = seed});
  }
}

TEST(SoEngine, ALargeEngineStandsInForASmallOne) {
  // Objects that are not active and planes that tell of nobody change nothing; the last row is set.
  const SignRows sepl{"0+-", "-+0", "++-"};
  Engine small(3, 3, 5), large(16, 16, 9);
  small.write(sepl);
  large.write(sepl);
  for (const char* eye : {"+++", "-++", "+-+", "---"}) {
    small.start(eye, 7);
    large.start(eye, 7);
    for (unsigned l = 0; l < 3; ++l) {
      EXPECT_EQ(small.row(3, 7), large.row(3, 7));
      EXPECT_EQ(small.pins.answer_last_o, large.pins.answer_last_o);
      EXPECT_EQ(small.pins.answer_unique_o, large.pins.answer_unique_o);
      EXPECT_EQ(small.pins.answer_resolved_o, large.pins.answer_resolved_o);
      small.edge();
      large.edge();
    }
  }
}

TEST(SoEngine, EveryStuckBitIsFound) {
  const std::pair<const char*, unsigned> outputs[] = {
      {"start_ready_o", 1},    {"answer_valid_o", 1},   {"answer_row_o", 4},
      {"answer_hides_o", 16},  {"answer_hidden_o", 16}, {"answer_unresolved_o", 16},
      {"answer_count_o", 4},   {"answer_last_o", 1},    {"answer_unique_o", 1},
      {"answer_resolved_o", 1}};
  for (const auto& [output, width] : outputs) {
    for (unsigned bit = 0; bit < width; ++bit) {
      for (const bool value : {false, true}) {
        SCOPED_TRACE(testing::Message() << output << "[" << bit << "] stuck at " << value);
        SoVectorOptions options{
            .library = library(16, 16), .objects = 16, .planes = 16, .vectors = 20'000};
        options.stuck = {output, bit, value};
        const SoVectorResult result = run_so_vectors(options);
        ASSERT_TRUE(result.mismatch);
        EXPECT_EQ(result.mismatch->field, output);
        EXPECT_NE(result.mismatch->expected, result.mismatch->got);
        // Nothing differed before, and the same run ends at the same place.
        EXPECT_EQ(result.cycles, result.mismatch->cycle + 1);
        const SoVectorResult again = run_so_vectors(options);
        ASSERT_TRUE(again.mismatch);
        EXPECT_EQ(again.mismatch->cycle, result.mismatch->cycle);
        if (result.mismatch->inputs.rows.empty() || result.mismatch->row == 0) continue;
        const SoVectorResult alone = replay_so_case(options, result.mismatch->inputs);
        ASSERT_TRUE(alone.mismatch);
        EXPECT_EQ(alone.mismatch->field, output);
      }
    }
  }
}

TEST(SoEngine, AStuckBitThatIsNotThereIsRefused) {
  SoVectorOptions options{.library = library(16, 16), .objects = 16, .planes = 16};
  options.stuck = {"answer_hides_o", 16, true};
  EXPECT_THROW(run_so_vectors(options), std::invalid_argument);
  options.stuck = {"clk_i", 0, true};
  EXPECT_THROW(run_so_vectors(options), std::invalid_argument);
}

}  // namespace
}  // namespace cigsim
