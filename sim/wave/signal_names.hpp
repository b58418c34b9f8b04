// SPDX-License-Identifier: MIT
// Finding signals of a wave file by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/wave/wave.hpp"

namespace cigsim {

class SignalNames {
 public:
  /// `signals` must stay.
  explicit SignalNames(const std::vector<WaveSignal>& signals) : signals_(signals) {}

  /// The place of the signal `name`: its whole name, or as many of the last parts as make it
  /// unique ("priority_resolver.at"); its range may be left out. Several declarations of one name
  /// are one signal. Throws std::invalid_argument with near names, or with those that fit.
  std::size_t find(std::string_view name) const;

 private:
  std::vector<std::string_view> nearest(std::string_view name) const;

  const std::vector<WaveSignal>& signals_;
};

}  // namespace cigsim
