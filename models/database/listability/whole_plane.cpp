// SPDX-License-Identifier: MIT
#include "models/database/listability/whole_plane.hpp"

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

}  // namespace cigsim::listability
