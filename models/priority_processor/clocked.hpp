// SPDX-License-Identifier: MIT
// Priority processor, clocked level (docs/machine/priority_processor.md): the data path and its
// microprogram, one microinstruction a clock. Nothing of the algorithm is here: only what each
// field of firmware/priority_processor/format.fmt does to the registers.
#pragma once

#include <array>
#include <systemc>
#include <vector>

#include "firmware/assembler/program.hpp"
#include "firmware/sequencer.hpp"
#include "models/boundary/clock.hpp"
#include "models/boundary/pins.hpp"
#include "models/boundary/trace_words.hpp"
#include "models/machine/description.hpp"
#include "models/priority_processor/figures.hpp"
#include "models/priority_processor/memory.hpp"

namespace cigsim::priority_processor {

class Clocked : public sc_core::sc_module {
 public:
  /// `time` numbers the cycles of `clock`. Reads the bank of the frame's parity, from the start
  /// word to the end word. `figures`, which may be empty, is called once a frame.
  Clocked(sc_core::sc_module_name name, const MachineDescription& machine, const Clock& time,
          const std::array<PriorityBank, 2>& banks, FiguresFunction figures = {});

  sc_core::sc_in<bool> clock{"clock"};
  PinIn<FrameWord> start{"start"};
  PinOut<ItemWord> items{"items"};

  /// Pins and registers; call it when the pins are bound and elaboration is done.
  void trace(sc_core::sc_trace_file* file) const;

  /// The members' counters as they stand, those of the group that was ordered last.
  const std::array<std::uint8_t, kGroupCapacity>& counts() const { return counts_; }

 private:
  /// A microinstruction, its fields apart.
  struct Instruction {
    firmware::SequencerOp op;
    bool pol, d_data, take, planes, fault;
    std::uint16_t address;
    std::uint8_t cond, src, load, mar, bar, acc, count, rest, list, rank, level, place, put;
  };
  /// The state of a level of groups.
  struct Place {
    std::uint8_t place = 0, number = 0;
  };

  void decode(const firmware::Program& program);
  void edge();
  void execute(const Instruction& word, Cycle now);
  void finish(Cycle now);
  std::uint32_t bus(const Instruction& word) const;
  bool condition(const Instruction& word, std::uint32_t value, bool full) const;
  void accumulate(const Instruction& word, std::uint32_t value);
  void count_pair(std::uint32_t pair);
  void list_member(const Instruction& word, std::uint32_t value);
  void step_level(const Instruction& word);
  void load(const Instruction& word, std::uint32_t value);
  void address_memories(const Instruction& word, std::uint32_t value);
  void put(const Instruction& word, std::uint32_t value);
  void take();
  void sleep(const Instruction& next);

  std::uint32_t first_of_rest() const;
  std::uint32_t order_address(std::uint32_t place) const { return level_ * kGroupCapacity + place; }

  const Clock& time_;
  const std::array<PriorityBank, 2>& banks_;
  FiguresFunction report_;
  const std::uint32_t capacity_;
  std::vector<Instruction> program_;
  std::uint32_t last_ = 0;  // address after which the frame is over

  firmware::Sequencer sequencer_;
  std::uint32_t address_ = 0;  // of the sequencer, for waves
  std::uint32_t parity_ = 0;
  std::uint32_t mar_ = 0, bar_ = 0, t_ = 0;
  Word eye_[3] = {};
  std::uint32_t directory_ = 0, ground_ = 0, ground_item_ = 0;
  std::uint64_t mask_ = 0, rest_ = 0, seen_ = 0;
  std::uint32_t child_ = 0, next_child_ = 0, members_ = 0, planes_ = 0;
  std::uint64_t accumulator_ = 0;
  std::array<std::uint8_t, kGroupCapacity> counts_{};
  std::uint32_t listed_ = 0, largest_ = 0, rank_ = 0;
  bool twice_ = false;
  std::uint32_t level_ = 0, group_ = 0;
  std::vector<Place> places_;         // a level, as many as the database needs
  std::vector<std::uint32_t> order_;  // kGroupCapacity words a level
  std::uint32_t put_items_ = 0;
  bool valid_ = false, ready_ = false;

  bool stalled_ = false;  // the last instruction waited for the output register
  Cycle last_edge_ = -1;
  Figures figures_;
};

}  // namespace cigsim::priority_processor
