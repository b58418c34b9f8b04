// SPDX-License-Identifier: MIT
// The coverage of all RTL models of a process in one file.
#pragma once

#include <filesystem>
#include <functional>

namespace cigsim {

/// Adds what `write` writes, a file of Verilator's coverage of one model. At the end of the process
/// the sums go to a file in the folder CIGSIM_RTL_COVERAGE. Does nothing without that variable.
void add_rtl_coverage(const std::function<void(const std::filesystem::path&)>& write);

}  // namespace cigsim
