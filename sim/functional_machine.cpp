// SPDX-License-Identifier: MIT
#include "sim/functional_machine.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <variant>

#include "models/edge_orderer/functional.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/geometry_processor/functional.hpp"
#include "models/geometry_processor/functional_certified.hpp"
#include "models/priority_processor/functional.hpp"
#include "models/priority_resolver/coverage.hpp"
#include "models/priority_resolver/functional.hpp"
#include "models/video_processor/functional.hpp"
#include "models/video_processor/painter.hpp"
#include "sim/host_time.hpp"
#include "sim/word_stages.hpp"

namespace cigsim {
namespace {

// How many times over faces may cover the raster before resolving costs less than painting.
constexpr double kPaintedDepth = 3;

// The stages that depend on the number type.
template <class N>
struct Stages {
  Stages(PriorityMethod method, bool coherent) : priority(method, coherent) {}

  priority_processor::Functional<N> priority;
  geometry_processor::Functional<N> geometry;
  edge_orderer::Functional<N> orderer;
  priority_resolver::Coverage<N> coverage;
  video_processor::Painter<N> painter;
  EdgeList<N> edges;
};

using AnyStages = std::variant<Stages<double>, Stages<float>, Stages<Certified>, Stages<Exact>>;

AnyStages make_stages(const MachineOptions& options) {
  switch (options.number) {
    case NumberType::kFloat:
      return Stages<float>(options.priority, options.coherence);
    case NumberType::kCertified:
      return Stages<Certified>(options.priority, options.coherence);
    case NumberType::kExact:
      return Stages<Exact>(options.priority, options.coherence);
    case NumberType::kMachine:
    case NumberType::kDouble:
      break;
  }
  return Stages<double>(options.priority, options.coherence);
}

}  // namespace

class FunctionalMachine::Impl {
 public:
  Impl(const Database& database, const MachineOptions& options)
      : database_(database),
        options_(options),
        frame_calculator_(database, options.detail, options.retrieval),
        stages_(make_stages(options)) {
    picture_.fit(options.raster);  // the display's memory is there before the first frame
    if (options.number == NumberType::kMachine)
      words_ = std::make_unique<WordStages>(options.description, options.overload,
                                            options.eye_reach, options.detail);
  }

  const Picture& compute(const Viewpoint& viewpoint, double frame) {
    stats_ = {};
    counted_ = words_ != nullptr;
    if (words_) {
      words_->compute(database_, viewpoint, frame, picture_, stats_);
      return picture_;
    }
    const std::uint64_t fallbacks = exact_fallbacks();
    HostTime time;
    frame_calculator_.compute(viewpoint, options_.raster, frame, active_, moving_);
    stats_.detail = active_.detail;
    stats_.stages.frame_calculator = time.lap();
    std::visit([&](auto& stages) { run(stages, time); }, stages_);
    stats_.host_ms = time.total();
    stats_.exact_tests = exact_fallbacks() - fallbacks;
    stats_.certified =
        options_.number == NumberType::kExact || options_.number == NumberType::kCertified;
    if (stats_.redone) stats_.redone->exact_tests = stats_.exact_tests;
    return picture_;
  }

  FrameFaces faces() const {
    if (words_) return words_->faces();
    return std::visit([this](const auto& s) { return frame_faces(s.edges, options_.raster); },
                      stages_);
  }

  const FrameStats& stats() {
    if (!counted_) std::visit([this](auto& stages) { count(stages); }, stages_);
    counted_ = true;
    return stats_;
  }

 private:
  template <class N>
  void run(Stages<N>& s, HostTime& time) {
    const Raster& raster = options_.raster;
    s.priority.compute(database_.systems[0].hierarchy, database_.systems[0].set, active_,
                       database_.ground, list_);
    stats_.stages.priority_processor = time.lap();
    s.geometry.compute(active_.view, {&database_.systems[0].set, &moving_, &database_.ground},
                       list_.items, s.edges);
    stats_.stages.geometry_processor = time.lap();
    resolved_ = !paints(s.edges);
    if (!resolved_) {
      s.painter.compute(s.edges, database_.background, raster, picture_);
      stats_.stages.video_processor = time.lap();
      note_redone(s.edges, s.painter.stepper());
      return;
    }
    s.painter.forget();
    if (options_.resolver == ResolverMethod::kActiveList) {
      s.orderer.compute(s.edges, raster, crossings_);
      stats_.stages.edge_orderer = time.lap();
      stats_.spans = resolver_.compute(crossings_, s.edges.faces.size(), raster, spans_);
      note_redone(s.edges, s.orderer.stepper());
    } else {
      stats_.spans = s.coverage.compute(s.edges, raster, spans_);
      note_redone(s.edges, s.coverage.stepper());
    }
    stats_.stages.priority_resolver = time.lap();
    video_.compute(spans_, s.edges.faces, database_.background, raster, picture_);
    stats_.stages.video_processor = time.lap();
  }

