// SPDX-License-Identifier: MIT
// The second simulator: a module of rtl/ under Icarus Verilog, fed a row of inputs a clock.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cigsim::test {

struct IcarusPort {
  std::string name;
  unsigned bits = 1;  ///< 1 to 64
};

/// A module that has clk_i and the ports listed.
struct IcarusModule {
  std::string name;
  std::vector<std::string> files;  ///< below rtl/
  std::vector<IcarusPort> inputs, outputs;
  std::vector<std::string> parameters;  ///< "Name(Value)"
};

/// Whether Icarus was there when the tests were configured. A test that needs it is skipped
/// otherwise.
bool has_icarus();

/// For each row of inputs, in the order of the ports, the outputs under these inputs; then comes a
/// rising clock edge. Nothing for an output of which a bit is unknown. Throws std::runtime_error,
/// with what Icarus said, when it does not accept the module.
std::vector<std::vector<std::optional<std::uint64_t>>> run_icarus(
    const IcarusModule& module, const std::vector<std::vector<std::uint64_t>>& rows);

}  // namespace cigsim::test
