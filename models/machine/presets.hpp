// SPDX-License-Identifier: MIT
// The machine descriptions that the library carries: the files of models/machine/presets/.
#pragma once

#include "common/embedded_file.hpp"

namespace cigsim {

std::span<const EmbeddedFile> embedded_presets();

}  // namespace cigsim
