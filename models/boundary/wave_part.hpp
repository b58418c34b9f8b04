// SPDX-License-Identifier: MIT
// The waves of a stage's RTL in the wave file of the machine. The Verilated module writes a value
// change dump of its own; a file that takes parts puts it below the stage.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <systemc>

#include "models/boundary/cycle.hpp"
#include "models/boundary/rtl_model.hpp"

namespace cigsim {

/// A value change dump that is asked for cycle by cycle.
class WavePart {
 public:
  virtual ~WavePart() = default;
  /// The declarations go to `write` at once, and what changed with each sample.
  virtual void open(RtlModel::WriteWave write) = 0;
  /// The values of cycle `n`, which is later than the last one.
  virtual void sample(Cycle n) = 0;
  virtual void close() = 0;
};

/// A trace file that takes parts.
class WaveWithParts {
 public:
  /// `scope`: under which the module's signals stand. The part must be closed before what it shows
  /// ends.
  virtual void add_part(const std::string& scope, std::unique_ptr<WavePart> part) = 0;

 protected:
  ~WaveWithParts() = default;
};

/// A stage's RTL as a part.
class RtlWave : public WavePart {
 public:
  /// `drive` copies the stage's inputs, as they are in this cycle, into the model's pins.
  RtlWave(RtlModel& model, std::function<void()> drive) : model_(model), drive_(std::move(drive)) {}

  void open(RtlModel::WriteWave write) override { model_.wave_open(std::move(write)); }
  void sample(Cycle n) override {
    drive_();
    model_.settle();
    model_.wave_dump(static_cast<std::uint64_t>(n));
  }
  void close() override { model_.wave_close(); }

 private:
  RtlModel& model_;
  std::function<void()> drive_;
};

/// Adds the RTL of a stage to `file`, as `STAGE.rtl`, if it takes parts.
inline void trace_rtl(sc_core::sc_trace_file* file, const sc_core::sc_module& stage,
                      RtlModel& model, std::function<void()> drive) {
  if (auto* parts = dynamic_cast<WaveWithParts*>(file))
    parts->add_part(std::string(stage.name()) + ".rtl",
                    std::make_unique<RtlWave>(model, std::move(drive)));
}

}  // namespace cigsim
