// SPDX-License-Identifier: MIT
// A stage in its place in the machine, whichever its level.
#pragma once

#include <memory>
#include <systemc>

#include "models/frame_calculator/memory_loader.hpp"
#include "sim/pipeline/connections.hpp"
#include "sim/pipeline/frame_log.hpp"

namespace cigsim {

class PlacedStage {
 public:
  virtual ~PlacedStage() = default;
  /// Its pins and registers, where its level has them, into a wave file.
  virtual void trace(sc_core::sc_trace_file* file) = 0;
};

/// What a machine has for its stages. A stage may copy it: what it refers to outlives the stages.
struct Site {
  const PipelineOptions& options;
  Clock& clock;
  frame_calculator::MemoryLoader& loader;
  Connections& connections;
  FrameLog& frames;
};

/// Makes the stage at the level that the options choose and connects it. What it tells of a frame
/// goes to the log of frames. Throws std::logic_error for a level that the stage has not.
std::unique_ptr<PlacedStage> place(Stage stage, const Site& site);

}  // namespace cigsim
