// SPDX-License-Identifier: MIT
#include "models/hidden_line/eye.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <limits>

namespace cigsim::hidden_line {
namespace {

// A difference of doubles carries 1 eps, a product of three of them 3 and two roundings more, the
// sums up to 3: below 10 eps of the product of the sizes. 2^-49 is 16 eps.
constexpr double kBound = 0x1p-49;
constexpr double kUnderflow = 0x1p-900;
// Below this share of a point's distance u says nothing certain about x and y.
constexpr double kAhead = 0x1p-20;

thread_local std::uint64_t exact_count = 0;

using Whole = std::array<mpz_class, 3>;

struct Parts {
  std::int64_t mantissa = 0;
  int exponent = INT_MAX;  // of the mantissa's last bit; INT_MAX for 0
};

Parts parts(double value) {
  if (value == 0) return {};
  int exponent = 0;
  const double m = std::frexp(value, &exponent);
  return {static_cast<std::int64_t>(std::ldexp(m, 53)), exponent - 53};
}

int least_exponent(const Vec3& p) {
  return std::min({parts(p.x).exponent, parts(p.y).exponent, parts(p.z).exponent});
}

// value * 2^-exponent, which must be whole.
mpz_class scaled(double value, int exponent) {
  const Parts p = parts(value);
  mpz_class out;
  mpz_set_si(out.get_mpz_t(), p.mantissa);
  if (p.mantissa != 0)
    mpz_mul_2exp(out.get_mpz_t(), out.get_mpz_t(), static_cast<mp_bitcnt_t>(p.exponent - exponent));
  return out;
}

Whole scaled(const Vec3& v, int exponent) {
  return {scaled(v.x, exponent), scaled(v.y, exponent), scaled(v.z, exponent)};
}

// position - eye, times some power of two.
Whole whole(const Vec3& position, const Vec3& eye, int exponent) {
  Whole p = scaled(position, exponent);
  const Whole e = scaled(eye, exponent);
  for (std::size_t i = 0; i < 3; ++i) p[i] -= e[i];
  return p;
}

Whole whole(const Vec3& position, const Vec3& eye) {
  return whole(position, eye, std::min(least_exponent(position), least_exponent(eye)));
}

Whole cross(const Whole& a, const Whole& b) {
  return {mpz_class(a[1] * b[2] - a[2] * b[1]), mpz_class(a[2] * b[0] - a[0] * b[2]),
          mpz_class(a[0] * b[1] - a[1] * b[0])};
}

mpz_class dot(const Whole& a, const Whole& b) {
  return mpz_class(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

double size_of(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace

SeenPoint Eye::see(const Vec3& position) const {
  SeenPoint s;
  s.position = position;
  s.d = position - view_.eye;
  s.size = size_of(s.d);
  s.u = cigsim::dot(view_.rotation.row[0], s.d);
  s.v = cigsim::dot(view_.rotation.row[1], s.d);
  s.w = cigsim::dot(view_.rotation.row[2], s.d);
  s.ahead = s.u > kAhead * s.size && s.u > kUnderflow;
  if (s.ahead) {
    s.x = s.v / s.u;
    s.y = s.w / s.u;
    // Eight eps of the size in each coordinate, and the same again to be safe.
    s.margin = 0x1p-48 * (s.size / s.u) * (2 + std::abs(s.x) + std::abs(s.y));
  }
  return s;
}

int Eye::turn(const SeenPoint& a, const SeenPoint& b, const SeenPoint& c) const {
  const double value = -cigsim::dot(cigsim::cross(a.d, b.d), c.d);
  const double bound = kBound * a.size * b.size * c.size + kUnderflow;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  ++exact_count;
  const Vec3& eye = view_.eye;
  return -sgn(dot(cross(whole(a.position, eye), whole(b.position, eye)), whole(c.position, eye)));
}

int Eye::above(const SeenPoint& a, const SeenPoint& c) const {
  // The viewpoint system is left-handed: the normal of (a, right) points down.
  const Vec3& right = view_.rotation.row[1];
  const double value = -cigsim::dot(cigsim::cross(a.d, right), c.d);
  const double bound = kBound * a.size * size_of(right) * c.size + kUnderflow;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  ++exact_count;
  const Vec3& eye = view_.eye;
  return -sgn(dot(cross(whole(a.position, eye), scaled(right, least_exponent(right))),
                  whole(c.position, eye)));
}

Exact Eye::crossing(const SeenPoint& p, const SeenPoint& q, const SeenPoint& a,
                    const SeenPoint& b) const {
  ++exact_count;
  const Vec3& eye = view_.eye;
  const Whole normal = cross(whole(p.position, eye), whole(q.position, eye));
  const int exponent =
      std::min({least_exponent(a.position), least_exponent(b.position), least_exponent(eye)});
  const mpz_class at_a = dot(normal, whole(a.position, eye, exponent));
  const mpz_class at_b = dot(normal, whole(b.position, eye, exponent));
  Exact t(at_a, mpz_class(at_a - at_b));
  t.canonicalize();
  return t;
}

Exact Eye::crossing(const Plane& plane, const SeenPoint& a, const SeenPoint& b) {
  ++exact_count;
  const ExactVec normal = exact_normal(plane), p = convert<Exact>(plane.exact.p);
  const Exact at_a = cigsim::dot(normal, convert<Exact>(a.position) - p);
  const Exact at_b = cigsim::dot(normal, convert<Exact>(b.position) - p);
  return Exact(at_a / (at_a - at_b));
}

std::uint64_t exact_turns() { return exact_count; }

}  // namespace cigsim::hidden_line
