// SPDX-License-Identifier: MIT
// The six stages at the functional level on machine words: the bit-true golden model.
#pragma once

#include "models/edge_orderer/functional.hpp"
#include "models/frame_calculator/memory_loader.hpp"
#include "models/geometry_processor/functional_words.hpp"
#include "models/priority_processor/functional_words.hpp"
#include "models/priority_resolver/functional.hpp"
#include "models/video_processor/functional.hpp"
#include "sim/frame_faces.hpp"
#include "sim/frame_stats.hpp"

namespace cigsim {

class WordStages {
 public:
  /// `eye_reach`: as coordinate_scale(). `detail`: as MachineOptions.
  WordStages(const MachineDescription& machine, OverloadPolicy policy, double eye_reach,
             double detail = 1);

  /// Computes a frame into `picture` and its figures. `position` places the moving models.
  void compute(const Database& database, const Viewpoint& viewpoint, double position,
               Picture& picture, FrameStats& stats);

  /// Of the last frame, before lines drop any.
  FrameFaces faces() const { return frame_faces(edges_, machine_.raster); }

 private:
  MachineDescription machine_;
  frame_calculator::MemoryLoader loader_;
  priority_processor::FunctionalWords priority_;
  geometry_processor::FunctionalWords geometry_;
  edge_orderer::Functional<MachineWord> orderer_;
  priority_resolver::Functional resolver_;
  video_processor::Functional video_;
  std::vector<ItemWord> items_;
  EdgeList<MachineWord> edges_;
  edge_orderer::OrderedCrossings crossings_;
  priority_resolver::SpanLines spans_;
};

}  // namespace cigsim
