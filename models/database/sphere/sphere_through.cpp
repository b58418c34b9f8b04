// SPDX-License-Identifier: MIT
#include "models/database/sphere/sphere_through.hpp"

#include <algorithm>

namespace cigsim {
namespace {

int sign_of(const Filtered& value) { return value.sign(); }
int sign_of(const Whole& value) { return sgn(value); }

FilteredVec point_as(const SpherePoints& points, std::uint32_t i, Filtered) {
  return points.filtered(i);
}
WholeVec point_as(const SpherePoints& points, std::uint32_t i, Whole) { return points.whole(i); }

// The vectors from the first point to the others.
template <class N>
std::array<Vec3T<N>, 3> edges_of(const SpherePoints& points,
                                 std::span<const std::uint32_t> support) {
  std::array<Vec3T<N>, 3> edge;
  const Vec3T<N> base = point_as(points, support[0], N());
  for (std::size_t i = 1; i < support.size(); ++i)
    edge[i - 1] = point_as(points, support[i], N()) - base;
  return edge;
}

// N and w without the turn of signs that four points may need.
template <class N>
SphereForm<N> form_of(const Vec3T<N>& base, const std::array<Vec3T<N>, 3>& edge,
                      std::size_t count) {
  const auto& [b, c, d] = edge;
  if (count == 1) return {base, {}, N(1)};
  if (count == 2) return {base, b, N(1)};
  if (count == 3) {
    const Vec3T<N> n = cross(b, c);
    return {base, cross(c, n) * dot(b, b) + cross(n, b) * dot(c, c), dot(n, n)};
  }
  const Vec3T<N> cd = cross(c, d);
  return {base, cd * dot(b, b) + cross(d, b) * dot(c, c) + cross(b, c) * dot(d, d), dot(b, cd)};
}

// A sign that is the least of several: −1 as soon as one is certainly negative, 0 when one is not
// certainly positive.
int least_sign(std::initializer_list<int> signs) { return std::min(signs); }

template <class N>
int form_sign(const SphereForm<N>& form, const Vec3T<N>& point) {
  const Vec3T<N> p = point - form.base;
  return sign_of(N(form.weight * dot(p, p) - dot(form.toward, p)));
}

template <class N>
void turn(SphereForm<N>& form) {
  form.weight = N(0) - form.weight;
  form.toward = Vec3T<N>{} - form.toward;
}

}  // namespace

SphereThrough::SphereThrough(const SpherePoints& points, std::span<const std::uint32_t> support)
    : points_(&points), count_(support.size()) {
  std::copy(support.begin(), support.end(), support_.begin());
  filtered_ = form_of(points.filtered(support[0]), edges_of<Filtered>(points, support), count_);
  if (filtered_.weight.value() < 0) turn(filtered_);
}

// The least sign of the centre's weights among the points, times squares; for three points these
// are the cosines of the triangle's angles.
template <class N>
int SphereThrough::smallest_sign(const std::array<Vec3T<N>, 3>& edge) const {
  const auto& [b, c, d] = edge;
  if (count_ == 3) {
    const N bc = dot(b, c);
    return least_sign({sign_of(bc), sign_of(N(dot(b, b) - bc)), sign_of(N(dot(c, c) - bc))});
  }
  const Vec3T<N> cd = cross(c, d), db = cross(d, b), bc = cross(b, c);
  const Vec3T<N> toward = cd * dot(b, b) + db * dot(c, c) + bc * dot(d, d);
  const N w = dot(b, cd), wb = dot(toward, cd), wc = dot(toward, db), wd = dot(toward, bc);
  const N rest = N(2) * w * w - (wb + wc + wd);
  return least_sign({sign_of(wb), sign_of(wc), sign_of(wd), sign_of(rest)});
}

bool SphereThrough::is_smallest() const {
  if (count_ <= 2) return true;
  const int sign = smallest_sign(edges_of<Filtered>(*points_, support()));
  if (sign < 0) return false;
  if (sign > 0 && sign_of(filtered_.weight) != 0) return true;
  if (sgn(whole_form().weight) == 0) return false;
  return smallest_sign(edges_of<Whole>(*points_, support())) >= 0;
}

bool SphereThrough::holds(std::uint32_t point) const {
  if (std::find(support().begin(), support().end(), point) != support().end()) return true;
  // Only with a certain sign of the weight is the form turned for certain.
  if (sign_of(filtered_.weight) > 0)
    if (const int sign = form_sign(filtered_, points_->filtered(point))) return sign < 0;
  return form_sign(whole_form(), points_->whole(point)) <= 0;
}

const SphereForm<Whole>& SphereThrough::whole_form() const {
  if (!whole_) {
    whole_ = form_of(points_->whole(support_[0]), edges_of<Whole>(*points_, support()), count_);
    if (sgn(whole_->weight) < 0) turn(*whole_);
  }
  return *whole_;
}

ExactVec SphereThrough::centre() const {
  const SphereForm<Whole>& form = whole_form();
  // Both the points and N / w are in units of 2^-whole_shift.
  const auto coordinate = [&](const Whole& base, const Whole& toward) {
    Exact value(toward, form.weight * 2);
    value.canonicalize();
    value += base;
    mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(),
                 static_cast<mp_bitcnt_t>(std::max(points_->whole_shift(), 0)));
    if (points_->whole_shift() < 0)
      mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(),
                   static_cast<mp_bitcnt_t>(-points_->whole_shift()));
    return value;
  };
  return {coordinate(form.base.x, form.toward.x), coordinate(form.base.y, form.toward.y),
          coordinate(form.base.z, form.toward.z)};
}

Exact SphereThrough::squared_radius() const {
  const ExactVec to_centre = centre() - convert<Exact>(points_->original(support_[0]));
  return dot(to_centre, to_centre);
}

}  // namespace cigsim
