// SPDX-License-Identifier: MIT
// Waves of the clocked level as a value change dump, one sample a cycle: what a stage's trace()
// names is written under its name in the module's scope. A stage at the level of RTL adds the dump
// of its Verilated module as a part.
//
// SystemC's own trace files look at every value in every step of the simulation, tell nothing of a
// full disk, and lose the time at which a window begins.
#pragma once

#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <systemc>
#include <vector>

#include "models/boundary/cycle.hpp"
#include "models/boundary/wave_part.hpp"
#include "sim/wave/rtl_part.hpp"

namespace cigsim {

/// The unit of time of a file: a power of ten of which half a cycle is a whole number, if there is
/// one from 1 ps on.
double vcd_unit_ns(double cycle_ns);

class VcdWriter : public sc_core::sc_trace_file, public WaveWithParts {
 public:
  /// Writes to `out`, which must outlive it; whether that takes everything is for the caller to
  /// see. Cycle n begins at n * `cycle_ns`, and the signal `clock` rises there.
  VcdWriter(std::ostream& out, double cycle_ns, const std::string& clock);

  /// Ahead of the first sample: declares what was traced.
  void declare();
  /// The values that now are, as those of cycle `n`, which must be later than the last.
  void sample(Cycle n);
  /// The end of the window: the beginning of cycle `n`. Closes the parts.
  void end(Cycle n);

  void add_part(const std::string& scope, std::unique_ptr<WavePart> part) override;

  // What can be traced: bits, whole numbers of any type, and real numbers.
  void trace(const bool& object, const std::string& name) override;
  void trace(const unsigned char& object, const std::string& name, int width) override;
  void trace(const unsigned short& object, const std::string& name, int width) override;
  void trace(const unsigned int& object, const std::string& name, int width) override;
  void trace(const unsigned long& object, const std::string& name, int width) override;
  void trace(const char& object, const std::string& name, int width) override;
  void trace(const short& object, const std::string& name, int width) override;
  void trace(const int& object, const std::string& name, int width) override;
  void trace(const long& object, const std::string& name, int width) override;
  void trace(const sc_dt::int64& object, const std::string& name, int width) override;
  void trace(const sc_dt::uint64& object, const std::string& name, int width) override;
  void trace(const float& object, const std::string& name) override;
  void trace(const double& object, const std::string& name) override;

  // SystemC's other types; throw std::logic_error.
  void trace(const sc_core::sc_event&, const std::string& name) override;
  void trace(const sc_core::sc_time&, const std::string& name) override;
  void trace(const sc_dt::sc_bit&, const std::string& name) override;
  void trace(const sc_dt::sc_logic&, const std::string& name) override;
  void trace(const sc_dt::sc_int_base&, const std::string& name) override;
  void trace(const sc_dt::sc_uint_base&, const std::string& name) override;
  void trace(const sc_dt::sc_signed&, const std::string& name) override;
  void trace(const sc_dt::sc_unsigned&, const std::string& name) override;
  void trace(const sc_dt::sc_fxval&, const std::string& name) override;
  void trace(const sc_dt::sc_fxval_fast&, const std::string& name) override;
  void trace(const sc_dt::sc_fxnum&, const std::string& name) override;
  void trace(const sc_dt::sc_fxnum_fast&, const std::string& name) override;
  void trace(const sc_dt::sc_bv_base&, const std::string& name) override;
  void trace(const sc_dt::sc_lv_base&, const std::string& name) override;
  void trace(const unsigned int&, const std::string& name, const char** literals) override;
  void write_comment(const std::string&) override {}
  void set_time_unit(double, sc_core::sc_time_unit) override {}

 private:
  struct Value {
    std::string name, code;
    const void* object;
    std::uint64_t (*read)(const void* object);  // sign extended; of a real number its bits
    int width;
    bool real;
    std::uint64_t last = 0;
  };

  template <class T>
  void add(const T& object, const std::string& name, int width);
  template <class T>
  static std::uint64_t read(const void* object);
  [[noreturn]] static void refuse(const std::string& name);

  void cycle(bool) override {}
  void declare(const std::vector<RtlPart::Variable>& variables);
  void begin_time(double half_cycles);
  void put(const Value& value, std::uint64_t bits);
  void put_clock(bool high) { out_ << (high ? '1' : '0') << clock_code_ << '\n'; }

  std::ostream& out_;
  double unit_ns_;
  double half_cycle_;  // in units
  std::string clock_, clock_code_;
  std::vector<Value> values_;
  std::vector<RtlPart> parts_;
  bool first_ = true;
};

}  // namespace cigsim
