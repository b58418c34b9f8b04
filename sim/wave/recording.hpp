// SPDX-License-Identifier: MIT
// The files of a recording: the wave, and a view of it for GTKWave.
#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "sim/wave/wave_options.hpp"

namespace cigsim {

/// Runs `record`, which writes a value change dump, into the request's file: beside it first, then
/// renamed; an .fst file through the program vcd2fst. Then saves the view, named alike with the
/// ending .gtkw, and beside it the names of values that the view shows. Throws InputError and
/// leaves no part of the wave where it cannot be written.
void write_wave(const WaveRequest& request, const std::function<void(std::ostream&)>& record);

/// The file of the saved view.
std::string view_file(const WaveRequest& request);

/// What shows the recording in a window.
std::string view_command(const WaveRequest& request);

}  // namespace cigsim
