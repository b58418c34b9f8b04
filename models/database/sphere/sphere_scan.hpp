// SPDX-License-Identifier: MIT
// Passes over many points for the one farthest from a centre: in doubles, and in twice their
// precision for those that doubles cannot tell from the sphere.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/numeric/vec3.hpp"

namespace cigsim {

/// An unevaluated sum of two doubles, the first the nearest to it.
struct TwoDoubles {
  double high = 0, low = 0;
};

/// A sphere whose centre and squared radius are known to twice the precision of doubles.
struct ScannedSphere {
  TwoDoubles x, y, z, squared_radius;
  double largest = 0;  ///< magnitude of a coordinate of the points
};

/// Points in blocks, each with the largest squared distance that its last pass found.
class SphereScan {
 public:
  explicit SphereScan(std::span<const Vec3> points);

  /// The point whose squared distance in doubles is largest. There must be a point.
  struct Farthest {
    std::uint32_t point = 0;
    double squared_distance = 0;
  };
  Farthest farthest(const ScannedSphere& sphere);

  /// The farthest point of each block that reaches beyond the sphere by more than band().
  std::vector<std::uint32_t> outside(const ScannedSphere& sphere);

  /// After farthest() or outside(): squared distances to twice the precision. Quick while the
  /// sphere has moved little since then, for blocks that were well inside are not looked at.
  struct Closer {
    std::uint32_t farthest = 0;
    double excess = 0;  ///< of `farthest`, which is outside for certain; or 0
    std::vector<std::uint32_t>
        outside;  ///< of each block, the farthest that is outside for certain
    std::vector<std::uint32_t> doubtful;  ///< on the sphere as far as this precision tells
  };
  Closer closer_look(const ScannedSphere& sphere) const;

  /// How far a squared distance in doubles may be wrong for points about the sphere.
  static double band(const ScannedSphere& sphere);

 private:
  static constexpr std::size_t kBlock = 512;

  std::span<const Vec3> block(std::size_t i) const;
  /// The largest squared distance in a block, and its place.
  Farthest scan_block(const ScannedSphere& sphere, std::size_t i);

  std::span<const Vec3> points_;
  std::vector<double> most_;  // by block
  Vec3 centre_;               // that most_ was measured from
};

}  // namespace cigsim
