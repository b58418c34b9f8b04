// SPDX-License-Identifier: MIT
// Levels of detail in an environment: Levine's choose-one levels (1975, ch. II.G). He leaves the
// thresholds to the user; the defaults are cigsim's own.
#pragma once

#include <cstddef>

#include "models/environment/environment.hpp"

namespace cigsim {

inline constexpr std::size_t kMostDescriptions = 64;  ///< of a choice: a group's members
inline constexpr std::size_t kDeepestChoice = 8;      ///< choices within one another

/// The threshold of a description that names none, in elements: of the first, and how many times
/// that of the description before it.
inline constexpr double kFirstThreshold = 8, kThresholdStep = 4;

/// True when the object and all choices around it are in the most detailed description.
bool is_most_detailed(const Environment& environment, const Object& object);

/// The environment with every choice at its most detailed description, and without choices. The
/// objects of other descriptions lose vertices and faces but keep their numbers.
Environment most_detailed(Environment environment);

/// Throws std::invalid_argument, naming the choice, unless all references of choices and to choices
/// are in range and within one model, each choice comes after the one that it stands in, thresholds
/// ascend from above 0, most detailed descriptions hold an object, and neither kMostDescriptions
/// nor kDeepestChoice is exceeded.
void check_choices(const Environment& environment);

}  // namespace cigsim
