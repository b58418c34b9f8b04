// SPDX-License-Identifier: MIT
// How wrong the pictures of a run may be: the text of --max-error.
#pragma once

#include <optional>
#include <string>

namespace cigsim {

struct Budget {
  enum class Kind {
    kNone,   ///< as wrong as it may be
    kExact,  ///< proved right
    kShares  ///< the shares below, in every frame
  };
  Kind kind = Kind::kNone;
  std::optional<double> elements;  ///< of a frame's elements that show another object, 0..1
  std::optional<double> cycles;    ///< by which a frame's delay differs from the referee's, >= 0
  std::optional<double> colour;    ///< mean difference of colour in a frame, 0..1
  std::string text;                ///< as given
};

/// `none`, `0`, or NAME=SHARE with commas: elements, cycles, colour, each once; shares as 0.1% or
/// 0.001. `what` names the argument in messages. Throws UsageError.
Budget parse_budget(const std::string& what, const std::string& text);

/// How wrong a setting is.
struct ErrorFigures {
  double elements = 0, colour = 0;
  std::optional<double> cycles;  ///< none: it knows no time, or no referee told
  friend bool operator==(const ErrorFigures&, const ErrorFigures&) = default;
};

/// Whether these errors are within the budget. Cycles that are not known are not within a bound.
bool keeps(const Budget& budget, const ErrorFigures& errors);

/// How many times beyond the budget the errors are; 1 or less within, infinite for what is not
/// known or must be nothing.
double excess(const Budget& budget, const ErrorFigures& errors);

/// "0.1 %", "0"
std::string percent_text(double share);

}  // namespace cigsim
