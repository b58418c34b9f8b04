// SPDX-License-Identifier: MIT
// Edge orderer, clocked level (docs/machine/edge_orderer.md): registers, memories and pins, one
// transition a clock.
#pragma once

#include <array>
#include <systemc>
#include <vector>

#include "models/boundary/clock.hpp"
#include "models/boundary/pins.hpp"
#include "models/boundary/trace_words.hpp"
#include "models/edge_orderer/figures.hpp"
#include "models/edge_orderer/sorting_memory.hpp"
#include "models/machine/description.hpp"

namespace cigsim::edge_orderer {

class Clocked : public sc_core::sc_module {
 public:
  /// `time` numbers the cycles of `clock`. `figures`, which may be empty, is called once a frame,
  /// when its last word is in the link.
  Clocked(sc_core::sc_module_name name, const MachineDescription& machine, OverloadPolicy policy,
          const Clock& time, FiguresFunction figures = {});

  sc_core::sc_in<bool> clock{"clock"};
  PinIn<EdgeWord> edges{"edges"};
  PinOut<FrameWord> loaded{"loaded"};
  PinIn<FrameWord> start{"start"};
  PinOut<CrossingWord> crossings{"crossings"};

  /// Pins and registers; call it when the pins are bound and elaboration is done.
  void trace(sc_core::sc_trace_file* file) const;

 private:
  struct Edge {
    std::uint32_t face = 0, next = kNone;  ///< next: place of the next one in its bucket
    std::uint16_t end_line = 0;
    bool left = false;
    Word x = 0, slope = 0;
  };
  struct Bucket {
    std::uint32_t first = kNone, count = 0;
  };
  struct Bank {
    std::vector<Edge> edges;
    std::vector<Bucket> buckets;
    std::uint32_t used = 0;
  };
  enum Fill : std::uint32_t { kIdle, kBegin, kInsert, kWait, kDone };

  void load_edge();
  void store(const EdgeWord& word);

  void line_edge();
  void begin_frame(std::uint32_t frame, Cycle now);
  void drain(Cycle now);
  void fill();
  void begin_pass();
  void insert_crossing();
  void step(Edge& edge, std::uint32_t place);
  void end_pass();
  void offer(Cycle now);
  void end_frame(Cycle now);

  const Clock& time_;
  FiguresFunction report_;
  Word width_;
  std::uint32_t height_, pass_size_;
  std::array<Bank, 2> banks_;

  // Load side.
  std::uint32_t load_frame_ = 0, load_place_ = 0;
  bool loading_ = true;

  // Line side: filling.
  std::uint32_t fill_ = kIdle;
  std::uint32_t line_ = 0, fill_memory_ = 0;
  std::uint32_t passes_left_ = 0;  // of the line, this one included; 0: its first has not begun
  std::uint32_t remaining_ = 0;    // crossings of the pass still to insert
  std::uint32_t bucket_place_ = kNone, list_place_ = 0;
  Bank* bank_ = nullptr;
  std::vector<std::uint32_t> list_, written_back_;  // the active list before and behind its end
  SortingMemory::LineRegisters registers_;

  // Line side: draining.
  std::array<SortingMemory, 2> memories_;
  std::uint32_t drain_memory_ = 0, drain_line_ = 0;
  bool offering_ = false;
  Cycle offered_ = 0;

  Figures figures_;
};

}  // namespace cigsim::edge_orderer
