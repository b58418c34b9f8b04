// SPDX-License-Identifier: MIT
// Cycles of a path through a microprogram.
#pragma once

#include <map>

#include "firmware/assembler/program.hpp"

namespace cigsim::firmware {

/// A path; `outcomes` says for addresses of data-dependent instructions which way they go.
struct Path {
  std::uint32_t from = 0, to = 0;
  std::map<std::uint32_t, bool> outcomes;
};

/// Walks the path with a Sequencer and counts its instructions. Throws std::invalid_argument with
/// the cause when the path depends on data, leaves the program or does not reach its end.
Cycle count_path(const Program& program, const Path& path);

}  // namespace cigsim::firmware
