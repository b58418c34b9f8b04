// SPDX-License-Identifier: MIT
// One setting over some frames, once, in a process of its own: time, cycles, memory, errors.
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "models/boundary/cycle.hpp"
#include "sim/measure/overload_sum.hpp"
#include "sim/measure/picture_error.hpp"
#include "sim/measure/setting.hpp"
#include "sim/view.hpp"

namespace cigsim {

/// The frames to compute, at least one.
struct Workload {
  const Database* database = nullptr;
  std::vector<FrameView> views;
  /// The right picture of each view, or none.
  const std::vector<ReferencePicture>* references = nullptr;
};

struct Trial {
  /// Of each view, host milliseconds (FrameStats::host_ms; of a short frame the median of several
  /// times). The machine is warm: it has computed another frame before, and at levels that know
  /// time its pipeline is full throughout.
  std::vector<double> frame_ms;
  double memory_mib = 0;  ///< most that the machine held beyond what the database takes
  /// At levels that know time: FrameTiming::transport_delay() of each view, with these views one
  /// after the other in the machine, and how many cycles were simulated in the time of frame_ms.
  std::vector<Cycle> delays;
  Cycle cycles = 0;
  std::vector<PictureError> errors;  ///< of each view, where there are references
  OverloadSum overload;              ///< of these views
  std::uint64_t digest = 0;          ///< of the pictures: equal ones have equal digests
};

/// `libraries` as rtl_libraries(). Throws MeasureError as in_child(), naming the setting.
Trial run_trial(const Setting& setting, const Workload& work,
                const std::map<Stage, std::filesystem::path>& libraries, double limit_s);

}  // namespace cigsim
