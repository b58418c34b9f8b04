// SPDX-License-Identifier: MIT
// The saved views of waves/ that the program carries, a stage each.
#pragma once

#include <string_view>

namespace cigsim {

std::string_view embedded_priority_processor();
std::string_view embedded_geometry_processor();
std::string_view embedded_edge_orderer();
std::string_view embedded_priority_resolver();
std::string_view embedded_video_processor();

}  // namespace cigsim
