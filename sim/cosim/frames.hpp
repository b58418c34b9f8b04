// SPDX-License-Identifier: MIT
// Whole frames with RTL stages, in lock-step: every RTL stage beside a clocked twin on the same
// pins, compared in every cycle; every link against that of a timed machine, word by word in value
// and cycle; every picture against the functional level on machine words.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "models/boundary/mismatch.hpp"
#include "sim/cosim/plan.hpp"
#include "sim/rtl/library.hpp"
#include "sim/wave/wave_options.hpp"

namespace cigsim::cosim {

/// Stage of a mismatch that is a broken contract within the RTL. Neither plan nor frame are known.
inline constexpr std::string_view kAnyStage = "rtl";
/// How the message of a broken contract ends (rtl/common/shim.hpp).
inline constexpr std::string_view kBrokenContract = "a contract of the RTL is broken";

struct FramesResult {
  std::uint64_t frames = 0;    ///< pictures that left the machine
  std::uint64_t pictures = 0;  ///< of these, compared with the functional level
  std::uint64_t words = 0;     ///< handed over on links, and compared
  std::uint64_t elements = 0;  ///< compared
  Cycle cycles = 0;            ///< in which pins were compared
  double seconds = 0;
  std::optional<Mismatch> mismatch;  ///< the run ended there
  std::size_t plan = 0;              ///< in which it was
};

struct FramesOptions {
  Say say;                          ///< told when RTL must be built
  std::optional<WaveRequest> wave;  ///< of the first plan
  /// Cycles to go on for after a difference, so that a wave shows what follows.
  Cycle after = 0;
  std::function<void(double share)> progress;
};

/// Runs the plans side by side. One simulation a process. A frame of which time decided what is in
/// it (faces dropped at the deadline of frame 2) is not compared with the functional level, which
/// knows no time. Throws std::runtime_error when the RTL is too small for a frame.
FramesResult compare_frames(std::span<const ComparePlan> plans, const FramesOptions& options);

}  // namespace cigsim::cosim
