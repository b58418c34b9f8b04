// SPDX-License-Identifier: MIT
// Geometry processor, timed level (docs/machine/geometry_processor.md): a process that gives edges
// and faces in exact cycles, without a clock. What its steps cost is in the microprogram.
#pragma once

#include <array>
#include <systemc>

#include "models/boundary/link.hpp"
#include "models/geometry_processor/face_walk.hpp"

namespace cigsim::geometry_processor {

class Timed : public sc_core::sc_module {
 public:
  struct Links {
    Link<FrameWord>& start;
    Link<ItemWord>& items;
    Link<EdgeWord>& edges;
    Link<FaceWord>& faces;
  };

  /// Reads the bank of the frame's parity, from the start word to the last end word. `figures`,
  /// which may be empty, is called once a frame. Throws std::invalid_argument for a raster that
  /// 13.18 does not hold.
  Timed(sc_core::sc_module_name name, const MachineDescription& machine, OverloadPolicy overload,
        Links links, const std::array<GeometryBank, 2>& banks, FiguresFunction figures = {});

 private:
  /// Moves the cycle on with the steps of the walk.
  struct Pace {
    void spend(Step step, std::size_t times = 1) {
      now += cost[static_cast<std::size_t>(step)] * static_cast<Cycle>(times);
    }
    bool late() const { return now - start >= deadline; }
    ItemWord take();
    void edge(const EdgeWord& word) { put(links.edges, word); }
    void face(const FaceWord& word) { put(links.faces, word); }
    template <class T>
    void put(Link<T>& link, const T& word);

    Links links;
    Cycle deadline = 0;
    Cycle take_cost = 0;
    std::array<Cycle, static_cast<std::size_t>(Step::kCount)> cost{};
    Cycle start = 0, now = 0, idle = 0, stalled = 0;
  };

  void run();
  void frame();

  const std::array<GeometryBank, 2>& banks_;
  FiguresFunction report_;
  Pace pace_;
  FaceWalk<Pace> walk_;
  Cycle start_cost_ = 0, end_faces_ = 0, end_edges_ = 0, finish_ = 0;
  Cycle free_ = 0;  // from this cycle on a start word can be taken
  Figures figures_;
};

}  // namespace cigsim::geometry_processor
