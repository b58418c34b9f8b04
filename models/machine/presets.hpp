// SPDX-License-Identifier: MIT
// The machine descriptions that the library carries: the files of models/machine/presets/.
#pragma once

#include <string_view>

namespace cigsim {

std::string_view embedded_nasa1968();
std::string_view embedded_asupt1975();
std::string_view embedded_unlimited();

}  // namespace cigsim
