// SPDX-License-Identifier: MIT
#include "models/edge_orderer/short_line.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace cigsim::edge_orderer {
namespace {

using Whole = ShortLine::Whole;
using WholeVec = Vec3T<Whole>;

// What sums and products come to stays below 2^kBits, so that a sum more does not overflow.
constexpr int kBits = 126;
constexpr int kRasterBits = 14;       // of lines and columns
constexpr int kNoExponent = 1 << 20;  // of zero, which is a multiple of every power of two

// The largest exponent of a power of two of which the finite `value` is a multiple.
int exponent_of(double value) {
  if (value == 0) return kNoExponent;
  constexpr int kFraction = 52, kBias = 1075;
  const std::uint64_t word = std::bit_cast<std::uint64_t>(value);
  const std::uint64_t fraction = word & ((std::uint64_t{1} << kFraction) - 1);
  const int exponent = static_cast<int>(word >> kFraction & 0x7ff);
  if (exponent == 0) return 1 - kBias + std::countr_zero(fraction);
  return exponent - kBias + std::countr_zero(fraction | std::uint64_t{1} << kFraction);
}

int exponent_of(const Vec3& v) {
  return std::min({exponent_of(v.x), exponent_of(v.y), exponent_of(v.z)});
}

// In units of 2^exponent, of which the coordinates must be multiples. False: 2^100 or more, which
// leaves no room for products.
bool to_whole(const Vec3& v, int exponent, WholeVec& out) {
  constexpr double kLimit = 0x1p100, kWord = 0x1p62;
  if (exponent < -1000 || exponent > 1000) return false;
  const double unit = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - exponent) << 52);
  const double x = v.x * unit, y = v.y * unit, z = v.z * unit;
  const double largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  if (!(largest < kLimit)) return false;
  if (largest < kWord)  // what one instruction converts
    out = {static_cast<std::int64_t>(x), static_cast<std::int64_t>(y),
           static_cast<std::int64_t>(z)};
  else
    out = {static_cast<Whole>(x), static_cast<Whole>(y), static_cast<Whole>(z)};
  return true;
}

// No coordinate is larger than 2 to this, either way.
int bits(const WholeVec& v) {
  using Word = unsigned __int128;
  const auto magnitude = [](Whole x) { return static_cast<Word>(x < 0 ? ~x : x); };
  const Word all = magnitude(v.x) | magnitude(v.y) | magnitude(v.z);
  const std::uint64_t high = static_cast<std::uint64_t>(all >> 64);
  return high != 0 ? 64 + std::bit_width(high) : std::bit_width(static_cast<std::uint64_t>(all));
}

// Parallel to one axis: the unit vector, so that products stay short.
void shorten(WholeVec& v) {
  if ((v.x != 0) + (v.y != 0) + (v.z != 0) == 1) v = {v.x != 0, v.y != 0, v.z != 0};
}

}  // namespace

std::int32_t ShortLine::element(int line, int width) const {
  const Whole at = start + step * (line - first_line);
  const Whole up = at / unit + (at % unit > 0);
  return up <= 0 ? 0 : up >= width ? width : static_cast<std::int32_t>(up);
}

ShortView::ShortView(const ViewTransform& view)
    : eye_(view.eye),
      eye_exponent_(exponent_of(view.eye)),
      width_(view.raster.width),
      height_(view.raster.height) {
  const Vec3(&rows)[3] = view.rotation.row;
  const int exponent = std::min({exponent_of(rows[0]), exponent_of(rows[1]), exponent_of(rows[2])});
  holds_ = true;
  for (int i = 0; i < 3; ++i) {
    holds_ = holds_ && to_whole(rows[i], exponent, rotation_.row[i]);
    rotation_bits_ = std::max(rotation_bits_, bits(rotation_.row[i]));
  }
  WholeVec focal;
  focal_exponent_ = exponent_of(view.focal);
  holds_ = holds_ && to_whole({view.focal, 0, 0}, focal_exponent_, focal);
  focal_ = focal.x;
  focal_bits_ = bits(focal);
}

// As ExactLine::through_vertices(), with the first vertex and the edge's direction instead of both
// vertices, and all of it twice.
std::optional<ShortLine> ShortView::line(const Vec3& a, const Vec3& b, int first_line) const {
  if (!holds_) return {};
  const int exponent = std::min({eye_exponent_, exponent_of(a), exponent_of(b)});
  WholeVec eye, from, to;
  if (!to_whole(eye_, exponent, eye) || !to_whole(a, exponent, from) || !to_whole(b, exponent, to))
    return {};
  const WholeVec from_eye = from - eye, along = to - from;
  if (rotation_bits_ + std::max(bits(from_eye), bits(along)) + 2 > kBits) return {};
  const WholeVec vertex = rotation_ * from_eye;
  WholeVec edge = rotation_ * along;
  shorten(edge);
  if (bits(vertex) + bits(edge) + 1 > kBits) return {};
  const WholeVec n = cross(vertex, edge);
  // Where n_u is 0 the focal length, which may be long, does not matter.
  const int focal_up = n.x == 0 ? 0 : std::max(focal_exponent_ + 1, 0);
  const int others_up = n.x == 0 ? 0 : std::max(-focal_exponent_ - 1, 0);
  const int others_bits = kRasterBits + 1 + others_up;
  if (bits(n) + std::max(others_bits, n.x == 0 ? 0 : focal_bits_ + focal_up) + 2 > kBits) return {};
  const Whole others = Whole{1} << others_up;
  const Whole sign = n.y < 0 ? -1 : 1;
  ShortLine line;
  line.first_line = first_line;
  line.start = sign * ((n.y * (width_ - 1) + n.z * (2 * first_line + 1 - height_)) * others -
                       (n.x == 0 ? 0 : n.x * focal_ * (Whole{1} << focal_up)));
  line.step = sign * n.z * 2 * others;
  line.unit = sign * n.y * 2 * others;
  return line;
}

}  // namespace cigsim::edge_orderer
