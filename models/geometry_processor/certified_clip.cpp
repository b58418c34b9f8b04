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
    : focal_(view.focal),
      half_width_(view.raster.width / 2.0),
      half_height_(view.raster.height / 2.0),
      spread_(1.5 * (view.focal + std::max(half_width_, half_height_))) {}

bool CertifiedClip::clip(std::uint8_t sides, std::vector<LoopCorner>& loop) {
  for (int side = 0; side < kSides; ++side) {
    if (!(sides >> side & 1)) continue;
    for (LoopCorner& corner : loop)
      if (!classify(side, corner)) return false;
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
bool CertifiedClip::classify(int side, LoopCorner& corner) const {
  const std::uint8_t bit = static_cast<std::uint8_t>(1 << side);
  if (!(corner.unknown & bit)) return true;
  const double d = distance(side, corner.at), margin = spread_ * corner.at.error;
  if (d > margin) return true;
  corner.outside |= bit;
  return d < -margin;
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
  made.edge = leaves ? LoopLine{kNone, static_cast<std::uint32_t>(side)} : a.edge;
  const int later = 0xf & ~((2 << side) - 1);
  const int alike = ~(a.outside ^ b.outside) & ~a.unknown & ~b.unknown;
  made.outside = static_cast<std::uint8_t>(a.outside & alike & later);
  made.unknown = static_cast<std::uint8_t>(~alike & later);
  return made;
}

}  // namespace cigsim::geometry_processor
