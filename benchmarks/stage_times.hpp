// SPDX-License-Identifier: MIT
// Host time of each stage over many frames.
#pragma once

#include <time.h>

#include <algorithm>
#include <vector>

#include "sim/functional_machine.hpp"

namespace cigsim::benchmarks {

struct Stage {
  const char* name;
  double StageTimes::*time;
};
inline constexpr Stage kStages[] = {{"frame_calculator", &StageTimes::frame_calculator},
                                    {"geometry_processor", &StageTimes::geometry_processor},
                                    {"priority_processor", &StageTimes::priority_processor},
                                    {"edge_orderer", &StageTimes::edge_orderer},
                                    {"priority_resolver", &StageTimes::priority_resolver},
                                    {"video_processor", &StageTimes::video_processor}};

/// Milliseconds that this thread has computed: other programs on the machine do not count.
inline double thread_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Median milliseconds of a figure of each frame.
template <class Frames, class Figure>
double median_of(const Frames& frames, Figure figure) {
  std::vector<double> times;
  for (const auto& frame : frames) times.push_back(figure(frame));
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

}  // namespace cigsim::benchmarks
