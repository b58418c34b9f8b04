// SPDX-License-Identifier: MIT
#include "sim/systemc_machine.hpp"

#include <exception>
#include <sstream>
#include <stdexcept>
#include <systemc>
#include <utility>

#include "models/boundary/link_check.hpp"
#include "models/edge_orderer/clocked.hpp"
#include "models/edge_orderer/rtl.hpp"
#include "models/edge_orderer/timed.hpp"
#include "models/frame_calculator/memory_loader.hpp"
#include "models/frame_calculator/timed.hpp"
#include "models/geometry_processor/clocked.hpp"
#include "models/geometry_processor/timed.hpp"
#include "models/priority_processor/clocked.hpp"
#include "models/priority_processor/rtl.hpp"
#include "models/priority_processor/timed.hpp"
#include "models/priority_resolver/clocked.hpp"
#include "models/priority_resolver/rtl.hpp"
#include "models/priority_resolver/timed.hpp"
#include "models/video_processor/clocked.hpp"
#include "models/video_processor/timed.hpp"
#include "sim/connection.hpp"
#include "sim/cosim/twin.hpp"
#include "sim/frame_figures.hpp"
#include "sim/frame_log.hpp"
#include "sim/sequencer.hpp"

namespace cigsim {
namespace {

// Words of frame starts and completions: one of a frame, and one of the next.
constexpr std::uint32_t kControlDepth = 2;

// A stage at one of its levels.
template <class Timed, class Clocked>
struct StageModel {
  std::unique_ptr<Timed> timed;
  std::unique_ptr<Clocked> clocked;

  void trace(sc_core::sc_trace_file* file) const { clocked->trace(file); }
};

// A stage that has RTL too.
template <class Timed, class Clocked, class Rtl, class Figures>
struct RtlStageModel {
  std::unique_ptr<Timed> timed;
  std::unique_ptr<Clocked> clocked;
  std::unique_ptr<Rtl> rtl;
  std::unique_ptr<Twin<Clocked, Figures>> twin;

  void trace(sc_core::sc_trace_file* file) const {
    if (clocked) clocked->trace(file);
    if (rtl) rtl->trace(file);
    if (twin) twin->model().trace(file);
  }
};

}  // namespace

class SystemcMachine::Impl : public sc_core::sc_module {
 public:
  Impl(sc_core::sc_module_name name, const PipelineOptions& options)
      : sc_module(name),
        options_(options),
        clock_("clock", options.description.clock_ns),
        loader_(options.description, options.eye_reach, options.detail),
        start_calculator_("start_calculator", kControlDepth, options.stalls, false, false, clock_),
        calculated_("calculated", kControlDepth, options.stalls, false, false, clock_),
        start_priority_("start_priority", kControlDepth, options.stalls, false,
                        pins(Stage::kPriorityProcessor), clock_),
        start_geometry_("start_geometry", kControlDepth, options.stalls, false,
                        pins(Stage::kGeometryProcessor), clock_),
        start_orderer_("start_orderer", kControlDepth, options.stalls, false,
                       pins(Stage::kEdgeOrderer), clock_),
        start_video_("start_video", kControlDepth, options.stalls, false,
                     pins(Stage::kVideoProcessor), clock_),
        edges_loaded_("edges_loaded", kControlDepth, options.stalls, pins(Stage::kEdgeOrderer),
                      false, clock_),
        faces_loaded_("faces_loaded", kControlDepth, options.stalls, pins(Stage::kVideoProcessor),
                      false, clock_),
        shown_("shown", kControlDepth, options.stalls, pins(Stage::kVideoProcessor), false, clock_),
        items_("items", options.description.links.items, options.stalls,
               pins(Stage::kPriorityProcessor), pins(Stage::kGeometryProcessor), clock_),
        edges_("edges", options.description.links.edges, options.stalls,
               pins(Stage::kGeometryProcessor), pins(Stage::kEdgeOrderer), clock_),
        faces_("faces", options.description.links.faces, options.stalls,
               pins(Stage::kGeometryProcessor), pins(Stage::kVideoProcessor), clock_),
        crossings_("crossings", options.description.links.crossings, options.stalls,
                   pins(Stage::kEdgeOrderer), pins(Stage::kPriorityResolver), clock_),
        spans_("spans", options.description.links.spans, options.stalls,
               pins(Stage::kPriorityResolver), pins(Stage::kVideoProcessor), clock_) {
    make_sequencer();
    make_calculator();
    make_priority();
    make_geometry();
    make_orderer();
    make_resolver();
    make_video();
    SC_HAS_PROCESS(Impl);
    SC_METHOD(end);
    dont_initialize();
    sensitive << stop_;
  }