  template <class N>
  void note_redone(const EdgeList<N>&, const edge_orderer::ListStepper<N>&) {}
  void note_redone(const EdgeList<Certified>& edges,
                   const edge_orderer::ListStepper<Certified>& stepper) {
    Redone& redone = stats_.redone.emplace();
    redone.vertices = edges.redone.vertices;
    redone.vertices_redone = edges.redone.vertices_redone;
    redone.faces = edges.redone.faces;
    redone.faces_redone = edges.redone.faces_redone;
    redone.edges = edges.edges.size();
    for (const Edge<Certified>& edge : edges.edges)
      redone.crossings += static_cast<std::uint64_t>(edge.end_line - edge.first_line);
    redone.crossings_redone = stepper.redone();
  }

  template <class N>
  bool paints(const EdgeList<N>& edges) const {
    if (options_.resolver != ResolverMethod::kAuto)
      return options_.resolver == ResolverMethod::kPainter;
    double area = 0;
    for (const RasterFace& face : edges.faces) area += face.area;
    return area <= kPaintedDepth * options_.raster.width * options_.raster.height;
  }

  template <class N>
  void count(Stages<N>& stages) {
    const EdgeList<N>& edges = stages.edges;
    if (!resolved_) stats_.spans = stages.coverage.compute(edges, options_.raster, spans_);
    stats_.active_items = list_.items.size();
    const priority_processor::OrderingWork& work = stages.priority.work();
    stats_.ordered_groups = work.ordered_groups;
    stats_.reused_groups = work.reused_groups;
    stats_.tested_planes = work.tested_planes;
    stats_.faults = static_cast<std::uint32_t>(list_.faults.size());
    stats_.listability = list_.faults;
    stats_.faces = edges.faces.size();
    stats_.edges = edges.edges.size();
    // Crossings begin and end with edges: a running sum over the lines gives each line's.
    line_changes_.assign(static_cast<std::size_t>(options_.raster.height) + 1, 0);
    for (const Edge<N>& edge : edges.edges) {
      stats_.crossings += static_cast<std::uint64_t>(edge.end_line - edge.first_line);
      ++line_changes_[static_cast<std::size_t>(edge.first_line)];
      --line_changes_[static_cast<std::size_t>(edge.end_line)];
    }
    std::int64_t crossings = 0;
    for (std::size_t line = 0; line < line_changes_.size(); ++line) {
      crossings += line_changes_[line];
      if (static_cast<std::uint64_t>(crossings) <= stats_.worst_line_crossings) continue;
      stats_.worst_line_crossings = static_cast<std::uint64_t>(crossings);
      stats_.worst_line = static_cast<std::uint32_t>(line);
    }
  }

  const Database& database_;
  MachineOptions options_;
  frame_calculator::Functional frame_calculator_;
  AnyStages stages_;
  std::unique_ptr<WordStages> words_;  // instead, on machine words
  priority_resolver::Functional resolver_;
  video_processor::Functional video_;
  ActiveEnvironment active_;
  FaceSet moving_;
  PriorityList list_;
  edge_orderer::OrderedCrossings crossings_;
  priority_resolver::SpanLines spans_;
  Picture picture_;
  FrameStats stats_;
  bool resolved_ = false;  // spans_ are those of the frame
  bool counted_ = false;   // stats_ are complete
  std::vector<std::int64_t> line_changes_;
};

FunctionalMachine::FunctionalMachine(const Database& database, const MachineOptions& options) {
  const Raster& raster = options.raster;
  if (raster.width < 1 || raster.width > 16384 || raster.height < 1 || raster.height > 16384)
    throw std::invalid_argument("raster: width and height must lie in 1..16384");
  impl_ = std::make_unique<Impl>(database, options);
}
FunctionalMachine::~FunctionalMachine() = default;
FunctionalMachine::FunctionalMachine(FunctionalMachine&&) noexcept = default;

const Picture& FunctionalMachine::compute(const Viewpoint& viewpoint, double frame) {
  return impl_->compute(viewpoint, frame);
}
const FrameStats& FunctionalMachine::stats() const { return impl_->stats(); }
FrameFaces FunctionalMachine::faces() const { return impl_->faces(); }

Placement look_at(const Vec3& eye, const Vec3& target) {
  const Vec3 d = target - eye;
  const double level = std::hypot(d.x, d.y);
  if (level == 0 && d.z == 0)
    throw std::invalid_argument("the eyepoint and the point looked at are the same");
  Placement placement;
  placement.position = eye;
  placement.heading = level == 0 ? 0 : std::atan2(d.x, d.y) * 180 / std::numbers::pi;
  placement.pitch = std::atan2(d.z, level) * 180 / std::numbers::pi;
  return placement;
}

}  // namespace cigsim
