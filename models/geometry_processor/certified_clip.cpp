// SPDX-License-Identifier: MIT
#include "models/geometry_processor/certified_clip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cigsim::geometry_processor {
namespace {

constexpr int kSides = 4;
// Far below the largest double: sums and products of distances below this do not overflow.
constexpr double kLargest = 0x1p400;

bool is_outside(const LoopCorner& corner, int side) { return corner.outside >> side & 1; }

}  // namespace

CertifiedClip::CertifiedClip(const ViewTransform& view)
    : view_(&view),
      focal_(view.focal),
      half_width_(view.raster.width / 2.0),
      half_height_(view.raster.height / 2.0),
      spread_(1.5 * (view.focal + std::max(half_width_, half_height_))) {}

const ExactPyramid& CertifiedClip::exact() {
  if (!exact_) exact_.emplace(*view_);
  return *exact_;
}

bool CertifiedClip::clip(std::uint8_t sides, const FaceSet& set, std::uint32_t first_vertex,
                         std::vector<LoopCorner>& loop) {
  settled_ = false;
  for (int side = 0; side < kSides; ++side) {
    if (!(sides >> side & 1)) continue;
    for (LoopCorner& corner : loop)
      if (!classify(side, set, first_vertex, corner)) return false;
    scratch_.clear();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const LoopCorner& a = loop[i];
      const LoopCorner& b = loop[i + 1 < loop.size() ? i + 1 : 0];
      if (!is_outside(a, side)) scratch_.push_back(a);
      if (is_outside(a, side) != is_outside(b, side)) scratch_.push_back(cut(a, b, side));
    }
    loop.swap(scratch_);
  }
  return true;
}

// False: in doubt.
bool CertifiedClip::classify(int side, const FaceSet& set, std::uint32_t first_vertex,
                             LoopCorner& corner) {
  const std::uint8_t bit = static_cast<std::uint8_t>(1 << side);
  if (!(corner.unknown & bit)) return true;
  const double d = distance(side, corner.at), margin = spread_ * corner.at.error;
  if (d > margin) return true;
  if (!(d < -margin)) return settle(side, set, first_vertex, corner);
  corner.outside |= bit;
  return true;
}

// An edge that passes through a corner of the picture, as views along an axis have them. With a and
// b the distances of its two vertices from the side that cut it, the cut is (the one vertex times
// |b| plus the other times |a|) / (|a| + |b|). False: it is no cut of an edge.
bool CertifiedClip::settle(int side, const FaceSet& set, std::uint32_t first_vertex,
                           LoopCorner& corner) {
  if (corner.vertex != kNone || corner.cut.a == kNone) return false;
  const auto& [axes, sides] = exact();
  const auto at = [&](std::uint32_t vertex) {
    const auto [u, v, w] = exact_direction(set, first_vertex + vertex, axes);
    return ViewPoint<Dyadic>{u, v, w};
  };
  const ViewPoint<Dyadic> one = at(corner.cut.a), other = at(corner.cut.b);
  const Dyadic a = sides.distance(corner.cut_side, one);
  const Dyadic b = sides.distance(corner.cut_side, other);
  if (a.sign() * b.sign() > 0 || (a.sign() == 0 && b.sign() == 0)) return false;
  const auto magnitude = [](const Dyadic& value) { return value.sign() < 0 ? -value : value; };
  const Dyadic d =
      sides.distance(side, one) * magnitude(b) + sides.distance(side, other) * magnitude(a);
  corner.outside |= static_cast<std::uint8_t>((d.sign() < 0) << side);
  settled_ = true;
  return true;
}

// As PyramidSides has it.
double CertifiedClip::distance(int side, const CertifiedPoint& p) const {
  const double half = (side < 2 ? half_width_ : half_height_) * p.u;
  const double across = focal_ * (side < 2 ? p.v : -p.w);
  return side % 2 == 0 ? half + across : half - across;
}

// Between two corners on one side of a later plane, the cut is there too.
LoopCorner CertifiedClip::cut(const LoopCorner& a, const LoopCorner& b, int side) const {
  const bool leaves = !is_outside(a, side);
  const CertifiedPoint& in = leaves ? a.at : b.at;
  const CertifiedPoint& out = leaves ? b.at : a.at;
  const double d_in = distance(side, in), between = d_in - distance(side, out);
  const double t = d_in / between;
  const double u = out.u - in.u, v = out.v - in.v, w = out.w - in.w;
  const double length = std::abs(u) + std::abs(v) + std::abs(w);
  const double error = std::max(in.error, out.error);
  LoopCorner made;
  made.at = {in.u + u * t, in.v + v * t, in.w + w * t,
             between > 0 && between < kLargest
                 ? 2.5 * error + 1.01 * length * (spread_ * error / between)
                 : std::numeric_limits<double>::infinity()};
  made.cut = a.edge;
  made.cut_side = side;
  made.edge = leaves ? LoopLine{kNone, static_cast<std::uint32_t>(side)} : a.edge;
  const int later = 0xf & ~((2 << side) - 1);
  const int alike = ~(a.outside ^ b.outside) & ~a.unknown & ~b.unknown;
  made.outside = static_cast<std::uint8_t>(a.outside & alike & later);
  made.unknown = static_cast<std::uint8_t>(~alike & later);
  return made;
}

}  // namespace cigsim::geometry_processor
