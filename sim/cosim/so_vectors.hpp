// SPDX-License-Identifier: MIT
// The SO matrix in RTL (rtl/priority_processor/so_engine.sv) in lock-step with its golden model:
// both are stepped together, and every output is compared in every cycle. A vector is one row of
// the matrix for one eyepoint: one cycle, and one pair for each other active object.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "models/boundary/rtl_model.hpp"
#include "sim/cosim/so_cases.hpp"

namespace cigsim::cosim {

/// A fault on purpose: a bit of an output of the RTL that is always the same.
struct SoStuckBit {
  std::string output;  ///< a pin of so_engine.pins.hpp, such as "answer_hides_o"
  unsigned bit = 0;
  bool value = true;
};

/// Throws std::invalid_argument where an engine for `objects` has no such output, or not the bit.
void check_stuck(const SoStuckBit& fault, unsigned objects);

struct SoVectorOptions {
  std::filesystem::path library;       ///< of so_engine
  unsigned objects = 64, planes = 64;  ///< as the library was built; at most 256 each
  std::uint64_t vectors = 100'000;     ///< at least so many; the last eyepoint is answered in full
  std::uint32_t seed = 1;              ///< not zero; of the vectors, and of registers without reset
  bool compare = true;                 ///< false: RTL alone, to know what the comparison costs
  std::optional<SoStuckBit> stuck{};
  /// Called once, before the first cycle, such as to open waves.
  std::function<void(RtlModel&)> begin{};
  /// Called after each cycle, also the one that differs; slow.
  std::function<void(RtlModel&, std::uint64_t cycle)> each_cycle{};
  /// Called now and then with the vectors done; false ends the run.
  std::function<bool(std::uint64_t vectors)> progress{};
};

struct SoMismatch {
  std::uint64_t vector = 0;   ///< from 0; where no row is due: of the next row
  std::uint64_t cycle = 0;    ///< from 0, the first one after reset
  unsigned row = 0;           ///< object of the row that is due
  std::string field;          ///< pin of so_engine.pins.hpp, or "contract"
  std::string expected, got;  ///< bits as hexadecimal numbers, counts as decimal ones
  SoCase inputs;
};

struct SoVectorResult {
  std::uint64_t cycles = 0, vectors = 0, pairs = 0;
  double seconds = 0;
  std::optional<SoMismatch> mismatch;  ///< the run ended there
};

/// Random vectors of all kinds (so_cases.hpp). A broken contract of the RTL is a mismatch. Throws
/// std::runtime_error when the library cannot be loaded, std::invalid_argument when an option
/// cannot be.
SoVectorResult run_so_vectors(const SoVectorOptions& options);

/// A mismatch comes again at the same cycle with the same options. This is one case alone, its rows
/// written and then answered once; `vectors` of the options does not count.
SoVectorResult replay_so_case(const SoVectorOptions& options, const SoCase& inputs);

}  // namespace cigsim::cosim
