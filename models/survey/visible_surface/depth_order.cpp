// SPDX-License-Identifier: MIT
#include "models/survey/visible_surface/depth_order.hpp"

namespace cigsim::survey {

int DepthOrder::sign(std::uint32_t p, std::uint32_t q, const RasterPlace& at) const {
  const RoundedPlane &a = list_.rounded[p], &b = list_.rounded[q];
  const double x = at.x.get_d(), y = at.y.get_d();
  const double difference = (a.a * x + a.b * y + a.c) - (b.a * x + b.b * y + b.c);
  const double slack = a.slack + b.slack;
  if (difference > slack) return 1;
  if (difference < -slack) return -1;
  ++exact_tests_;
  const DepthPlane &ea = list_.planes[p], &eb = list_.planes[q];
  return sgn(Exact((ea.a - eb.a) * at.x + (ea.b - eb.b) * at.y + (ea.c - eb.c)));
}

int DepthOrder::exact_sign(std::uint32_t p, std::uint32_t q, int x, int y) const {
  ++exact_tests_;
  const DepthPlane &a = list_.planes[p], &b = list_.planes[q];
  const Exact right(a.a - b.a), down(a.b - b.b);
  if (const int s = sgn(Exact(right * x + down * y + (a.c - b.c)))) return s;
  if (const int s = sgn(right)) return s;
  return sgn(down);
}

}  // namespace cigsim::survey
