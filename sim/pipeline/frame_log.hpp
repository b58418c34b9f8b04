// SPDX-License-Identifier: MIT
// The frames in a SystemC machine: where they come from, what its stages tell of them, and where
// their pictures go. The pictures in the machine are at most three, so that figures have four
// places by turns.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>

#include "models/frame_calculator/memory_loader.hpp"
#include "sim/host_time.hpp"
#include "sim/systemc_machine.hpp"

namespace cigsim {

class FrameLog {
 public:
  /// Frames for the coming simulation.
  void feed(SystemcMachine::Next next, SystemcMachine::Out out);

  /// Frame `frame` is to be calculated; false: there is none.
  bool next(std::uint32_t frame);
  /// Frame start k happened in that cycle.
  void started(std::uint32_t k, Cycle cycle);
  frame_calculator::Work calculate(frame_calculator::MemoryLoader& loader, std::uint32_t frame);
  /// The picture of a frame, which stays valid until the next, was shown from one cycle to another.
  void shown(std::uint32_t frame, const Picture& picture, Cycle first, Cycle last,
             Cycle frame_cycles);

  /// A stage has done its part of a frame; `fill` notes its figures. When all have, the picture is
  /// delivered.
  template <class Figures, class Fill>
  void note(Stage stage, const Figures& figures, Fill fill) {
    FrameStats& stats = stats_of(figures.frame);
    const auto s = static_cast<std::size_t>(stage);
    stats.timing->activity[s] = figures.activity;
    stats.overload->overflows[s] = figures.overflows;
    fill(stats);
    std::size_t& reports = reports_[figures.frame % reports_.size()];
    if (++reports < kStageCount) return;
    reports = 0;
    deliver(stats);
  }

  /// What a callback of feed(), or the calculation of a frame, threw.
  std::exception_ptr failure;

 private:
  FrameStats& stats_of(std::uint32_t frame) { return stats_[frame % stats_.size()]; }
  void deliver(FrameStats& stats);

  SystemcMachine::Next next_;
  SystemcMachine::Out out_;
  const Picture* picture_ = nullptr;  // the last that was shown
  std::optional<FrameJob> job_;
  std::array<FrameStats, 4> stats_;
  std::array<std::size_t, 4> reports_{};  // stages that have done their part
  std::uint32_t frames_ = 0;              // begun
  Cycle last_start_ = 0;
  HostTime time_;
};

}  // namespace cigsim
