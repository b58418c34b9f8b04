// SPDX-License-Identifier: MIT
// Ctrl-C (and a request to terminate) between two frames instead of within one.
#pragma once

namespace cigsim {

/// While one exists, the first signal only sets a mark; a second one ends the program at once.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// The signal that arrived, or 0.
  int signal() const;
};

}  // namespace cigsim
