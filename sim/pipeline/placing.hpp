// SPDX-License-Identifier: MIT
// The one choice of a stage's level, for all stages.
//
// A kind of stage is a StageKind that tells, and nothing else of levels:
// - kStage: which stage it is;
// - timed, clocked, rtl(site, name, report): the model, at each level that the stage has;
// - connect(wires, model, connections), of models with pins: for each of them a call of
//   wires.input or wires.output(name, pins, connection).
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "sim/cosim/twin.hpp"
#include "sim/frame_figures.hpp"
#include "sim/pipeline/placed_stage.hpp"

namespace cigsim {

/// Connects the pins of a stage in the pipeline; a Twin has the same functions for those beside it.
class Wiring {
 public:
  /// `stuck`: a bit of the stage's outputs, or none.
  explicit Wiring(const StuckBit* stuck = nullptr) : stuck_(stuck) {}

  template <class T>
  void input(const std::string&, PinIn<T>& pins, Connection<T>& connection) const {
    connection.to(pins);
  }
  template <class T>
  void output(const std::string& name, PinOut<T>& pins, Connection<T>& connection) const {
    if (stuck_ && stuck_->pins == name)
      connection.from(pins, *stuck_);
    else
      connection.from(pins);
  }

 private:
  const StuckBit* stuck_;
};

template <class FiguresOfStage>
struct StageKind {
  using Figures = FiguresOfStage;  ///< what it tells of a frame
  using Report = std::function<void(const Figures&)>;
  /// The ends that it puts out end lines of the raster, not frames.
  static constexpr bool kEndsLines = false;

  static void note(FrameStats& stats, const Site&, const Figures& figures) {
    add_figures(stats, figures);
  }
};

template <class Kind>
concept HasClocked = requires(const Site& site) {
  Kind::clocked(site, "", {});
};
template <class Kind>
concept HasRtl = requires(const Site& site) {
  Kind::rtl(site, "", {});
};

template <class Kind>
class TimedStage : public PlacedStage {
 public:
  TimedStage(const Site& site, const char* name, const typename Kind::Report& report)
      : model_(Kind::timed(site, name, report)) {}

  void trace(sc_core::sc_trace_file*) override {}

 private:
  decltype(Kind::timed(std::declval<Site>(), "", {})) model_;
};

template <class Kind>
class ClockedStage : public PlacedStage {
 public:
  ClockedStage(const Site& site, const char* name, const typename Kind::Report& report)
      : model_(Kind::clocked(site, name, report)) {
    model_->clock(site.clock.wire);
    Kind::connect(Wiring(), *model_, site.connections);
  }

  void trace(sc_core::sc_trace_file* file) override { model_->trace(file); }

 private:
  decltype(Kind::clocked(std::declval<Site>(), "", {})) model_;
};

/// In lock-step with a clocked twin where the options want one.
template <class Kind>
class RtlStage : public PlacedStage {
 public:
  RtlStage(const Site& site, const char* name, const typename Kind::Report& report)
      : model_(Kind::rtl(site, name, [this, report](const typename Kind::Figures& figures) {
          if (twin_) twin_->figures(figures);
          report(figures);
        })) {
    const auto& stuck = site.options.stuck;
    model_->clock(site.clock.wire);
    Kind::connect(Wiring(stuck && stuck->first == Kind::kStage ? &stuck->second : nullptr), *model_,
                  site.connections);
    if (site.options.lockstep) make_twin(site, name);
  }

  void trace(sc_core::sc_trace_file* file) override {
    model_->trace(file);
    if (twin_) twin_->model().trace(file);
  }

 private:
  using Clocked = typename decltype(Kind::clocked(std::declval<Site>(), "", {}))::element_type;
  using Beside = Twin<Clocked, typename Kind::Figures>;

  void make_twin(const Site& site, const char* name) {
    twin_ = std::make_unique<Beside>(
        name, site.clock,
        Kind::kEndsLines ? static_cast<std::uint32_t>(site.options.description.raster.height) : 1,
        site.options.lockstep, [&site](const char* twin, const typename Kind::Report& report) {
          return Kind::clocked(site, twin, report);
        });
    Kind::connect(*twin_, twin_->model(), site.connections);
  }

  decltype(Kind::rtl(std::declval<Site>(), "", {})) model_;
  std::unique_ptr<Beside> twin_;
};

/// As place(), of one kind.
template <class Kind>
std::unique_ptr<PlacedStage> place_kind(const Site& site) {
  const std::string name(name_of(Kind::kStage));
  const typename Kind::Report report = [site](const typename Kind::Figures& figures) {
    site.frames.note(Kind::kStage, figures,
                     [&](FrameStats& stats) { Kind::note(stats, site, figures); });
  };
  switch (site.options.levels[Kind::kStage]) {
    case Level::kFunctional:
      break;
    case Level::kTimed:
      return std::make_unique<TimedStage<Kind>>(site, name.c_str(), report);
    case Level::kClocked:
      if constexpr (HasClocked<Kind>)
        return std::make_unique<ClockedStage<Kind>>(site, name.c_str(), report);
      break;
    case Level::kRtl:
      if constexpr (HasRtl<Kind>)
        return std::make_unique<RtlStage<Kind>>(site, name.c_str(), report);
      break;
  }
  throw std::logic_error(name + " has no such level");
}

}  // namespace cigsim
