// SPDX-License-Identifier: MIT
#include "sim/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace cigsim {

using namespace std::chrono_literals;

Progress::Progress(std::string label)
    : label_(std::move(label)),
      terminal_(isatty(STDERR_FILENO) == 1),
      next_(Clock::now() + 500ms) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(double share) {
  if (!terminal_ || Clock::now() < next_) return;
  next_ = Clock::now() + 100ms;
  shown_ = true;
  constexpr int kWidth = 30;
  share = std::clamp(share, 0.0, 1.0);
  fmt::print(stderr, "\r{} [{:<{}}] {:3.0f} %", label_,
             std::string(static_cast<std::size_t>(share * kWidth), '#'), kWidth, share * 100);
  std::fflush(stderr);
}

}  // namespace cigsim
