// SPDX-License-Identifier: MIT
// Finds, or builds, the library of an RTL variant: among the sizes that ship with the program,
// among those built before, or with Verilator now.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "sim/rtl/variant.hpp"

namespace cigsim {

/// A line for the user, without an end of line.
using Say = std::function<void(const std::string&)>;

/// Says on standard error.
void say_on_stderr(const std::string& line);

struct RtlLibrary {
  std::filesystem::path file;
  RtlVariant variant;  ///< the size that it has
};

/// The smallest size that ships and covers `wanted`.
std::optional<RtlVariant> shipped_rtl(const RtlVariant& wanted);

/// The library that holds `variant`: of exactly this size where possible. What is built goes into
/// the folder that CIGSIM_RTL_CACHE names (default: cigsim/rtl in the user's cache folder), under a
/// name that has a hash of its sources, so that it is built once. Where Verilator or the compiler
/// is missing or fails, the nearest larger size that ships is taken, and said. Throws UsageError
/// where there is none either.
RtlLibrary rtl_library(const RtlVariant& variant, const Say& say);

/// Builds `library` now, whatever is there already, in its folder, which exists and is written to
/// by nobody else. False where that fails, with what was said in `log`. Throws std::runtime_error
/// where the build cannot be started.
bool build_rtl_library(const RtlVariant& variant, const std::filesystem::path& library,
                       const std::filesystem::path& log);

}  // namespace cigsim
