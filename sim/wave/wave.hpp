// SPDX-License-Identifier: MIT
// A window of a wave file in memory: signals and the changes of their values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cigsim {

/// Counted in the wave file's own unit.
using WaveTime = std::uint64_t;

/// A signal that a wave file declares.
struct WaveSignal {
  std::string name;         ///< with its scopes: "SystemC.cigsim.priority_resolver.at"
  std::string range;        ///< as declared: "[15:0]", or empty
  std::uint32_t width = 1;  ///< bits; of a real number 64
  bool real = false;
  friend bool operator==(const WaveSignal&, const WaveSignal&) = default;
};

struct WaveChange {
  WaveTime time = 0;
  /// `width` digits of 0, 1, x, z, the highest first; of a real number its text.
  std::string value;
  friend bool operator==(const WaveChange&, const WaveChange&) = default;
};

struct WaveTrace {
  WaveSignal signal;
  /// In order of time, each with a value of its own. The first one, at the window's start, is the
  /// value from before unless the signal had none.
  std::vector<WaveChange> changes;
};

/// Nanoseconds. Without an end it reaches to that of the file.
struct WaveWindow {
  std::optional<double> from, to;
};

struct Wave {
  double unit_ns = 1;            ///< length of the file's unit
  WaveTime first = 0, last = 0;  ///< what of the window the file covers
  std::vector<WaveTrace> traces;
};

}  // namespace cigsim