  void feed(Next next, Out out) { frames_.feed(std::move(next), std::move(out)); }
  // What a callback of this machine threw, once.
  std::exception_ptr take_failure() { return std::exchange(frames_.failure, nullptr); }

  void set_probe(const Probe& probe) {
    for_each_connection(
        [&probe](auto Impl::*, auto& connection, Stage, bool) { watch(connection.link, probe); });
  }

  void check_links(Impl& expected, const MismatchFunction& report) {
    for_each_connection([&](auto place, auto& connection, Stage producer, bool lines) {
      checks_.push_back(std::make_unique<LinkCheck<WordOf<decltype(connection.link)>>>(
          (expected.*place).link, connection.link, std::string(name_of(producer)),
          lines ? raster_lines() : 1, report));
    });
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
                                     for (const Stage stage : stages) trace(stage, file);
                                   });
  }
  void finish_recording() {
    if (recorder_) recorder_->finish();
  }

 private:
  bool pins(Stage stage) const { return has_pins(options_.levels[stage]); }
  std::uint32_t raster_lines() const {
    return static_cast<std::uint32_t>(options_.description.raster.height);
  }
  bool rtl(Stage stage) const { return options_.levels[stage] == Level::kRtl; }

  template <class T>
  static T word_of(const Link<T>&);
  template <class L>
  using WordOf = decltype(word_of(std::declval<L&>()));

  /// Calls f(member, connection, the stage that produces its words, whether they end lines).
  template <class F>
  void for_each_connection(F f) {
    const auto add = [&](auto place, Stage producer, bool lines = false) {
      f(place, this->*place, producer, lines);
    };
    add(&Impl::start_calculator_, Stage::kFrameCalculator);
    add(&Impl::calculated_, Stage::kFrameCalculator);
    add(&Impl::start_priority_, Stage::kFrameCalculator);
    add(&Impl::start_geometry_, Stage::kFrameCalculator);
    add(&Impl::start_orderer_, Stage::kFrameCalculator);
    add(&Impl::start_video_, Stage::kFrameCalculator);
    add(&Impl::edges_loaded_, Stage::kEdgeOrderer);
    add(&Impl::faces_loaded_, Stage::kVideoProcessor);
    add(&Impl::shown_, Stage::kVideoProcessor);
    add(&Impl::items_, Stage::kPriorityProcessor);
    add(&Impl::edges_, Stage::kGeometryProcessor);
    add(&Impl::faces_, Stage::kGeometryProcessor);
    add(&Impl::crossings_, Stage::kEdgeOrderer, true);
    add(&Impl::spans_, Stage::kPriorityResolver, true);
  }

  // Output pins of an RTL stage.
  template <class T>
  void output(Stage stage, std::string_view name, PinOut<T>& pins, Connection<T>& connection) {
    const auto& stuck = options_.stuck;
    if (stuck && stuck->first == stage && stuck->second.pins == name)
      connection.from(pins, stuck->second);
    else
      connection.from(pins);
  }

  // What an RTL stage tells of a frame goes to its twin as well.
  template <class Figures, class Model, class Report>
  static auto also_to_twin(const Model& model, const Report& report) {
    return [&model, report](const Figures& figures) {
      if (model.twin) model.twin->figures(figures);
      report(figures);
    };
  }

  template <class T>
  static void watch(Link<T>& link, const Probe& probe) {
    link.set_probe([probe, name = link.name()](const T& word, Cycle pushed, Cycle taken) {
      std::ostringstream text;
      text << word;
      probe(name, text.str(), pushed, taken);
    });
  }

  void trace(Stage stage, sc_core::sc_trace_file* file) const {
    const auto of = [file](const auto& model) { model.trace(file); };
    switch (stage) {
      case Stage::kPriorityProcessor:
        return of(priority_);
      case Stage::kGeometryProcessor:
        return of(geometry_);
      case Stage::kEdgeOrderer:
        return of(orderer_);
      case Stage::kPriorityResolver:
        return of(resolver_);
      case Stage::kVideoProcessor:
        return of(video_);
      case Stage::kFrameCalculator:
        break;
    }
  }

  // ---- stages

  void make_sequencer() {
    const Sequencer::Links links{start_calculator_.link, start_priority_.link, start_geometry_.link,
                                 start_orderer_.link,    start_video_.link,    calculated_.link,
                                 edges_loaded_.link,     faces_loaded_.link,   shown_.link};
    sequencer_ = std::make_unique<Sequencer>(
        "sequencer", options_.description.frame_cycles, links,
        Sequencer::Calls{[this](std::uint32_t frame) { return frames_.next(frame); },
                         [this](std::uint32_t k, Cycle cycle) { frames_.started(k, cycle); },
                         [this] { clock_.stop(); }});
    for (const Stage stage : kAllStages)
      if (pins(stage)) clock_.start();
  }

  void make_calculator() {
    calculator_ = std::make_unique<frame_calculator::Timed>(
        "frame_calculator", options_.description,
        frame_calculator::Timed::Links{start_calculator_.link, calculated_.link},
        [this](std::uint32_t frame) { return frames_.calculate(loader_, frame); },
        [this](const frame_calculator::Figures& f) {
          frames_.note(Stage::kFrameCalculator, f, [](FrameStats&) {});
        });
  }

  void make_priority() {
    const auto report = [this](const priority_processor::Figures& f) {
      frames_.note(Stage::kPriorityProcessor, f, [this, &f](FrameStats& stats) {
        add_figures(stats, f, loader_.named_faults(f.frame, f.faults));
      });
    };
    constexpr Stage kStage = Stage::kPriorityProcessor;
    if (!pins(kStage)) {
      priority_.timed = std::make_unique<priority_processor::Timed>(
          "priority_processor", options_.description,
          priority_processor::Timed::Links{start_priority_.link, items_.link},
          loader_.priority_banks(), report);
      return;
    }
    if (rtl(kStage)) {
      auto& model = priority_.rtl = std::make_unique<priority_processor::Rtl>(
          "priority_processor", options_.description, clock_, loader_.priority_banks(),
          options_.libraries.at(kStage),
          also_to_twin<priority_processor::Figures>(priority_, report), options_.rtl_seed);
      model->clock(clock_.wire);
      start_priority_.to(model->start);
      output(kStage, "items", model->items, items_);
      if (!options_.lockstep) return;
      using Beside = Twin<priority_processor::Clocked, priority_processor::Figures>;
      priority_.twin = std::make_unique<Beside>(
          "priority_processor", clock_, 1, options_.lockstep,
          [this](const char* name, priority_processor::FiguresFunction figures) {
            return std::make_unique<priority_processor::Clocked>(name, options_.description, clock_,
                                                                 loader_.priority_banks(), figures);
          });
      Beside& twin = *priority_.twin;
      twin.input("start", twin.model().start, start_priority_);
      twin.output("items", twin.model().items, items_);
      return;
    }
    auto& model = priority_.clocked = std::make_unique<priority_processor::Clocked>(
        "priority_processor", options_.description, clock_, loader_.priority_banks(), report);
    model->clock(clock_.wire);
    start_priority_.to(model->start);
    items_.from(model->items);
  }

  void make_geometry() {
    const auto report = [this](const geometry_processor::Figures& f) {
      frames_.note(Stage::kGeometryProcessor, f,
                   [&f](FrameStats& stats) { add_figures(stats, f); });
    };
    if (!pins(Stage::kGeometryProcessor)) {
      geometry_.timed = std::make_unique<geometry_processor::Timed>(
          "geometry_processor", options_.description, options_.overload,
          geometry_processor::Timed::Links{start_geometry_.link, items_.link, edges_.link,
                                           faces_.link},
          loader_.geometry_banks(), report);
      return;
    }
    auto& model = geometry_.clocked = std::make_unique<geometry_processor::Clocked>(
        "geometry_processor", options_.description, options_.overload, clock_,
        loader_.geometry_banks(), report);
    model->clock(clock_.wire);
    start_geometry_.to(model->start);
    items_.to(model->items);
    edges_.from(model->edges);
    faces_.from(model->faces);
  }

  void make_orderer() {
    const auto report = [this](const edge_orderer::Figures& f) {
      frames_.note(Stage::kEdgeOrderer, f, [&f](FrameStats& stats) { add_figures(stats, f); });
    };
    constexpr Stage kStage = Stage::kEdgeOrderer;
    if (!pins(kStage)) {
      orderer_.timed = std::make_unique<edge_orderer::Timed>(
          "edge_orderer", options_.description, options_.overload,
          edge_orderer::Timed::Links{edges_.link, edges_loaded_.link, start_orderer_.link,
                                     crossings_.link},
          report);
      return;
    }
    if (rtl(kStage)) {
      auto& model = orderer_.rtl = std::make_unique<edge_orderer::Rtl>(
          "edge_orderer", options_.description, options_.overload, clock_,
          options_.libraries.at(kStage), also_to_twin<edge_orderer::Figures>(orderer_, report),
          options_.rtl_seed);
      model->clock(clock_.wire);
      edges_.to(model->edges);
      start_orderer_.to(model->start);
      output(kStage, "loaded", model->loaded, edges_loaded_);
      output(kStage, "crossings", model->crossings, crossings_);
      if (!options_.lockstep) return;
      using Beside = Twin<edge_orderer::Clocked, edge_orderer::Figures>;
      orderer_.twin = std::make_unique<Beside>(
          "edge_orderer", clock_, raster_lines(), options_.lockstep,
          [this](const char* name, edge_orderer::FiguresFunction figures) {
            return std::make_unique<edge_orderer::Clocked>(name, options_.description,
                                                           options_.overload, clock_, figures);
          });
      Beside& twin = *orderer_.twin;
      twin.input("edges", twin.model().edges, edges_);
      twin.input("start", twin.model().start, start_orderer_);
      twin.output("loaded", twin.model().loaded, edges_loaded_);
      twin.output("crossings", twin.model().crossings, crossings_);
      return;
    }
    auto& model = orderer_.clocked = std::make_unique<edge_orderer::Clocked>(
        "edge_orderer", options_.description, options_.overload, clock_, report);
    model->clock(clock_.wire);
    edges_.to(model->edges);
    edges_loaded_.from(model->loaded);
    start_orderer_.to(model->start);
    crossings_.from(model->crossings);
  }

  void make_resolver() {
    const auto report = [this](const priority_resolver::Figures& f) {
      frames_.note(Stage::kPriorityResolver, f,
                   [&f](FrameStats& stats) { stats.spans = f.face_spans; });
    };
    constexpr Stage kStage = Stage::kPriorityResolver;
    if (!pins(kStage)) {
      resolver_.timed = std::make_unique<priority_resolver::Timed>(
          "priority_resolver", options_.description,
          priority_resolver::Timed::Links{crossings_.link, spans_.link}, report);
      return;
    }
    if (rtl(kStage)) {
      auto& model = resolver_.rtl = std::make_unique<priority_resolver::Rtl>(
          "priority_resolver", options_.description, clock_, options_.libraries.at(kStage),
          also_to_twin<priority_resolver::Figures>(resolver_, report), options_.rtl_seed);
      model->clock(clock_.wire);
      crossings_.to(model->crossings);
      output(kStage, "spans", model->spans, spans_);
      if (!options_.lockstep) return;
      using Beside = Twin<priority_resolver::Clocked, priority_resolver::Figures>;
      resolver_.twin = std::make_unique<Beside>(
          "priority_resolver", clock_, raster_lines(), options_.lockstep,
          [this](const char* name, priority_resolver::FiguresFunction figures) {
            return std::make_unique<priority_resolver::Clocked>(name, options_.description, clock_,
                                                                figures);
          });
      Beside& twin = *resolver_.twin;
      twin.input("crossings", twin.model().crossings, crossings_);
      twin.output("spans", twin.model().spans, spans_);
      return;
    }
    auto& model = resolver_.clocked = std::make_unique<priority_resolver::Clocked>(
        "priority_resolver", options_.description, clock_, report);
    model->clock(clock_.wire);
    crossings_.to(model->crossings);
    spans_.from(model->spans);
  }

  void make_video() {
    const video_processor::Outputs outputs{
        [this](const video_processor::Figures& f) {
          frames_.note(Stage::kVideoProcessor, f, [&f](FrameStats& stats) {
            stats.overload->late_lines = f.late_lines;
            stats.overload->worst_lateness = f.worst_lateness;
          });
        },
        [this](std::uint32_t frame, const Picture& picture, Cycle first, Cycle last) {
          frames_.shown(frame, picture, first, last, options_.description.frame_cycles);
        },
        {}};
    if (!pins(Stage::kVideoProcessor)) {
      video_.timed = std::make_unique<video_processor::Timed>(
          "video_processor", options_.description,
          video_processor::Timed::Links{faces_.link, faces_loaded_.link, start_video_.link,
                                        spans_.link, shown_.link},
          loader_.video_banks(), outputs);
      return;
    }
    auto& model = video_.clocked = std::make_unique<video_processor::Clocked>(
        "video_processor", options_.description, clock_, loader_.video_banks(), outputs);
    model->clock(clock_.wire);
    faces_.to(model->faces);
    faces_loaded_.from(model->loaded);
    start_video_.to(model->start);
    spans_.to(model->spans);
    shown_.from(model->shown);
  }

  void end() { sc_core::sc_stop(); }

  PipelineOptions options_;
  Clock clock_;
  frame_calculator::MemoryLoader loader_;
  Connection<FrameWord> start_calculator_, calculated_, start_priority_, start_geometry_,
      start_orderer_, start_video_, edges_loaded_, faces_loaded_, shown_;
  Connection<ItemWord> items_;
  Connection<EdgeWord> edges_;
  Connection<FaceWord> faces_;
  Connection<CrossingWord> crossings_;
  Connection<SpanWord> spans_;

  std::unique_ptr<Sequencer> sequencer_;
  std::unique_ptr<frame_calculator::Timed> calculator_;
  RtlStageModel<priority_processor::Timed, priority_processor::Clocked, priority_processor::Rtl,
                priority_processor::Figures>
      priority_;
  StageModel<geometry_processor::Timed, geometry_processor::Clocked> geometry_;
  RtlStageModel<edge_orderer::Timed, edge_orderer::Clocked, edge_orderer::Rtl,
                edge_orderer::Figures>
      orderer_;
  RtlStageModel<priority_resolver::Timed, priority_resolver::Clocked, priority_resolver::Rtl,
                priority_resolver::Figures>
      resolver_;
  StageModel<video_processor::Timed, video_processor::Clocked> video_;
  std::unique_ptr<Recorder> recorder_;
  std::vector<std::unique_ptr<LinkCheckBase>> checks_;
  sc_core::sc_event stop_;
  FrameLog frames_;
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
