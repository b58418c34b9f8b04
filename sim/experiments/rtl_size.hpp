// SPDX-License-Identifier: MIT
// The SO engine in RTL sized to a scene beside one of 256 x 256: what its build, its library and a
// row of the matrix cost.
#pragma once

#include <cstdint>
#include <functional>

#include "models/database/database.hpp"
#include "sim/measure/interleave.hpp"
#include "sim/rtl/variant.hpp"

namespace cigsim {

struct RtlSizeSide {
  RtlVariant variant;
  double build_s = 0;
  double library_mib = 0;
  Spread row_us;  ///< host time of a cycle, which answers a row
};

struct RtlSize {
  RtlSizeSide sized, fixed;
  bool golden = true;  ///< both gave what the golden model gives
};

/// Builds both anew, in a folder of their own that is removed again: about a minute and a half.
/// `rows`: of the matrix to compute, a round. Throws UsageError where Verilator or a compiler is
/// missing or fails.
RtlSize measure_rtl_size(const Database& database, std::uint64_t rows, std::size_t rounds,
                         std::uint64_t seed, const std::function<void(const std::string&)>& say);

}  // namespace cigsim
