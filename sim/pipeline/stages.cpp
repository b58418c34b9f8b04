// SPDX-License-Identifier: MIT
// The kinds of stages (placing.hpp), in the order of the data.
#include "models/edge_orderer/clocked.hpp"
#include "models/edge_orderer/rtl.hpp"
#include "models/edge_orderer/timed.hpp"
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
#include "sim/pipeline/placing.hpp"

namespace cigsim {
namespace {

struct FrameCalculator : StageKind<frame_calculator::Figures> {
  static constexpr Stage kStage = Stage::kFrameCalculator;

  static void note(FrameStats&, const Site&, const Figures&) {}

  static auto timed(const Site& s, const char* name, const Report& report) {
    using frame_calculator::Timed;
    return std::make_unique<Timed>(
        name, s.options.description,
        Timed::Links{s.connections.start_calculator.link, s.connections.calculated.link},
        [s](std::uint32_t frame) { return s.frames.calculate(s.loader, frame); }, report);
  }
};

struct PriorityProcessor : StageKind<priority_processor::Figures> {
  static constexpr Stage kStage = Stage::kPriorityProcessor;

  static void note(FrameStats& stats, const Site& s, const Figures& figures) {
    add_figures(stats, figures, s.loader.named_faults(figures.frame, figures.faults));
  }

  static auto timed(const Site& s, const char* name, const Report& report) {
    using priority_processor::Timed;
    return std::make_unique<Timed>(
        name, s.options.description,
        Timed::Links{s.connections.start_priority.link, s.connections.items.link},
        s.loader.priority_banks(), report);
  }
  static auto clocked(const Site& s, const char* name, const Report& report) {
    return std::make_unique<priority_processor::Clocked>(name, s.options.description, s.clock,
                                                         s.loader.priority_banks(), report);
  }
  static auto rtl(const Site& s, const char* name, const Report& report) {
    return std::make_unique<priority_processor::Rtl>(
        name, s.options.description, s.clock, s.loader.priority_banks(),
        s.options.libraries.at(kStage), report, s.options.rtl_seed);
  }

  template <class Wires, class Model>
  static void connect(Wires&& wires, Model& model, Connections& c) {
    wires.input("start", model.start, c.start_priority);
    wires.output("items", model.items, c.items);
  }
};

struct GeometryProcessor : StageKind<geometry_processor::Figures> {
  static constexpr Stage kStage = Stage::kGeometryProcessor;

  static auto timed(const Site& s, const char* name, const Report& report) {
    using geometry_processor::Timed;
    Connections& c = s.connections;
    return std::make_unique<Timed>(
        name, s.options.description, s.options.overload,
        Timed::Links{c.start_geometry.link, c.items.link, c.edges.link, c.faces.link},
        s.loader.geometry_banks(), report);
  }
  static auto clocked(const Site& s, const char* name, const Report& report) {
    return std::make_unique<geometry_processor::Clocked>(name, s.options.description,
                                                         s.options.overload, s.clock,
                                                         s.loader.geometry_banks(), report);
  }

  template <class Wires, class Model>
  static void connect(Wires&& wires, Model& model, Connections& c) {
    wires.input("start", model.start, c.start_geometry);
    wires.input("items", model.items, c.items);
    wires.output("edges", model.edges, c.edges);
    wires.output("faces", model.faces, c.faces);
  }
};

struct EdgeOrderer : StageKind<edge_orderer::Figures> {
  static constexpr Stage kStage = Stage::kEdgeOrderer;
  static constexpr bool kEndsLines = true;

  static auto timed(const Site& s, const char* name, const Report& report) {
    using edge_orderer::Timed;
    Connections& c = s.connections;
    return std::make_unique<Timed>(
        name, s.options.description, s.options.overload,
        Timed::Links{c.edges.link, c.edges_loaded.link, c.start_orderer.link, c.crossings.link},
        report);
  }
  static auto clocked(const Site& s, const char* name, const Report& report) {
    return std::make_unique<edge_orderer::Clocked>(name, s.options.description, s.options.overload,
                                                   s.clock, report);
  }
  static auto rtl(const Site& s, const char* name, const Report& report) {
    return std::make_unique<edge_orderer::Rtl>(name, s.options.description, s.options.overload,
                                               s.clock, s.options.libraries.at(kStage), report,
                                               s.options.rtl_seed);
  }

