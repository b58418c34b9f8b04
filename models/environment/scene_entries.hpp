// SPDX-License-Identifier: MIT
// Objects and choices in the order in which a scene file lists them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "models/environment/environment.hpp"

namespace cigsim {

/// An entry of a list of objects.
struct SceneEntry {
  bool is_choice = false;
  std::uint32_t index = 0;                                 ///< of the object or the choice
  std::vector<std::vector<SceneEntry>> descriptions = {};  ///< of a choice
};

/// The entries of the objects [first, last), which stand in no description but those of choices
/// among them. Throws std::invalid_argument when the objects of a choice are not all together,
/// description after description.
std::vector<SceneEntry> scene_entries(const Environment& environment, std::size_t first,
                                      std::size_t last);

}  // namespace cigsim
