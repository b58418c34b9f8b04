// SPDX-License-Identifier: MIT
// The files of scenes/ that the program carries, so that it shows something without any file.
#pragma once

#include "common/embedded_file.hpp"

namespace cigsim {

/// "airfield.json", "airfield-approach.csv" and "levine-city.json".
std::span<const EmbeddedFile> embedded_scenes();

}  // namespace cigsim
