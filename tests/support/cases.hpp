// SPDX-License-Identifier: MIT
// How many random cases a test runs.
#pragma once

#include <cstdlib>

namespace cigsim::test {

/// CIGSIM_CASES=N asks for N instead: more for a long run, fewer for mutants (scripts/mutants).
inline unsigned cases(unsigned usual) {
  const char* const asked = std::getenv("CIGSIM_CASES");
  return asked != nullptr ? static_cast<unsigned>(std::strtoul(asked, nullptr, 10)) : usual;
}

}  // namespace cigsim::test
