// SPDX-License-Identifier: MIT
// Expressions of microprograms: numbers, names and '.', with + - * / (whole division), * and /
// before + and -, without brackets and spaces.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace cigsim::firmware {

/// Finds a name's value; throws when there is none.
using Lookup = std::function<std::int64_t(std::string_view name)>;

/// Throws std::invalid_argument with the cause when `text` is no expression.
std::int64_t evaluate(std::string_view text, const Lookup& lookup);

}  // namespace cigsim::firmware
