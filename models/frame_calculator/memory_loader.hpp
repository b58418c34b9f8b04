// SPDX-License-Identifier: MIT
// What the frame calculator writes into the memories of the other stages: the database's image
// once, and the banks of a frame (docs/machine.md, "Frames", F4).
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "models/frame_calculator/work.hpp"
#include "models/geometry_processor/memory.hpp"
#include "models/machine/description.hpp"
#include "models/priority_processor/memory.hpp"
#include "models/video_processor/bank.hpp"

namespace cigsim::frame_calculator {

class MemoryLoader {
 public:
  /// `eye_reach`: as coordinate_scale(). `detail`: as Functional.
  MemoryLoader(const MachineDescription& machine, double eye_reach, double detail = 1);

  /// Calculates a frame into the banks of its parity: `position` places the moving models. A
  /// database's image is made when it comes first and kept while frames of it follow each other; it
  /// is known by its address and must outlive its frames. Throws std::invalid_argument with a clear
  /// sentence for what the machine's memories cannot hold; the banks then keep what they had.
  Work load(const Database& database, const Viewpoint& viewpoint, double position,
            std::uint32_t frame);

  const std::array<priority_processor::PriorityBank, 2>& priority_banks() const {
    return priority_;
  }
  const std::array<geometry_processor::GeometryBank, 2>& geometry_banks() const {
    return geometry_;
  }
  const video_processor::VideoBanks& video_banks() const { return video_; }
  /// The priority processor's faults in a frame whose banks still stand (Figures::faults), named.
  std::vector<ListabilityFault> named_faults(std::uint32_t frame,
                                             const std::vector<std::uint32_t>& faults) const;

 private:
  // The database in words.
  struct Image {
    Image(const Database& database, const MachineDescription& machine, double eye_reach);
    const Database* database;
    int scale;
    priority_processor::PriorityMemory priority;
    geometry_processor::FaceMemory faces, ground;
  };
  // What stands behind the banks of a parity.
  struct Side {
    std::shared_ptr<const Image> image;
    ActiveEnvironment active;
    FaceSet moving;
    std::unique_ptr<geometry_processor::FaceMemory> moving_faces;
  };

  MachineDescription machine_;
  double eye_reach_, detail_;
  priority_processor::PriorityMemory nothing_;  ///< what the banks hold before the first frame
  std::shared_ptr<const Image> image_;
  std::array<Side, 2> sides_;
  std::array<priority_processor::PriorityBank, 2> priority_;
  std::array<geometry_processor::GeometryBank, 2> geometry_;
  video_processor::VideoBanks video_;
};

}  // namespace cigsim::frame_calculator
