// SPDX-License-Identifier: MIT
// Pictures of the machine in every configuration against the oracle's.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "tests/support/ray_oracle.hpp"
#include "tests/support/worlds.hpp"

namespace cigsim::test {

/// True when a picture in rounded numbers may differ from the right one at an element: a projected
/// edge of a polygon passes within half an element of its centre, or the line in which two faces
/// meet, one of object `a` and one of object `b`, passes through its square.
bool near_an_edge(const std::vector<OraclePolygon>& polygons, const ViewTransform& view, int column,
                  int row, std::uint32_t a, std::uint32_t b);

/// The picture of object numbers that a plain reading of the separation tree gives, in exact
/// numbers (Fuchs, Kedem, Naylor 1980), without moving models and ground.
std::vector<std::uint16_t> picture_by_traversal(const Database& database,
                                                const ViewTransform& view);

/// What a series of pictures came to.
struct Tally {
  std::uint64_t pictures = 0, elements = 0;
  std::uint64_t rounded_mismatches = 0;  ///< of double, each near an edge
};

/// Whether the exact picture must be the oracle's on every element, or only away from edges.
enum class Strictness { kEveryElement, kNearEdges };

/// Fails the running test unless
///  - in exact numbers both priority methods and all resolvers give one picture, as strict as
///  told;
///  - in double they all give one picture, which differs from the oracle's near edges only,
///    those that preparation cut among them;
///  - in certified numbers they all give the exact picture, on every element;
///  - no group's counts were at fault.
/// `what` tells of the case in messages.
void check_machine(const std::vector<OraclePolygon>& polygons, const Database& database,
                   const Viewpoint& viewpoint, const Raster& raster, double frame,
                   Strictness strictness, const std::string& what, Tally& tally);

/// check_machine on every element for a world in which nothing moves, and the same of the plain
/// traversal.
void check_picture(const World& world, const Database& database, const Viewpoint& viewpoint,
                   const Raster& raster, const std::string& what, Tally& tally);

/// check_picture from `views` random viewpoints; prepares the world. `largest` is the largest side
/// of a raster.
void check_world(const World& world, Random& random, int views, int largest,
                 const std::string& what, Tally& tally);

/// Fails the running test unless fewer than 0.01 % of the elements differed in double.
void check_rate(const Tally& tally);

}  // namespace cigsim::test
