// SPDX-License-Identifier: MIT
#include "models/edge_orderer/clocked.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "models/boundary/tracer.hpp"

namespace cigsim::edge_orderer {
namespace {

// EO2.
std::uint16_t element_of(Word x, Word width) {
  if (x <= 0) return 0;
  const Word whole = x >> kRasterFraction;
  const bool above = (x & ((1 << kRasterFraction) - 1)) != 0;
  return static_cast<std::uint16_t>(std::min(whole + above, width));
}

}  // namespace

Clocked::Clocked(sc_core::sc_module_name name, const MachineDescription& machine,
                 OverloadPolicy policy, const Clock& time, FiguresFunction figures)
    : sc_module(name),
      time_(time),
      report_(std::move(figures)),
      width_(machine.raster.width),
      height_(static_cast<std::uint32_t>(machine.raster.height)),
      pass_size_(policy == OverloadPolicy::kExtend && machine.crossing_capacity > 0
                     ? machine.crossing_capacity
                     : std::numeric_limits<std::uint32_t>::max()),
      memories_{SortingMemory(machine.crossing_capacity, policy),
                SortingMemory(machine.crossing_capacity, policy)} {
  SC_HAS_PROCESS(Clocked);
  SC_METHOD(load_edge);
  dont_initialize();
  sensitive << clock.pos();
  SC_METHOD(line_edge);
  dont_initialize();
  sensitive << clock.pos();
  edges.ready.initialize(true);
  start.ready.initialize(true);
  for (Bank& bank : banks_) {
    bank.edges.resize(machine.edge_capacity);
    bank.buckets.resize(height_);
  }
}

void Clocked::trace(sc_core::sc_trace_file* file) const {
  const Tracer show(file, *this);
  show.pins(edges, "edges");
  show.pins(loaded, "loaded");
  show.pins(start, "start");
  show.pins(crossings, "crossings");
  show.state(load_frame_, "load_frame", 32);
  show.state(load_place_, "load_place", 32);
  show.state(fill_, "fill", 3);
  show.state(line_, "line", 14);
  show.state(passes_left_, "passes_left", 16);
  show.state(remaining_, "remaining", 32);
  show.state(fill_memory_, "fill_memory", 1);
  show.state(registers_.limit, "limit", 32);
  show.state(drain_memory_, "drain_memory", 1);
  show.state(drain_line_, "drain_line", 14);
  show.state(memories_[0].held(), "held_0", 16);
  show.state(memories_[1].held(), "held_1", 16);
}

// EO5, EO6.
void Clocked::load_edge() {
  if (!clock.posedge()) return;
  if (loading_) {
    if (!edges.valid.read()) return next_trigger(edges.valid.value_changed_event());
    store(edges.word.read());
    return;
  }
  if (!loaded.ready.read()) return next_trigger(loaded.ready.value_changed_event());
  loading_ = true;
  ++load_frame_;
  load_place_ = 0;
  loaded.valid.write(false);
  edges.ready.write(true);
}

void Clocked::store(const EdgeWord& word) {
  Bank& bank = banks_[load_frame_ % 2];
  if (word.end) {
    bank.used = load_place_;
    loading_ = false;
    edges.ready.write(false);
    loaded.word.write({load_frame_});
    loaded.valid.write(true);
    return;
  }
  assert(word.first_line < word.end_line && word.end_line <= height_);
  if (load_place_ == bank.edges.size()) bank.edges.resize(2 * bank.edges.size() + 64);
  Bucket& bucket = bank.buckets[word.first_line];
  bank.edges[load_place_] = {word.face, bucket.first, word.end_line, word.left, word.x, word.slope};
  bucket.first = load_place_++;
  ++bucket.count;
}

void Clocked::line_edge() {
  if (!clock.posedge()) return;
  const Cycle now = time_.cycle();
  if (fill_ == kIdle) {
    if (!start.valid.read()) return next_trigger(start.valid.value_changed_event());
    begin_frame(start.word.read().frame, now);
    return;
  }
  drain(now);
  if (fill_ == kIdle) return;
  fill();
  offer(now);
  const bool filling = fill_ == kBegin || fill_ == kInsert;
  if (!filling && !crossings.ready.read()) next_trigger(crossings.ready.value_changed_event());
}

// EO7.
void Clocked::begin_frame(std::uint32_t frame, Cycle now) {
  figures_ = {};
  figures_.frame = frame;
  figures_.activity.start = now;
  bank_ = &banks_[frame % 2];
  figures_.edges = bank_->used;
  start.ready.write(false);
  assert(list_.empty());
  line_ = drain_line_ = fill_memory_ = drain_memory_ = 0;
  fill_ = kBegin;
}

// EO12.
void Clocked::drain(Cycle now) {
  if (!offering_ || !crossings.ready.read()) return;
  offering_ = false;
  figures_.activity.stalled += now - offered_;
  SortingMemory& memory = memories_[drain_memory_];
  const bool ends_line = memory.ends_line();
  if (!memory.shift()) return;
  drain_memory_ ^= 1;
  if (ends_line && ++drain_line_ == height_) end_frame(now);
}

void Clocked::offer(Cycle now) {
  if (offering_) return;
  offering_ = memories_[drain_memory_].filled();
  offered_ = now + 1;
  crossings.valid.write(offering_);
  if (offering_) crossings.word.write(memories_[drain_memory_].front());
}

// EO8.
void Clocked::fill() {
  if (fill_ == kBegin)
    begin_pass();
  else if (fill_ == kInsert)
    insert_crossing();
  if (fill_ == kInsert && remaining_ == 0) end_pass();
  if (fill_ == kWait && !memories_[fill_memory_].filled()) fill_ = kBegin;
}

// EO9.
void Clocked::begin_pass() {
  const Bucket& bucket = bank_->buckets[line_];
  bucket_place_ = bucket.first;
  list_place_ = 0;
  remaining_ = bucket.count + static_cast<std::uint32_t>(list_.size());
  fill_ = kInsert;
  ++figures_.passes;
  if (passes_left_ > 0) return;
  passes_left_ = remaining_ > pass_size_ ? (remaining_ - 1) / pass_size_ + 1 : 1;
  figures_.crossings += remaining_;
  if (remaining_ <= figures_.worst_line_crossings) return;
  figures_.worst_line_crossings = remaining_;
  figures_.worst_line = line_;
}

// EO10.
void Clocked::insert_crossing() {
  const bool from_bucket = bucket_place_ != kNone;
  const std::uint32_t place = from_bucket ? bucket_place_ : list_[list_place_++];
  Edge& edge = bank_->edges[place];
  if (from_bucket) bucket_place_ = edge.next;
  --remaining_;
  figures_.dropped += memories_[fill_memory_].insert(
      {element_of(edge.x, width_), edge.left, edge.face, place}, registers_);
  if (passes_left_ == 1 && edge.end_line > line_ + 1) step(edge, place);
}

// EO1, EO11.
void Clocked::step(Edge& edge, std::uint32_t place) {
  if (__builtin_add_overflow(edge.x, edge.slope, &edge.x)) {
    edge.x = edge.slope < 0 ? std::numeric_limits<Word>::min() : std::numeric_limits<Word>::max();
    ++figures_.overflows;
  }
  written_back_.push_back(place);
}

void Clocked::end_pass() {
  const bool last = --passes_left_ == 0;
  const bool overfull = registers_.limit != kNone || registers_.cut || registers_.marked;
  if (last) figures_.overfull_lines += overfull;
  memories_[fill_memory_].close(last, registers_);
  fill_memory_ ^= 1;
  fill_ = kWait;
  if (!last) return;
  bank_->buckets[line_] = {};
  list_.swap(written_back_);
  written_back_.clear();
  if (++line_ == height_) fill_ = kDone;
}

void Clocked::end_frame(Cycle now) {
  figures_.activity.finish = now;
  crossings.valid.write(false);
  start.ready.write(true);
  fill_ = kIdle;
  if (report_) report_(figures_);
}

}  // namespace cigsim::edge_orderer
