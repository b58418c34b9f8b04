// SPDX-License-Identifier: MIT
// The links of the machine (docs/machine.md, "Links"), each with what its two ends need.
#pragma once

#include <memory>
#include <vector>

#include "models/boundary/link_check.hpp"
#include "sim/pipeline/connection.hpp"
#include "sim/systemc_machine.hpp"

namespace cigsim {

struct Connections {
  /// Links of the machine's depths, with pins where the stage at an end has them.
  Connections(const PipelineOptions& options, const Clock& clock);
  ~Connections();

  /// Calls `probe` for every word of every link.
  void set_probe(const SystemcMachine::Probe& probe);

  /// Compares every word, and its cycles, with those on the links of `expected`. `raster_lines`: of
  /// a frame.
  std::vector<std::unique_ptr<LinkCheckBase>> check(Connections& expected,
                                                    std::uint32_t raster_lines,
                                                    const MismatchFunction& report);

  // Between the frame sequencer and the stages.
  Connection<FrameWord> start_calculator, calculated, start_priority, start_geometry, start_orderer,
      start_video, edges_loaded, faces_loaded, shown;
  // Between stages.
  Connection<ItemWord> items;
  Connection<EdgeWord> edges;
  Connection<FaceWord> faces;
  Connection<CrossingWord> crossings;
  Connection<SpanWord> spans;
};

}  // namespace cigsim
