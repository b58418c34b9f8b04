// SPDX-License-Identifier: MIT
// The first difference that a comparison of two levels found.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "models/boundary/cycle.hpp"

namespace cigsim {

struct Mismatch {
  std::string stage;
  std::string field;        ///< "spans_word.first", "items taken in cycle", "picture", …
  Cycle cycle = 0;          ///< of the run
  std::uint32_t frame = 0;  ///< of the stage, from 0
  std::optional<std::uint32_t> line;
  std::string expected, got;
  std::vector<std::string> inputs;  ///< what went in: pins of the cycle, and the words before it
};

using MismatchFunction = std::function<void(const Mismatch&)>;

}  // namespace cigsim
