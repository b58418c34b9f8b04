// SPDX-License-Identifier: MIT
#include "sim/word_stages.hpp"

#include "sim/frame_figures.hpp"
#include "sim/host_time.hpp"

namespace cigsim {

WordStages::WordStages(const MachineDescription& machine, OverloadPolicy policy, double eye_reach,
                       double detail)
    : machine_(machine),
      loader_(machine, eye_reach, detail),
      priority_(machine.object_capacity),
      geometry_(machine),
      orderer_(machine.crossing_capacity, policy) {}

void WordStages::compute(const Database& database, const Viewpoint& viewpoint, double position,
                         Picture& picture, FrameStats& stats) {
  HostTime time;
  Overload& overload = stats.overload.emplace();
  const auto note = [&overload](Stage stage, const auto& figures) {
    overload.overflows[static_cast<std::size_t>(stage)] = figures.overflows;
  };

  const frame_calculator::Work work = loader_.load(database, viewpoint, position, 0);
  note(Stage::kFrameCalculator, work);
  stats.detail = work.detail;
  stats.stages.frame_calculator = time.lap();

  priority_processor::Figures priority;
  priority_.compute(loader_.priority_banks()[0], items_, priority);
  note(Stage::kPriorityProcessor, priority);
  add_figures(stats, priority, loader_.named_faults(0, priority.faults));
  stats.stages.priority_processor = time.lap();

  geometry_processor::Figures geometry;
  geometry_.compute(loader_.geometry_banks()[0], items_, edges_, geometry);
  note(Stage::kGeometryProcessor, geometry);
  add_figures(stats, geometry);
  stats.stages.geometry_processor = time.lap();

  add_figures(stats, orderer_.compute(edges_, machine_.raster, crossings_));
  stats.stages.edge_orderer = time.lap();

  stats.spans = resolver_.compute(crossings_, edges_.faces.size(), machine_.raster, spans_);
  stats.stages.priority_resolver = time.lap();

  video_.compute(spans_, edges_.faces, database.background, machine_.raster, picture);
  stats.stages.video_processor = time.lap();
  stats.host_ms = time.total();
}

}  // namespace cigsim
