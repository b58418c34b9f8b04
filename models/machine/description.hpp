// SPDX-License-Identifier: MIT
// The machine description: clock, capacities, link depths, word formats and the frame calculator's
// costs of one machine. Every figure carries its source and its standing (docs/machine.md).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "models/boundary/cycle.hpp"
#include "models/boundary/transactions.hpp"
#include "models/numeric/machine_word.hpp"

namespace cigsim {

enum class Standing { kPublished, kRecalled, kDerived, kReconstruction };

struct Provenance {
  Standing standing = Standing::kReconstruction;
  std::string source;
};

/// What the machine does when a frame is more than it can hold or finish (reconstruction).
/// Beyond the edge, face and object memories the detail of lowest priority is always dropped.
enum class OverloadPolicy {
  kDrop,   ///< overfull lines lose their faces of lowest priority; frame 2 ends at its deadline
  kCut,    ///< overfull lines are cut after the crossing that still fits; frame 2 as kDrop
  kExtend  ///< lines take further passes, frames last until all is done
};

/// Capacities of 0 mean "no limit".
struct MachineDescription {
  std::string name, title;

  double clock_ns = 125;
  Cycle frame_cycles = 0;  ///< from one frame start to the next at least; 0: as soon as all is done
  Cycle line_cycles = 0;   ///< from one raster line to the next at least; 0: no fixed raster
  Raster raster;
  std::uint32_t elements_per_cycle = 4;

  std::uint32_t object_capacity = 0;    ///< items in the priority list of a frame
  std::uint32_t face_capacity = 0;      ///< front faces of a frame
  std::uint32_t edge_capacity = 0;      ///< edges of a frame
  std::uint32_t crossing_capacity = 0;  ///< crossings of a raster line
  std::uint32_t vertex_capacity = 0;    ///< vertices of an item
  std::uint32_t corner_capacity = 0;    ///< corners of a face
  std::uint32_t hierarchy_depth = 0;    ///< levels of groups

  struct LinkDepths {  ///< transactions that a link holds, >= 1
    std::uint32_t items = 4, edges = 16, faces = 4, crossings = 16, spans = 16;
  } links;

  WordFormats formats;
  Word hither = 256;          ///< smallest u of a visible point, in coordinate units of the machine
  Cycle deadline_margin = 0;  ///< frame 2 begins no face in the last so many cycles of a frame

  struct FrameCalculatorCosts {  ///< cycles
    Cycle frame = 0, sphere = 0, vertex = 0;
  } frame_calculator;

  /// By the name of the figure in JSON ("clock_ns", "links.items", "formats.coordinate_bits", …).
  std::map<std::string, Provenance> provenance;

  /// Cycles of a frame in which no raster line begins.
  Cycle vertical_blanking() const {
    const Cycle rest = frame_cycles - line_cycles * raster.height;
    return rest > 0 ? rest : 0;
  }
};

/// "nasa1968", "asupt1975", "unlimited".
const std::vector<std::string>& machine_presets();
/// A preset's description. Throws std::invalid_argument for another name, naming those there are.
MachineDescription machine_preset(std::string_view name);
/// A figure as tables list it.
struct MachineFigure {
  std::string name, unit;
  double value = 0;
  Provenance provenance;
};
/// Every figure in the order of the file.
std::vector<MachineFigure> machine_figures(const MachineDescription& machine);
/// Why the figures cannot all hold (lines and frame, elements and line) and what to do, or "".
std::string machine_contradiction(const MachineDescription& machine);
/// What is allowed but worth knowing, a sentence each: full lines that take longer than a line.
std::vector<std::string> machine_notices(const MachineDescription& machine);
/// A preset by its name or else a file. Throws InputError (file, line, what, what to do).
MachineDescription load_machine(const std::string& preset_or_file);
/// The description as its JSON file, with every figure's source and standing.
std::string machine_json(const MachineDescription& machine);
/// The same machine with another raster. The frame stays as long as it is; so do the lines where
/// they all fit into it, else each has as many cycles as the frame leaves room for. Throws
/// std::invalid_argument with a clear sentence when a line is then too short for its elements.
MachineDescription with_raster(const MachineDescription& machine, const Raster& raster);
std::string_view name_of(Standing standing);
std::string_view name_of(OverloadPolicy policy);

}  // namespace cigsim
