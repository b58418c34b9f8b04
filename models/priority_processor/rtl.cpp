// SPDX-License-Identifier: MIT
#include "models/priority_processor/rtl.hpp"

#include <stdexcept>
#include <string>

#include "firmware/programs.hpp"
#include "models/boundary/tracer.hpp"
#include "models/boundary/wave_part.hpp"
#include "rtl/priority_processor/priority_processor.pins.hpp"

namespace cigsim::priority_processor {
namespace {

using rtl::priority_processor::kImageWords;
using rtl::priority_processor::Pins;

// An address register holds anything until the microprogram first loads it.
std::uint32_t word_at(const std::vector<std::uint32_t>& words, std::uint32_t address) {
  return address < words.size() ? words[address] : 0;
}

}  // namespace

Rtl::Rtl(sc_core::sc_module_name name, const MachineDescription& machine, const Clock& time,
         const std::array<PriorityBank, 2>& banks, const std::filesystem::path& library,
         FiguresFunction figures, std::uint32_t seed)
    : sc_module(name),
      time_(time),
      banks_(banks),
      report_(std::move(figures)),
      model_(library, sizeof(Pins), seed) {
  SC_HAS_PROCESS(Rtl);
  SC_METHOD(edge);
  dont_initialize();
  sensitive << clock.pos();
  model_.pins<Pins>().cfg_object_capacity_i = machine.object_capacity;
  reset();
}

// The control store is written while the machine is in reset.
void Rtl::reset() {
  const firmware::Program program = firmware::stage_program("priority_processor");
  if (program.words.size() > kImageWords)
    throw std::runtime_error(
        "the microprogram " + program.name + " has " + std::to_string(program.words.size()) +
        " words, and the control store of the RTL holds " + std::to_string(kImageWords));
  Pins& pins = model_.pins<Pins>();
  pins.rst_i = true;
  pins.image_write_i = true;
  model_.settle();  // the clock is low before its first edge
  for (std::uint32_t address = 0; address < program.words.size(); ++address) {
    pins.image_address_i = address;
    pins.image_word_i = program.words[address].low;
    model_.edge();
  }
  pins.image_write_i = false;
  model_.edge();
  pins.rst_i = false;
  read_memories();
  ready_ = pins.start_ready_o;
  start.ready.initialize(ready_);
}

void Rtl::drive() {
  Pins& pins = model_.pins<Pins>();
  pins.start_valid_i = start.valid.read();
  pins.start_frame_i = start.word.read().frame;
  pins.items_ready_i = items.ready.read();
}

void Rtl::edge() {
  Pins& pins = model_.pins<Pins>();
  const Cycle now = time_.cycle();
  const bool takes = start.valid.read() && ready_;
  const bool taken = valid_ && items.ready.read();
  const bool item = taken && !pins.items_end_o;
  const bool finished = taken && pins.items_end_o;
  drive();
  model_.edge();
  read_memories();

  if (pins.start_ready_o != ready_) start.ready.write(ready_ = pins.start_ready_o);
  if (pins.items_valid_o && (taken || !valid_))
    items.word.write({static_cast<SetId>(pins.items_set_o), pins.items_item_o, pins.items_end_o});
  if (pins.items_valid_o != valid_) items.valid.write(valid_ = pins.items_valid_o);

  if (takes) {
    figures_ = {};
    figures_.frame = pins.mon_frame_o;
    figures_.activity.start = now;
  }
  count();
  figures_.items += item;
  if (finished) {
    figures_.activity.finish = now;
    if (report_) report_(figures_);
  }
}

// Both addresses are registers: the words of the cycle that begins.
void Rtl::read_memories() {
  Pins& pins = model_.pins<Pins>();
  const PriorityBank& bank = banks_[pins.bank_o];
  pins.memory_word_i = word_at(bank.memory().words, pins.memory_address_o);
  pins.bank_word_i = word_at(bank.words(), pins.bank_address_o);
}

void Rtl::count() {
  const Pins& pins = model_.pins<Pins>();
  figures_.activity.stalled += pins.mon_stalled_o;
  figures_.dropped += pins.mon_dropped_o;
  figures_.groups += pins.mon_group_o;
  figures_.planes += pins.mon_plane_o;
  figures_.pairs += pins.mon_pair_o;
  if (pins.mon_fault_o)
    figures_.faults.push_back((pins.mon_record_o - banks_[pins.bank_o].first_record()) /
                              kRecordWords);
}

void Rtl::trace(sc_core::sc_trace_file* file) {
  const Tracer show(file, *this);
  show.pins(start, "start");
  show.pins(items, "items");
  trace_rtl(file, *this, model_, [this] { drive(); });
}

}  // namespace cigsim::priority_processor
