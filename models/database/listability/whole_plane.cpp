// SPDX-License-Identifier: MIT
#include "models/database/listability/whole_plane.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim::listability {
namespace {

mpz_class whole(const Exact& value, const mpz_class& times) {
  return mpz_class(value.get_num() * (times / value.get_den()));
}

}  // namespace

WholePlane whole_plane(const Plane& plane) {
  const ExactVec n = exact_normal(plane);
  const Exact d = dot(n, convert<Exact>(plane.exact.p));
  mpz_class times = lcm(lcm(n.x.get_den(), n.y.get_den()), lcm(n.z.get_den(), d.get_den()));
  WholePlane out{{whole(n.x, times), whole(n.y, times), whole(n.z, times)}, whole(d, times)};
  const mpz_class common = gcd(gcd(out.n.x, out.n.y), gcd(out.n.z, out.d));
  if (common > 1)
    for (mpz_class* value : {&out.n.x, &out.n.y, &out.n.z, &out.d}) *value /= common;
  return out;
}

std::vector<WholePlane> whole_planes(const std::vector<Plane>& planes) {
  std::vector<WholePlane> out;
  out.reserve(planes.size());
  for (const Plane& plane : planes) out.push_back(whole_plane(plane));
  return out;
}

std::array<double, 4> scaled(const mpz_class& a, const mpz_class& b, const mpz_class& c,
                             const mpz_class& d) {
  constexpr long kLeast = -2000;  // below all doubles
  std::array<double, 4> out{};
  long exponent[4] = {}, most = 0;
  bool any = false;
  const mpz_class* from[4] = {&a, &b, &c, &d};
  for (std::size_t i = 0; i < 4; ++i) {
    out[i] = mpz_get_d_2exp(&exponent[i], from[i]->get_mpz_t());
    if (out[i] == 0) continue;
    most = any ? std::max(most, exponent[i]) : exponent[i];
    any = true;
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (out[i] != 0)
      out[i] = std::ldexp(out[i], static_cast<int>(std::max(exponent[i] - most, kLeast)));
  return out;
}

}  // namespace cigsim::listability
