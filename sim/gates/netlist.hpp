// SPDX-License-Identifier: MIT
// A netlist of parts as Yosys writes it in JSON: what it takes, and its longest way.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace cigsim::gates {

struct Inventory {
  std::map<std::string, std::uint64_t, std::less<>> gates;  ///< by the part's name
  std::uint64_t flip_flops = 0;
  std::uint64_t ram_bits = 0;      ///< of memories
  std::uint64_t ram_packages = 0;  ///< a copy for each place that is read at once

  std::uint64_t gate_count() const;
  /// Each kind of part has packages of its own.
  std::uint64_t packages() const;
  friend bool operator==(const Inventory&, const Inventory&) = default;
};

/// What a step on a way takes.
struct Delays {
  double gate = 1;  ///< a gate level
  double ram = 0;   ///< reading a RAM
};

class Netlist {
 public:
  /// Throws std::runtime_error where the text is no netlist of parts.
  explicit Netlist(const std::string& json);
  ~Netlist();
  Netlist(Netlist&&) noexcept;

  /// The module named so in the source, which must be there once; with all that is in it.
  Inventory inventory(const std::string& module) const;
  /// From inputs, and outputs of flip-flops, to outputs, and inputs of flip-flops and RAMs.
  double longest_way(const std::string& module, const Delays& delays) const;

 private:
  struct Modules;
  std::unique_ptr<Modules> modules_;
};

}  // namespace cigsim::gates
