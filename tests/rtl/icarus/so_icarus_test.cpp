// SPDX-License-Identifier: MIT
// The SO matrix in a second simulator: Icarus gives what Verilator and the golden model give.
#include <gtest/gtest.h>

#include <sstream>

#include "models/environment/random.hpp"
#include "tests/rtl/icarus/so_stimulus.hpp"
#include "tests/rtl/so_specification.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

using test::bytes_of;
using test::Scratch;

class SoIcarus : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("iverilog -V >/dev/null 2>&1") != 0) GTEST_SKIP() << "needs iverilog";
  }
  Scratch scratch_;
};

TEST_F(SoIcarus, PairsAreTheMatrixToldPlaneByPlane) {
  const std::uint64_t seed = 4;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  Random random(seed);
  const std::string eye(64, '+');
  std::ofstream stimulus(scratch_.path("stimulus"));
  std::ostringstream expected;
  for (unsigned n = 0; n < 4000; ++n) {
    const auto kind = static_cast<cosim::SoKind>(n % static_cast<unsigned>(cosim::SoKind::kCount));
    const auto rows = cosim::random_so_rows(random, kind, 2, 64);
    // With the eye on all plus sides the marks are the signs.
    stimulus << fmt::format("{:x} {:x} {:x} {:x}\n", rows[0].tells[0],
                            rows[0].plus[0] & rows[0].tells[0], rows[1].tells[0],
                            rows[1].plus[0] & rows[1].tells[0]);
    const char so = so_of(signs_of(rows, 64), eye, 0, 1);
    expected << (so == '+') << (so == '-') << (so == '?') << '\n';
  }
  stimulus.close();
  build_with_icarus(CIGSIM_SOURCE_DIR, "so_pair_tb", "", scratch_.path("pair.vvp"));
  run_with_icarus(scratch_.path("pair.vvp"), scratch_.path("stimulus"), scratch_.path("outputs"));
  EXPECT_EQ(bytes_of(scratch_.path("outputs")), expected.str());
}

void same_vectors(const Scratch& scratch, unsigned objects, unsigned planes,
                  std::uint64_t vectors) {
  SCOPED_TRACE(testing::Message() << objects << " x " << planes);
  cosim::SoVectorOptions options{.library = fmt::format("{}/so_engine-Objects={}-Planes={}.so",
                                                        CIGSIM_RTL_LIBRARIES, objects, planes),
                                 .objects = objects,
                                 .planes = planes,
                                 .vectors = vectors,
                                 .seed = 6};
  std::ofstream stimulus(scratch.path("stimulus"));
  std::ostringstream expected;
  write_cycles(options, stimulus, expected);
  ASSERT_FALSE(run_so_vectors(options).mismatch);
  stimulus.close();
  build_with_icarus(
      CIGSIM_SOURCE_DIR, "so_engine_tb",
      fmt::format("-Pso_engine_tb.Objects={} -Pso_engine_tb.Planes={}", objects, planes),
      scratch.path("engine.vvp"));
  run_with_icarus(scratch.path("engine.vvp"), scratch.path("stimulus"), scratch.path("outputs"));
  EXPECT_EQ(bytes_of(scratch.path("outputs")), expected.str());
}

TEST_F(SoIcarus, SmallEngineGivesTheSameInEveryCycle) {
  same_vectors(scratch_, 3, 3, 10'000);
  same_vectors(scratch_, 16, 16, 3'000);
}

TEST_F(SoIcarus, EngineOf64ObjectsAndPlanesGivesTheSameInEveryCycle) {
  same_vectors(scratch_, 64, 64, 1'500);
}

}  // namespace
}  // namespace cigsim
