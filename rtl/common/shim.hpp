// SPDX-License-Identifier: MIT
// The library's side of interface.hpp: a Verilated class with its clock and pins. A module's
// MODULE.shim.cpp is one line, CIGSIM_RTL_LIBRARY(VMODULE, Pins), after the two functions
//   void drive(VMODULE& module, const Pins& pins);    inputs, but for the clock clk_i
//   void sample(const VMODULE& module, Pins& pins);   outputs
// A broken contract (assertions.svh) leaves edge() or settle() as a std::runtime_error.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "rtl/common/interface.hpp"
#include "verilated.h"
#include "verilated_vcd_c.h"
#if VM_COVERAGE
#include "verilated_cov.h"
#endif

/// The time that $time tells, which nothing asks for.
double sc_time_stamp();

namespace cigsim::rtl {

/// Hands what Verilator writes to a function.
class WaveSink : public VerilatedVcdFile {
 public:
  WaveSink(WriteWave write, void* context) : write_(write), context_(context) {}
  bool open(const std::string&) override { return true; }
  void close() override {}
  ssize_t write(const char* text, ssize_t size) override {
    write_(context_, text, static_cast<std::size_t>(size));
    return size;
  }

 private:
  WriteWave write_;
  void* context_;
};

template <class Module, class Pins>
class Shim {
 public:
  explicit Shim(std::uint32_t seed) {
    context_.randReset(VM_COVERAGE ? 0 : 2);  // else first values would count as toggles
    context_.randSeed(static_cast<int>(seed));
    context_.traceEverOn(true);
    module_ = std::make_unique<Module>(&context_, "rtl");
    module_->clk_i = 0;
    module_->eval();  // else the first edge would not be seen to rise
  }
  ~Shim() { module_->final(); }

  void edge() {
    if (high_) fall();
    drive(*module_, pins);
    module_->clk_i = 1;
    module_->eval();
    high_ = true;
    sample(*module_, pins);
  }
  void settle() {
    if (high_) fall();
    drive(*module_, pins);
    module_->eval();
    sample(*module_, pins);
  }

  void wave_open(WriteWave write, void* context) {
    sink_ = std::make_unique<WaveSink>(write, context);
    wave_ = std::make_unique<VerilatedVcdC>(sink_.get());
    module_->trace(wave_.get(), 99);
    wave_->open("rtl.vcd");
    wave_->flush();
  }
  void wave_dump(std::uint64_t time) {
    wave_->dump(time);
    wave_->flush();
  }
  void wave_close() {
    wave_->close();
    wave_.reset();
    sink_.reset();
  }
#if VM_COVERAGE
  void write_coverage(const char* file) { context_.coveragep()->write(file); }
#endif

  Pins pins{};

 private:
  void fall() {
    module_->clk_i = 0;
    module_->eval();
    high_ = false;
  }

  VerilatedContext context_;
  std::unique_ptr<Module> module_;
  std::unique_ptr<WaveSink> sink_;
  std::unique_ptr<VerilatedVcdC> wave_;
  bool high_ = false;
};

template <class Module, class Pins>
const Interface& interface() {
  using Model = Shim<Module, Pins>;
  static constexpr auto of = [](void* model) { return static_cast<Model*>(model); };
  static const Interface table {
    kInterfaceVersion, sizeof(Pins), [](std::uint32_t seed) -> void* { return new Model(seed); },
        [](void* model) { delete of(model); },
        [](void* model) -> void* { return &of(model)->pins; },
        [](void* model) { of(model)->edge(); }, [](void* model) { of(model)->settle(); },
        [](void* model, WriteWave write, void* context) { of(model)->wave_open(write, context); },
        [](void* model, std::uint64_t time) { of(model)->wave_dump(time); },
        [](void* model) { of(model)->wave_close(); },
#if VM_COVERAGE
        [](void* model, const char* file) { of(model)->write_coverage(file); },
#else
        nullptr,
#endif
  };
  return table;
}

}  // namespace cigsim::rtl

#define CIGSIM_RTL_LIBRARY(MODULE, PINS)                                                     \
  extern "C" __attribute__((visibility("default"))) const cigsim::rtl::Interface*            \
  cigsim_rtl_interface() {                                                                   \
    return &cigsim::rtl::interface<MODULE, PINS>();                                          \
  }                                                                                          \
  double sc_time_stamp() { return 0; }                                                       \
  void vl_stop(const char* file, int line, const char* scope) {                              \
    throw std::runtime_error(std::string(file) + ":" + std::to_string(line) + ": " + scope + \
                             ": a contract of the RTL is broken");                           \
  }
