// SPDX-License-Identifier: MIT
#include "models/edge_orderer/exact_line.hpp"

#include <algorithm>

namespace cigsim::edge_orderer {

ExactLine::ExactLine(const EdgeList<Certified>& list, const ExactAxes& axes,
                     const Edge<Certified>& edge)
    : first_line_(edge.first_line) {
  if (edge.from != kNone) {
    through_vertices(list, axes, edge);
    return;
  }
  const Edge<Exact>& exact = list.exact[edge.to];
  unit_ = lcm(exact.x.get_den(), exact.slope.get_den());
  start_ = exact.x.get_num() * (unit_ / exact.x.get_den());
  step_ = exact.slope.get_num() * (unit_ / exact.slope.get_den());
}

// With n the cross product of the two directions, a sample (x, y) of the raster, which is the
// direction (focal, x - width/2, height/2 - y), lies in the plane of the eyepoint and the edge
// where n_u focal + n_v (x - width/2) + n_w (height/2 - y) = 0. The edge is not level, so n_v is
// not 0.
void ExactLine::through_vertices(const EdgeList<Certified>& list, const ExactAxes& axes,
                                 const Edge<Certified>& edge) {
  const FaceSet& set = *list.sets[static_cast<std::size_t>(edge.set)];
  const ViewTransform& view = list.view;
  const Vec3T<Dyadic> n =
      cross(exact_direction(set, edge.from, axes), exact_direction(set, edge.to, axes));
  const Dyadic start = n.y * Dyadic((view.raster.width - 1) / 2.0) +
                       n.z * Dyadic(edge.first_line + 0.5 - view.raster.height / 2.0) -
                       n.x * Dyadic(view.focal);
  const int exponent = n.y.exponent_or(0);
  const int common = std::min({exponent, start.exponent_or(exponent), n.z.exponent_or(exponent)});
  start_ = start.whole(common);
  step_ = n.z.whole(common);
  unit_ = n.y.whole(common);
}

std::int32_t ExactLine::element(int line, int width) const {
  const mpz_class at = start_ + step_ * (line - first_line_);
  mpz_class element;
  mpz_cdiv_q(element.get_mpz_t(), at.get_mpz_t(), unit_.get_mpz_t());
  return sgn(element) <= 0  ? 0
         : element >= width ? width
                            : static_cast<std::int32_t>(element.get_si());
}

}  // namespace cigsim::edge_orderer
