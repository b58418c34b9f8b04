// SPDX-License-Identifier: MIT
// What every reader throws on unusable input. The command prints it as one line and exits with 2.
#pragma once

#include <stdexcept>
#include <string>

namespace cigsim {

class InputError : public std::runtime_error {
 public:
  /// `line` counts from 1; 0 means that the format has no lines (or the fault no place).
  InputError(const std::string& file, int line, const std::string& what_and_what_to_do)
      : std::runtime_error(file + ":" + (line > 0 ? std::to_string(line) + ":" : "") + " " +
                           what_and_what_to_do) {}
};

}  // namespace cigsim
