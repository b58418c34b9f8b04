// SPDX-License-Identifier: MIT
// The pipeline in SystemC: every stage at its level, links between them, and three pictures in the
// machine at any time. Cycle-exact; pictures come out in the order in which frames went in.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/boundary/link.hpp"
#include "models/boundary/transactions.hpp"
#include "models/database/database.hpp"
#include "models/machine/description.hpp"
#include "sim/frame_stats.hpp"
#include "sim/level.hpp"
#include "sim/wave/recorder.hpp"

namespace cigsim {

/// A frame to compute.
struct FrameJob {
  const Database* database = nullptr;  ///< must outlive the frame
  Viewpoint viewpoint;
  double position = 0;  ///< the frame at which moving models stand
};

struct PipelineOptions {
  MachineDescription description;
  OverloadPolicy overload = OverloadPolicy::kDrop;
  double eye_reach = 0;  ///< as coordinate_scale()
  LevelChoice levels;    ///< none functional
  StallFunction stalls;  ///< holds words back on the links (tests)
};

/// SystemC has one simulation a process: make all machines before the first simulate().
class SystemcMachine {
 public:
  /// The next frame, or nothing when there is none.
  using Next = std::function<std::optional<FrameJob>()>;
  /// A picture has left the machine. It is valid during the call.
  using Out = std::function<void(const Picture&, const FrameStats&)>;

  /// `name` must be unique in the simulation.
  SystemcMachine(const std::string& name, const PipelineOptions& options);
  ~SystemcMachine();

  /// Frames for the coming simulate().
  void feed(Next next, Out out);

  /// Runs all machines of the process until none has anything to do. Passes on what the callbacks
  /// of these threw.
  static void simulate(const std::vector<SystemcMachine*>& machines);

  // For tests and waves.

  /// Calls `probe` for every word of every link: link, word as text, cycles pushed and taken.
  using Probe = std::function<void(const std::string& link, const std::string& word, Cycle pushed,
                                   Cycle taken)>;
  void set_probe(const Probe& probe);

  /// Records waves of the coming simulate() into `out`, which must outlive it: pins and registers
  /// of `stages`, which must be clocked. To be called once.
  void record(std::ostream& out, const CycleWindow& window, const std::vector<Stage>& stages);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cigsim
