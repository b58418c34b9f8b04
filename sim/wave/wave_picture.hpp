// SPDX-License-Identifier: MIT
// A window of waves as a picture for documents: SVG without scripts, in the fonts of the reader's
// system, on white.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/wave/saved_view.hpp"
#include "sim/wave/value_names.hpp"
#include "sim/wave/wave.hpp"

namespace cigsim {

struct WavePictureRow {
  ViewRow::Kind kind = ViewRow::Kind::kSignal;
  std::string label;  ///< of a signal or heading
  Radix radix = Radix::kHexadecimal;
  std::size_t trace = 0;                              ///< of a signal: its place in the wave
  std::shared_ptr<const ValueNames> names = nullptr;  ///< of its values, if it has any
};

struct WavePictureOptions {
  double cycle_ns = 125;  ///< the vertical lines: cycle n begins at n times this
  int width = 1200;       ///< of the picture, >= 400
};

/// Signals of one bit are levels, wider ones boxes with their values; x is red, z is a line in the
/// middle. Where changes are too close to be told apart, the signal is a filled bar. Throws
/// std::invalid_argument for a window without length.
std::string wave_picture(const Wave& wave, const std::vector<WavePictureRow>& rows,
                         const WavePictureOptions& options);

/// Names without the scopes that all of them share, and then without those that all but the names
/// without a scope share ("clock" beside the signals of a module). Different names stay different.
std::vector<std::string> short_names(const std::vector<std::string>& names);

}  // namespace cigsim
