// SPDX-License-Identifier: MIT
// The worlds of the envelope's search, and how they are seen at each step of an axis.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/database/database.hpp"
#include "models/environment/environment.hpp"
#include "models/environment/random.hpp"
#include "sim/stability/measures.hpp"

namespace cigsim::stability {

/// What a user changes.
enum class SearchAxis : std::uint8_t { kRaster, kClearance, kSmall, kLarge, kOffset, kFar, kNear };
inline constexpr std::array kSearchAxes{
    SearchAxis::kRaster, SearchAxis::kClearance, SearchAxis::kSmall, SearchAxis::kLarge,
    SearchAxis::kOffset, SearchAxis::kFar,       SearchAxis::kNear};
std::string_view name_of(SearchAxis axis);

/// The steps of an axis, powers of two: lines; heights above a plane as a share of the largest
/// coordinate (2^-step); factors of all lengths (2^-step, 2^step); offsets and distances in sizes
/// of the world; heights above a face.
struct Steps {
  int first = 0, last = 0, by = 1;
};
Steps steps_of(SearchAxis axis);

/// A scene with the sphere in which it lies.
struct SearchWorld {
  std::string name;
  Environment environment;
  Vec3 centre;
  double radius = 0;
};

/// Convex worlds of a dozen objects each, apart, touching and on ground, and the airfield if
/// wanted.
std::vector<SearchWorld> search_worlds(std::uint64_t seed, bool airfield);

/// All lengths times `scale`, then moved by `offset`; coordinates are rounded to doubles.
SearchWorld moved(const SearchWorld& world, double scale, const Vec3& offset);

/// The world of a step, prepared, and the viewpoints on it.
class SteppedWorld {
 public:
  SteppedWorld(const SearchWorld& world, SearchAxis axis, int step);

  const Database& database() const { return database_; }
  Raster raster() const;
  /// None: nothing was found to look at.
  std::optional<Viewpoint> viewpoint(Random& random) const;

 private:
  struct Sight;
  Sight sight(const Viewpoint& viewpoint) const;
  Viewpoint plain(Random& random) const;
  Viewpoint clear_of_planes(Random& random) const;
  std::optional<Viewpoint> beside_a_plane(Random& random) const;
  std::optional<Viewpoint> before_a_face(Random& random) const;
  Viewpoint from_afar(Random& random) const;

  SearchWorld world_;
  SearchAxis axis_;
  int step_;
  Database database_;
};

}  // namespace cigsim::stability