  template <class Wires, class Model>
  static void connect(Wires&& wires, Model& model, Connections& c) {
    wires.input("edges", model.edges, c.edges);
    wires.input("start", model.start, c.start_orderer);
    wires.output("loaded", model.loaded, c.edges_loaded);
    wires.output("crossings", model.crossings, c.crossings);
  }
};

struct PriorityResolver : StageKind<priority_resolver::Figures> {
  static constexpr Stage kStage = Stage::kPriorityResolver;
  static constexpr bool kEndsLines = true;

  static auto timed(const Site& s, const char* name, const Report& report) {
    using priority_resolver::Timed;
    return std::make_unique<Timed>(
        name, s.options.description,
        Timed::Links{s.connections.crossings.link, s.connections.spans.link}, report);
  }
  static auto clocked(const Site& s, const char* name, const Report& report) {
    return std::make_unique<priority_resolver::Clocked>(name, s.options.description, s.clock,
                                                        report);
  }
  static auto rtl(const Site& s, const char* name, const Report& report) {
    return std::make_unique<priority_resolver::Rtl>(name, s.options.description, s.clock,
                                                    s.options.libraries.at(kStage), report,
                                                    s.options.rtl_seed);
  }

  template <class Wires, class Model>
  static void connect(Wires&& wires, Model& model, Connections& c) {
    wires.input("crossings", model.crossings, c.crossings);
    wires.output("spans", model.spans, c.spans);
  }
};

struct VideoProcessor : StageKind<video_processor::Figures> {
  static constexpr Stage kStage = Stage::kVideoProcessor;

  static auto timed(const Site& s, const char* name, const Report& report) {
    using video_processor::Timed;
    Connections& c = s.connections;
    return std::make_unique<Timed>(name, s.options.description,
                                   Timed::Links{c.faces.link, c.faces_loaded.link,
                                                c.start_video.link, c.spans.link, c.shown.link},
                                   s.loader.video_banks(), outputs(s, report));
  }
  static auto clocked(const Site& s, const char* name, const Report& report) {
    return std::make_unique<video_processor::Clocked>(name, s.options.description, s.clock,
                                                      s.loader.video_banks(), outputs(s, report));
  }

  template <class Wires, class Model>
  static void connect(Wires&& wires, Model& model, Connections& c) {
    wires.input("faces", model.faces, c.faces);
    wires.output("loaded", model.loaded, c.faces_loaded);
    wires.input("start", model.start, c.start_video);
    wires.input("spans", model.spans, c.spans);
    wires.output("shown", model.shown, c.shown);
  }

 private:
  static video_processor::Outputs outputs(const Site& s, const Report& report) {
    return {report,
            [s](std::uint32_t frame, const Picture& picture, Cycle first, Cycle last) {
              s.frames.shown(frame, picture, first, last, s.options.description.frame_cycles);
            },
            {}};
  }
};

}  // namespace

std::unique_ptr<PlacedStage> place(Stage stage, const Site& site) {
  switch (stage) {
    case Stage::kFrameCalculator:
      return place_kind<FrameCalculator>(site);
    case Stage::kPriorityProcessor:
      return place_kind<PriorityProcessor>(site);
    case Stage::kGeometryProcessor:
      return place_kind<GeometryProcessor>(site);
    case Stage::kEdgeOrderer:
      return place_kind<EdgeOrderer>(site);
    case Stage::kPriorityResolver:
      return place_kind<PriorityResolver>(site);
    case Stage::kVideoProcessor:
      break;
  }
  return place_kind<VideoProcessor>(site);
}

}  // namespace cigsim
