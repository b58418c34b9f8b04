// SPDX-License-Identifier: MIT
// The dump of a Verilated module as a part of our own: its declarations, and its changes under
// other codes.
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "models/boundary/wave_part.hpp"

namespace cigsim {

class RtlPart {
 public:
  /// `prefix` makes the part's codes differ from all others of the file.
  RtlPart(std::string scope, std::string prefix, std::unique_ptr<WavePart> part);

  struct Variable {
    std::string name;         ///< with its scopes
    std::string type, width;  ///< as in the dump
    std::string range;        ///< "[15:0]", or empty
    std::string code;
  };
  /// Opens the dump. Verilator declares the pins twice: in the scope of the model, and in the scope
  /// of the module below it. Only what is in the module is told, right below `scope`. The module's
  /// `clk_i` gets the code `clock`: a sample a cycle shows no clock. Throws std::runtime_error for
  /// declarations that end too early.
  std::vector<Variable> declare(const std::string& clock);

  /// Writes what changed up to cycle `n`. Throws std::runtime_error for what is no value.
  void sample(Cycle n, std::ostream& out);

  /// Once; nothing is sampled afterwards.
  void close();

 private:
  [[noreturn]] void fail(std::string_view what) const;

  std::string scope_, prefix_;
  std::unique_ptr<WavePart> part_;
  std::shared_ptr<std::string> text_;  // that the part wrote; it may write until it is gone
  std::string clock_;                  // the module's own code for it
};

}  // namespace cigsim
