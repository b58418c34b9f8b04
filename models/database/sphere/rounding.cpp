// SPDX-License-Identifier: MIT
#include "models/database/sphere/rounding.hpp"

#include <cmath>
#include <limits>

namespace cigsim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Exact square(double value) { return Exact(value) * Exact(value); }

// The root to a few bits: of value / 4^e, which is a double of middling size, times 2^e.
double rough_root(const Exact& value) {
  const auto bits = [](const mpz_class& z) {
    return static_cast<long>(mpz_sizeinbase(z.get_mpz_t(), 2));
  };
  const long e = (bits(value.get_num()) - bits(value.get_den())) / 2;
  Exact scaled = value;
  if (e >= 0)
    mpq_div_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(2 * e));
  else
    mpq_mul_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(-2 * e));
  return std::ldexp(std::sqrt(scaled.get_d()), static_cast<int>(e));
}

}  // namespace

double nearest_double(const Exact& value) {
  // GMP truncates: the other candidate is one further from zero.
  const double low = value.get_d();
  const double high = std::nextafter(low, sgn(value) < 0 ? -kInfinity : kInfinity);
  if (std::isinf(high)) return low;
  return abs(Exact(high) - value) < abs(value - Exact(low)) ? high : low;
}

double root_up(const Exact& value) {
  if (sgn(value) == 0) return 0;
  double root = rough_root(value);
  if (std::isinf(root)) root = std::numeric_limits<double>::max();
  while (!std::isinf(root) && square(root) < value) root = std::nextafter(root, kInfinity);
  while (!std::isinf(root) && root > 0 && square(std::nextafter(root, 0)) >= value)
    root = std::nextafter(root, 0);
  return root;
}

double root_nearest(const Exact& value) {
  const double high = root_up(value);
  if (high == 0 || std::isinf(high)) return high;
  const double low = std::nextafter(high, 0);
  const Exact middle = (Exact(low) + Exact(high)) / 2;
  return middle * middle < value ? high : low;
}

double sum_up(double a, double b) {
  const double sum = a + b;
  if (std::isinf(sum) || Exact(sum) >= Exact(a) + Exact(b)) return sum;
  return std::nextafter(sum, kInfinity);
}

}  // namespace cigsim
