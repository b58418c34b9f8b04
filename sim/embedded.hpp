// SPDX-License-Identifier: MIT
// The files of scenes/ that the program carries, so that it shows something without any file.
#pragma once

#include <string_view>

namespace cigsim {

std::string_view embedded_airfield();           ///< scenes/airfield.json
std::string_view embedded_airfield_approach();  ///< scenes/airfield-approach.csv

}  // namespace cigsim
