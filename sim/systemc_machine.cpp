// SPDX-License-Identifier: MIT
#include "sim/systemc_machine.hpp"

#include <array>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <systemc>
#include <utility>

#include "sim/pipeline/connections.hpp"
#include "sim/pipeline/frame_log.hpp"
#include "sim/pipeline/placed_stage.hpp"
#include "sim/pipeline/sequencer.hpp"

namespace cigsim {

class SystemcMachine::Impl : public sc_core::sc_module {
 public:
  Impl(sc_core::sc_module_name name, const PipelineOptions& options)
      : sc_module(name),
        options_(options),
        clock_("clock", options.description.clock_ns),
        loader_(options.description, options.eye_reach, options.detail),
        connections_(options_, clock_),
        sequencer_("sequencer", options.description.frame_cycles, links_of_sequencer(),
                   calls_of_sequencer()) {
    const Site site{options_, clock_, loader_, connections_, frames_};
    for (const Stage stage : kAllStages) {
      if (has_pins(options_.levels[stage])) clock_.start();
      stages_[index(stage)] = place(stage, site);
    }
    SC_HAS_PROCESS(Impl);
    SC_METHOD(end);
    dont_initialize();
    sensitive << stop_;
  }

  void feed(Next next, Out out) { frames_.feed(std::move(next), std::move(out)); }
  // What a callback of this machine threw, once.
  std::exception_ptr take_failure() { return std::exchange(frames_.failure, nullptr); }

  void set_probe(const Probe& probe) { connections_.set_probe(probe); }

  void check_links(Impl& expected, const MismatchFunction& report) {
    const auto lines = static_cast<std::uint32_t>(options_.description.raster.height);
    checks_ = connections_.check(expected.connections_, lines, report);
  }
  std::uint64_t finish_checks() {
    std::uint64_t words = 0;
    for (const auto& check : checks_) {
      check->finish();
      words += check->words();
    }
    return words;
  }

  void stop(Cycle cycles) {
    // SystemC says that it was stopped.
    sc_core::sc_report_handler::set_actions("/OSCI/SystemC", sc_core::SC_DO_NOTHING);
    stop_.notify(static_cast<double>(cycles) * clock_.period());
  }
  Cycle cycles() const { return clock_.cycle() + 1; }

  void record(std::ostream& out, const CycleWindow& window, const std::vector<Stage>& stages) {
    const std::string clock = std::string(name()) + ".clock";
    recorder_ =
        std::make_unique<Recorder>((std::string(name()) + "_recorder").c_str(), clock_, clock, out,
                                   window, [this, stages](sc_core::sc_trace_file* file) {
                                     for (const Stage stage : stages)
                                       stages_[index(stage)]->trace(file);
                                   });
  }
  void finish_recording() {
    if (recorder_) recorder_->finish();
  }

 private:
  static std::size_t index(Stage stage) { return static_cast<std::size_t>(stage); }

  Sequencer::Links links_of_sequencer() {
    Connections& c = connections_;
    return {c.start_calculator.link, c.start_priority.link, c.start_geometry.link,
            c.start_orderer.link,    c.start_video.link,    c.calculated.link,
            c.edges_loaded.link,     c.faces_loaded.link,   c.shown.link};
  }
  Sequencer::Calls calls_of_sequencer() {
    return {[this](std::uint32_t frame) { return frames_.next(frame); },
            [this](std::uint32_t k, Cycle cycle) { frames_.started(k, cycle); },
            [this] { clock_.stop(); }};
  }

  void end() { sc_core::sc_stop(); }

  PipelineOptions options_;
  Clock clock_;
  frame_calculator::MemoryLoader loader_;
  Connections connections_;
  FrameLog frames_;
  Sequencer sequencer_;
  std::array<std::unique_ptr<PlacedStage>, kStageCount> stages_;
  std::unique_ptr<Recorder> recorder_;
  std::vector<std::unique_ptr<LinkCheckBase>> checks_;
  sc_core::sc_event stop_;
};

SystemcMachine::SystemcMachine(const std::string& name, const PipelineOptions& options) {
  setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
  impl_ = std::make_unique<Impl>(name.c_str(), options);
}

SystemcMachine::~SystemcMachine() = default;

void SystemcMachine::feed(Next next, Out out) { impl_->feed(std::move(next), std::move(out)); }

void SystemcMachine::simulate(const std::vector<SystemcMachine*>& machines) {
  // What a process throws comes back as a report with SystemC's text around it.
  std::exception_ptr thrown;
  try {
    sc_core::sc_start();
  } catch (const sc_core::sc_report& report) {
    thrown = std::make_exception_ptr(std::runtime_error(report.get_msg()));
  }
  for (SystemcMachine* machine : machines) machine->impl_->finish_recording();
  if (thrown) std::rethrow_exception(thrown);
  for (SystemcMachine* machine : machines)
    if (const std::exception_ptr failure = machine->impl_->take_failure())
      std::rethrow_exception(failure);
}

void SystemcMachine::stop(Cycle cycles) { impl_->stop(cycles); }
Cycle SystemcMachine::cycles() const { return impl_->cycles(); }

void SystemcMachine::check_links(SystemcMachine& expected, const MismatchFunction& report) {
  impl_->check_links(*expected.impl_, report);
}
std::uint64_t SystemcMachine::finish_checks() { return impl_->finish_checks(); }

void SystemcMachine::set_probe(const Probe& probe) { impl_->set_probe(probe); }

void SystemcMachine::record(std::ostream& out, const CycleWindow& window,
                            const std::vector<Stage>& stages) {
  impl_->record(out, window, stages);
}

}  // namespace cigsim
