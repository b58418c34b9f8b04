// SPDX-License-Identifier: MIT
// Geometry processor, clocked level (docs/machine/geometry_processor.md): the data path and its
// microprogram, one microinstruction a clock. Nothing of the algorithm is here: only what each
// field of firmware/geometry_processor/format.fmt does to the registers.
#pragma once

#include <array>
#include <systemc>
#include <vector>

#include "firmware/assembler/program.hpp"
#include "firmware/sequencer.hpp"
#include "models/boundary/clock.hpp"
#include "models/boundary/pins.hpp"
#include "models/boundary/trace_words.hpp"
#include "models/geometry_processor/divider.hpp"
#include "models/geometry_processor/figures.hpp"
#include "models/geometry_processor/memory.hpp"
#include "models/machine/description.hpp"

namespace cigsim::geometry_processor {

class Clocked : public sc_core::sc_module {
 public:
  /// `time` numbers the cycles of `clock`. Reads the bank of the frame's parity, from the start
  /// word to the last end word. `figures`, which may be empty, is called once a frame. Throws
  /// std::invalid_argument for a raster that 13.18 does not hold.
  Clocked(sc_core::sc_module_name name, const MachineDescription& machine, OverloadPolicy overload,
          const Clock& time, const std::array<GeometryBank, 2>& banks,
          FiguresFunction figures = {});

  sc_core::sc_in<bool> clock{"clock"};
  PinIn<FrameWord> start{"start"};
  PinIn<ItemWord> items{"items"};
  PinOut<EdgeWord> edges{"edges"};
  PinOut<FaceWord> faces{"faces"};

  void trace(sc_core::sc_trace_file* file) const;

 private:
  /// A microinstruction, its fields apart.
  struct Instruction {
    firmware::SequencerOp op;
    bool pol, ip, flip;
    std::uint16_t address;
    std::uint8_t cond, take, a, b, alu, shift, to, x, y, mac, acc, div, vm, lm, lw, pt, va, code,
        fp, vp, v, f, k, sel, plane, side, word, put, tally;
  };
  struct Vertex {
    Word field[8];  ///< d, u, v, w, column, line
    std::uint8_t code;
  };
  struct LoopPoint {
    Word field[5];  ///< u, v, w, column, line
  };

  void decode(const firmware::Program& program);
  void edge();
  void execute(const Instruction& word, Cycle now);
  void finish(Cycle now);
  void sleep(const Instruction& next);

  std::size_t place(std::uint8_t code) const;
  std::int64_t operand(std::uint8_t code, const Instruction& word);
  std::int64_t unit(std::uint8_t code, const Instruction& word);
  std::int64_t read_accumulator(std::uint8_t how);
  std::int64_t add(const Instruction& word, std::int64_t a, std::int64_t b) const;
  bool condition(const Instruction& word, std::int64_t value, bool full) const;
  bool late(Cycle now) const { return now - figures_.activity.start >= deadline_; }

  void take(const Instruction& word, Cycle now);
  void multiply(const Instruction& word, std::int64_t a);
  void divide(const Instruction& word, std::int64_t a, std::int64_t b, std::int64_t value);
  void write_memories(const Instruction& word, Word value);
  void step_points(const Instruction& word, std::int64_t value);
  void step_code(const Instruction& word, bool negative);
  void step_addresses(const Instruction& word, std::int64_t value);
  void step_counters(const Instruction& word, std::int64_t value);
  void step_flags(const Instruction& word, std::int64_t value);
  void put(const Instruction& word, std::int64_t value);

  const Clock& time_;
  const std::array<GeometryBank, 2>& banks_;
  FiguresFunction report_;
  const WordFormats formats_;
  const std::uint32_t edge_capacity_, face_capacity_;
  const Cycle deadline_;
  Divider divider_;
  std::vector<Instruction> program_;
  std::uint32_t last_ = 0;  // address after which the frame is over

  firmware::Sequencer sequencer_;
  std::uint32_t address_ = 0;  // of the sequencer, for waves
  const GeometryBank* bank_ = nullptr;
  const FaceMemory* memory_ = nullptr;
  bool item_end_ = false;

  std::array<std::int64_t, 34> registers_{};  // by code of operands; constants among them
  std::uint32_t current_ = 0;                 // which set of point registers is a
  std::uint32_t selected_ = 0;                // and which is S
  std::int64_t x_ = 0, y_ = 0, accumulator_ = 0;
  std::uint8_t mac_ = 0;  // of the instruction before

  std::uint32_t ip_ = 0, fp_ = 0, vp_ = 0, va_ = 0, lr_ = 0, lw_ = 0;
  std::uint32_t first_corner_ = 0, next_corner_ = 0;
  std::uint32_t vertices_left_ = 0, faces_left_ = 0, k_ = 0, count_ = 0;
  bool points_in_loop_ = false;
  std::uint32_t read_part_ = 0;
  std::uint8_t code_ = 0, all_ = 0, any_ = 0, plane_ = 0;
  bool two_sided_ = false, front_ = false, down_ = false, made_ = false, is_late_ = false;
  std::vector<Vertex> vertex_memory_;
  std::array<std::vector<LoopPoint>, 2> loop_memory_;

  EdgeWord edge_word_;
  FaceWord face_word_;
  std::uint32_t edges_put_ = 0, faces_put_ = 0;
  bool edge_valid_ = false, face_valid_ = false;
  bool edge_free_ = true, face_free_ = true;  // in this cycle
  bool start_ready_ = false, items_ready_ = false;

  enum class Wait : std::uint8_t { kNone, kItem, kOut } waits_ = Wait::kNone;
  Cycle last_edge_ = -1;
  Figures figures_;
};

}  // namespace cigsim::geometry_processor
