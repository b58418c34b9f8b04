// SPDX-License-Identifier: MIT
// The sources of the microprograms that the library carries: STAGE/format.fmt and
// STAGE/microprogram.mas.
#pragma once

#include "common/embedded_file.hpp"

namespace cigsim {

std::span<const EmbeddedFile> embedded_firmware();

}  // namespace cigsim
