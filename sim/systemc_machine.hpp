// SPDX-License-Identifier: MIT
// The pipeline in SystemC: every stage at its level, links between them, and three pictures in the
// machine at any time. Cycle-exact; pictures come out in the order in which frames went in.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/boundary/link.hpp"
#include "models/boundary/mismatch.hpp"
#include "models/boundary/stuck_bit.hpp"
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
  double detail = 1;     ///< as MachineOptions
  LevelChoice levels;    ///< none functional
  StallFunction stalls;  ///< holds words back on the links (tests)
  /// Of each stage at the RTL level: its library, of a size that holds all frames. Registers
  /// without reset begin with values from the seed, which is not 0.
  std::map<Stage, std::filesystem::path> libraries;
  std::uint32_t rtl_seed = 1;
  /// When set, every RTL stage has a clocked twin on the same pins; this is told where they first
  /// differ.
  MismatchFunction lockstep;
  /// A bit of an RTL stage's output pins that is stuck.
  std::optional<std::pair<Stage, StuckBit>> stuck;
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

  /// Runs all machines of the process until none has anything to do, or one has called stop().
  /// Passes on what the callbacks of these threw, and what the RTL did.
  static void simulate(const std::vector<SystemcMachine*>& machines);

  /// To be called while it simulates: ends it `cycles` cycles later.
  void stop(Cycle cycles);
  /// Cycles that the clock has counted.
  Cycle cycles() const;

  /// Compares every word on every link, and its cycles, with those of `expected`, a machine of the
  /// same links and frames, in the coming simulate(). To be called once.
  void check_links(SystemcMachine& expected, const MismatchFunction& report);
  /// After simulate(): reports words that only one of the two had. Returns how many were compared.
  std::uint64_t finish_checks();

  // For tests and waves.

  /// Calls `probe` for every word of every link: link, word as text, cycles pushed and taken.
  using Probe = std::function<void(const std::string& link, const std::string& word, Cycle pushed,
                                   Cycle taken)>;
  void set_probe(const Probe& probe);

  /// Records waves of the coming simulate() into `out`, which must outlive it: pins and registers
  /// of `stages`, which must have pins. To be called once.
  void record(std::ostream& out, const CycleWindow& window, const std::vector<Stage>& stages);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cigsim
