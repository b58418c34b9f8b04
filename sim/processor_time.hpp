// SPDX-License-Identifier: MIT
// A stopwatch for the processor time of the calling thread, in milliseconds: what other programs
// take of the host meanwhile does not count.
#pragma once

#include <ctime>

namespace cigsim {

class ProcessorTime {
 public:
  /// Since the last lap, or since the start.
  double lap() {
    const double now = read(), ms = now - lap_;
    lap_ = now;
    return ms;
  }

 private:
  static double read() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
  }
  double lap_ = read();
};

}  // namespace cigsim
