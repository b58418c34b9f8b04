// SPDX-License-Identifier: MIT
// What the JSON library says of a fault, in words for a user.
#pragma once

#include <string>

namespace cigsim {

/// The library's message without its prefix "[json.exception…]" and its own place; one line.
std::string json_reason(const std::string& message);

}  // namespace cigsim
