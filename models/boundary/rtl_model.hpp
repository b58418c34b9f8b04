// SPDX-License-Identifier: MIT
// A Verilated module in a shared library (rtl/common/interface.hpp), loaded while the program runs.
// Two variables of the environment let every program that uses RTL measure it, or run another one:
//   CIGSIM_RTL_COVERAGE  a folder: each process writes the coverage of all its models there
//   CIGSIM_RTL_INSTEAD   a folder: its libraries are loaded instead of those of the same names
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

#include "rtl/common/interface.hpp"

namespace cigsim {

/// The module with its clock, without SystemC. Pins is the block of the module's MODULE.pins.hpp.
class RtlModel {
 public:
  /// `seed`, not zero: registers without reset begin with values from it. Throws std::runtime_error
  /// with a clear sentence when the library cannot be loaded or is of another version.
  RtlModel(const std::filesystem::path& library, std::size_t pins_size, std::uint32_t seed);
  ~RtlModel();
  RtlModel(const RtlModel&) = delete;
  RtlModel& operator=(const RtlModel&) = delete;

  template <class Pins>
  Pins& pins() {
    return *static_cast<Pins*>(pins_);
  }
  template <class Pins>
  const Pins& pins() const {
    return *static_cast<const Pins*>(pins_);
  }

  /// A rising clock edge, and the outputs of the next cycle. Throws std::runtime_error when a
  /// contract of the RTL is broken (rtl/common/assertions.svh).
  void edge() { table_->edge(model_); }
  /// The outputs for inputs that changed within a cycle.
  void settle() { table_->settle(model_); }

  using WriteWave = std::function<void(std::string_view)>;
  /// As the functions of rtl::Interface.
  void wave_open(WriteWave write);
  void wave_dump(std::uint64_t time) { table_->wave_dump(model_, time); }
  void wave_close() { table_->wave_close(model_); }

 private:
  const rtl::Interface* table_ = nullptr;
  void* model_ = nullptr;
  void* pins_ = nullptr;
  WriteWave write_;
};

}  // namespace cigsim
