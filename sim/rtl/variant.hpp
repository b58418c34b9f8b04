// SPDX-License-Identifier: MIT
// Which size of a stage's RTL a scene requires.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/database/database.hpp"
#include "models/machine/description.hpp"
#include "sim/level.hpp"

namespace cigsim {

/// A module of rtl/ at a size.
struct RtlVariant {
  struct Parameter {
    std::string name;
    std::uint32_t value = 0;
    friend bool operator==(const Parameter&, const Parameter&) = default;
  };

  std::string stage, module;  ///< rtl/STAGE/MODULE.sv
  std::vector<Parameter> parameters;

  /// "MODULE-Name=Value-Name=Value"
  std::string name() const;
  /// Holds all that `other`, a size of the same module, holds.
  bool covers(const RtlVariant& other) const;
  friend bool operator==(const RtlVariant&, const RtlVariant&) = default;
};

/// What scenes ask of the RTL at most.
struct RtlNeeds {
  std::uint32_t members = 2;  ///< of a group
  std::uint32_t planes = 1;   ///< of a group
  std::uint32_t levels = 1;   ///< of groups
  std::uint64_t faces = 1, edges = 2;

  /// Pieces of moving models are cut anew in each frame: four times their faces are allowed for.
  /// Clipping gives a face at most five corners more.
  static RtlNeeds of(const Database& database);
  RtlNeeds with(const RtlNeeds& other) const;
};

/// Sizes are powers of two, so that few of them are built. Throws std::logic_error for a stage that
/// has no RTL.
RtlVariant rtl_variant(Stage stage, const RtlNeeds& needs, const MachineDescription& machine);

/// The SO engine for groups of `objects` and `planes` (1 to 256 each).
RtlVariant so_engine_variant(std::uint32_t objects, std::uint32_t planes);
/// The SO engine for the groups of a scene; a power of two each, at most 256.
RtlVariant so_engine_variant(const RtlNeeds& needs);

}  // namespace cigsim
