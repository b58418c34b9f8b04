// SPDX-License-Identifier: MIT
// Whole numbers times powers of two against rationals.
#include "models/numeric/dyadic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "models/environment/random.hpp"
#include "models/numeric/number.hpp"

namespace cigsim {
namespace {

Exact rational(const Dyadic& value) {
  const int exponent = std::min(value.exponent_or(0), 0);
  Exact out(value.whole(exponent));
  mpq_div_2exp(out.get_mpq_t(), out.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return out;
}

TEST(Dyadic, HoldsEveryDouble) {
  for (const double value :
       {0.0, -0.0, 1.0, -3.0, 0.1, -1e300, 1e-300, std::numeric_limits<double>::denorm_min(),
        std::numeric_limits<double>::max(), -std::numeric_limits<double>::min()})
    EXPECT_EQ(rational(Dyadic(value)), Exact(value)) << value;
}

TEST(Dyadic, SumsAndProductsAreExact) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const auto draw = [&] {
      const double value = random.between(-1, 1) * std::pow(2, random.between(-80, 80));
      return random.below(6) == 0 ? 0.0 : random.below(3) == 0 ? std::round(value) : value;
    };
    const double a = draw(), b = draw(), c = draw(), d = draw();
    const Dyadic value = Dyadic(a) * Dyadic(b) - Dyadic(c) * Dyadic(d) + Dyadic(a);
    const Exact want = Exact(a) * Exact(b) - Exact(c) * Exact(d) + Exact(a);
    ASSERT_EQ(rational(value), want) << a << " " << b << " " << c << " " << d;
    EXPECT_EQ(value.sign(), sgn(want));
    EXPECT_EQ(Dyadic(a) < Dyadic(b), a < b);
    // Beyond 127 bits.
    const Dyadic longer = value * value * Dyadic(c) - value * Dyadic(b);
    const Exact longer_want = want * want * Exact(c) - want * Exact(b);
    ASSERT_EQ(rational(longer), longer_want) << a << " " << b << " " << c << " " << d;
    EXPECT_EQ((longer - longer).sign(), 0);
    EXPECT_EQ((-longer).sign(), -sgn(longer_want));
  }
}

}  // namespace
}  // namespace cigsim
