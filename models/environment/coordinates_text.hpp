// SPDX-License-Identifier: MIT
// Coordinates as words of a text file.
#pragma once

#include <charconv>
#include <string>

#include "models/numeric/vec3.hpp"

namespace cigsim {

/// Appends "x y z", each in the shortest form that reads back as the same double.
inline void append_coordinates(std::string& text, const Vec3& p) {
  const auto append = [&](double value) {
    char digits[40];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  };
  append(p.x);
  text += ' ';
  append(p.y);
  text += ' ';
  append(p.z);
}

}  // namespace cigsim
