// SPDX-License-Identifier: MIT
// What the shared library of a Verilated module gives the program: a table of functions, and a
// block of pins (the module's pins.hpp). Plain data only, so that a library that was built on
// demand, by another compiler perhaps, fits.
//
// Why no Verilated SystemC module: the stages sit in the pipeline as SystemC modules
// (models/STAGE/rtl.hpp) that drive the plain class behind this table. That is three to four times
// faster than Verilator's own wrapper, one form serves the pipeline and bulk vectors, and SystemC's
// types need not cross the border of a library.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cigsim::rtl {

inline constexpr std::uint32_t kInterfaceVersion = 2;

/// Takes a piece of a wave file.
using WriteWave = void (*)(void* context, const char* text, std::size_t size);

struct Interface {
  std::uint32_t version;    ///< kInterfaceVersion
  std::uint32_t pins_size;  ///< bytes of the block of pins
  /// `seed`, not zero, gives registers without reset their first values.
  void* (*create)(std::uint32_t seed);
  void (*destroy)(void* model);
  /// The block of pins: inputs are read by edge() and settle(), outputs are written by them.
  void* (*pins)(void* model);
  /// A rising clock edge with the inputs as they stand; the outputs then are those of the next
  /// cycle, under the same inputs.
  void (*edge)(void* model);
  /// The outputs for inputs that changed within a cycle.
  void (*settle)(void* model);
  /// Waves as a value change dump. `open`, once: the declarations go to `write`; then each `dump`,
  /// at a later `time` than the one before, writes what changed, and `close` ends it.
  void (*wave_open)(void* model, WriteWave write, void* context);
  void (*wave_dump)(void* model, std::uint64_t time);
  void (*wave_close)(void* model);
  /// Writes the coverage of this model to `file`; null in libraries built without coverage.
  void (*write_coverage)(void* model, const char* file);
};

}  // namespace cigsim::rtl

/// The one symbol of a library.
extern "C" const cigsim::rtl::Interface* cigsim_rtl_interface();
