// SPDX-License-Identifier: MIT
// Bytes as text, for pictures inside a page (RFC 4648, section 4).
#pragma once

#include <string>
#include <string_view>

namespace cigsim {

std::string base64(std::string_view bytes);

/// "data:TYPE;base64,…"
std::string data_uri(std::string_view type, std::string_view bytes);

}  // namespace cigsim
