// SPDX-License-Identifier: MIT
// A progress bar on standard error for long work. Silent unless that is a terminal.
#pragma once

#include <chrono>
#include <string>

namespace cigsim {

class Progress {
 public:
  explicit Progress(std::string label);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `share` of the work is done, 0 to 1. Nothing is shown during the first half second.
  void show(double share);

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point next_;
};

}  // namespace cigsim
