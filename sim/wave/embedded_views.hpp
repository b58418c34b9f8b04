// SPDX-License-Identifier: MIT
// The saved views that the program carries: the files of waves/.
#pragma once

#include "common/embedded_file.hpp"

namespace cigsim {

/// "STAGE.gtkw" of each stage with a clocked level, "STAGE.rtl.gtkw" where there is RTL, and the
/// files with names of values that they use.
std::span<const EmbeddedFile> embedded_views();

}  // namespace cigsim
