// SPDX-License-Identifier: MIT
// Inputs of the separating-object matrix, at random: plain ones, and such as mistakes hide in.
#pragma once

#include <vector>

#include "models/environment/random.hpp"
#include "models/priority_processor/so_golden.hpp"

namespace cigsim::cosim {

/// SEPL and an eyepoint.
struct SoCase {
  unsigned objects = 0, planes = 0;
  std::vector<priority_processor::SoRow> rows;  ///< an object each
  priority_processor::SoBits eye{}, active{};
};

enum class SoKind {
  kEven,            ///< every sign as likely as another
  kThin,            ///< most planes tell of few objects
  kDense,           ///< every plane tells of every object
  kEmpty,           ///< no plane tells of anyone
  kOnePlane,        ///< one plane tells
  kEqualRows,       ///< all objects on the same sides
  kNearDuplicates,  ///< objects that differ on a few planes
  kInLine,          ///< objects one behind the other, a plane between each two: a unique order
  kCount
};

/// SEPL of `kind`. Bits of `plus` are random where nothing is told.
std::vector<priority_processor::SoRow> random_so_rows(Random& random, SoKind kind, unsigned objects,
                                                      unsigned planes);
/// Sides of the planes: random, or those of `before` with one plane crossed, or all the same.
priority_processor::SoBits random_so_eye(Random& random, unsigned planes,
                                         const priority_processor::SoBits& before);
/// Mostly all objects; else some, one, or none.
priority_processor::SoBits random_so_active(Random& random, unsigned objects);

}  // namespace cigsim::cosim
