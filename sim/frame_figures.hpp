// SPDX-License-Identifier: MIT
// From what a stage tells of a frame to the frame's statistics, whichever level it had.
#pragma once

#include <utility>
#include <vector>

#include "models/edge_orderer/figures.hpp"
#include "models/geometry_processor/figures.hpp"
#include "models/priority_processor/figures.hpp"
#include "models/priority_resolver/figures.hpp"
#include "models/video_processor/figures.hpp"
#include "sim/frame_stats.hpp"

namespace cigsim {

/// `named`: the faults of the figures, by name.
inline void add_figures(FrameStats& stats, const priority_processor::Figures& figures,
                        std::vector<ListabilityFault> named) {
  stats.active_items = figures.items;
  stats.ordered_groups = figures.groups;
  stats.tested_planes = figures.planes;
  stats.faults = static_cast<std::uint32_t>(figures.faults.size());
  stats.listability = std::move(named);
  stats.overload->dropped_items = figures.dropped;
}

inline void add_figures(FrameStats& stats, const geometry_processor::Figures& figures) {
  stats.faces = figures.front_faces;
  stats.edges = figures.edges;
  stats.overload->dropped_faces = figures.dropped;
}

inline void add_figures(FrameStats& stats, const edge_orderer::Figures& figures) {
  stats.crossings = figures.crossings;
  stats.worst_line = figures.worst_line;
  stats.worst_line_crossings = figures.worst_line_crossings;
  stats.overload->overfull_lines = figures.overfull_lines;
  stats.overload->dropped_crossings = figures.dropped;
}

inline void add_figures(FrameStats& stats, const priority_resolver::Figures& figures) {
  stats.spans = figures.face_spans;
}

inline void add_figures(FrameStats& stats, const video_processor::Figures& figures) {
  stats.overload->late_lines = figures.late_lines;
  stats.overload->worst_lateness = figures.worst_lateness;
}

}  // namespace cigsim
