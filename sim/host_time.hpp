// SPDX-License-Identifier: MIT
// A stopwatch for the host's time, in milliseconds.
#pragma once

#include <chrono>

namespace cigsim {

class HostTime {
 public:
  /// Since the last lap, or since the start.
  double lap() {
    const Clock::time_point now = Clock::now();
    const double ms = milliseconds(lap_, now);
    lap_ = now;
    return ms;
  }
  /// From the start to the last lap.
  double total() const { return milliseconds(start_, lap_); }

 private:
  using Clock = std::chrono::steady_clock;
  static double milliseconds(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
  }
  Clock::time_point start_ = Clock::now(), lap_ = start_;
};

}  // namespace cigsim
