// SPDX-License-Identifier: MIT
// Maps modules of rtl/ to the parts of parts.hpp with Yosys and its ABC.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/gates/netlist.hpp"

namespace cigsim::gates {

/// A module of rtl/ at a size.
struct Circuit {
  std::string stage, module;  ///< rtl/STAGE/MODULE.sv
  std::vector<std::pair<std::string, std::uint32_t>> parameters;
  /// The modules within stay: each is mapped once, however often it is there. Only for modules
  /// without registers.
  bool keep_modules = false;
};

class Synthesis {
 public:
  /// Throws UsageError where Yosys is not installed.
  Synthesis();
  ~Synthesis();
  Synthesis(const Synthesis&) = delete;
  Synthesis& operator=(const Synthesis&) = delete;

  /// Without the monitor pins (mon_...). Registers get no enable and no reset of their own, which
  /// become gates. Memories of one written place and at most two that are read stay memories.
  /// Throws std::runtime_error where Yosys fails.
  Netlist map(const Circuit& circuit) const;

 private:
  std::filesystem::path folder_;  // the sources, and what passes between the programs
};

}  // namespace cigsim::gates
