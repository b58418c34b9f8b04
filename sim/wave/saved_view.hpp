// SPDX-License-Identifier: MIT
// Saved views of the viewer GTKWave (.gtkw): which signals, in which order, under which headings,
// in which radix, with which names for values.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/wave/radix.hpp"

namespace cigsim {

/// A row of a view from the top.
struct ViewRow {
  enum class Kind { kSignal, kHeading, kBlank };
  Kind kind = Kind::kSignal;
  std::string text;   ///< the signal's name in the wave file, or the heading
  std::string label;  ///< the name to show, if another
  Radix radix = Radix::kHexadecimal;
  int line = 0;            ///< of the file, from 1
  std::string names = "";  ///< the file with the names of its values (value_names.hpp), if any
  friend bool operator==(const ViewRow&, const ViewRow&) = default;
};

/// Times, sizes, colours, filters that are programs, and the state of the viewer's window are left
/// out. Throws InputError with the line for what cannot be shown here (signals put together from
/// others) and for what is no saved view; `name` is the file.
std::vector<ViewRow> parse_saved_view(std::string_view text, const std::string& name);

}  // namespace cigsim
