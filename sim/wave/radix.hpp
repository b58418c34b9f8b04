// SPDX-License-Identifier: MIT
// Values of a wave as text.
#pragma once

#include <string>
#include <string_view>

namespace cigsim {

enum class Radix { kBinary, kOctal, kHexadecimal, kDecimal, kSigned, kText };

/// "bin", "oct", "hex", "dec", "signed", "text". Throws UsageError; `what` names the argument.
Radix parse_radix(std::string_view what, std::string_view text);

/// `digits`: 0, 1, x and z, the highest first. A digit of the text that stands for an x is x, one
/// that stands only for z is z; a decimal number with either is x as a whole. No leading zeros
/// except in kBinary, kOctal and kHexadecimal, where the width tells the number of digits.
std::string value_text(std::string_view digits, Radix radix);

}  // namespace cigsim
