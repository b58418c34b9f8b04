// SPDX-License-Identifier: MIT
#include "models/priority_processor/clocked.hpp"

#include <algorithm>
#include <bit>

#include "firmware/programs.hpp"
#include "models/boundary/tracer.hpp"

namespace cigsim::priority_processor {
namespace {

// Codes of the fields, as firmware/priority_processor/format.fmt declares them.
enum Condition : std::uint8_t {
  kTrue,
  kStart,
  kZero,
  kBit31,
  kMany,
  kPlanes,
  kMembers,
  kFault,
  kLastRank,
  kOpened,
  kInside,
  kFull,
  kGrounds
};
enum Source : std::uint8_t { kNoSource, kMem, kBank, kOrder, kT };
enum Load : std::uint8_t {
  kNoLoad,
  kLoadEyeX,
  kLoadEyeY,
  kLoadEyeZ,
  kLoadDirectory,
  kLoadGround,
  kLoadMaskLow,
  kLoadMaskHigh,
  kLoadChild,
  kLoadMembers,
  kLoadPlanes,
  kLoadT
};
enum Address : std::uint8_t { kAddressHold, kAddressInc, kAddressLoad, kAddressSpecial };
enum Accumulate : std::uint8_t { kAccHold, kAccX, kAccY, kAccZ, kAccLow, kAccHigh };
enum Count : std::uint8_t { kCountHold, kCountClear, kCountPair };
enum Rest : std::uint8_t { kRestHold, kRestLoad, kRestNext };
enum List : std::uint8_t { kListHold, kListClear, kListCount, kListRank };
enum Rank : std::uint8_t { kRankHold, kRankClear, kRankInc };
enum LevelStep : std::uint8_t { kLevelHold, kLevelInc, kLevelDec };
enum PlaceStep : std::uint8_t { kPlaceHold, kPlaceBegin, kPlaceNext };
enum Put : std::uint8_t { kNoPut, kPutItem, kPutGround, kPutEnd };

constexpr std::uint32_t kOutside = 0xffff'ffff;  // of level: no group
constexpr std::uint8_t kMostCount = 63;

}  // namespace

Clocked::Clocked(sc_core::sc_module_name name, const MachineDescription& machine, const Clock& time,
                 const std::array<PriorityBank, 2>& banks, FiguresFunction figures)
    : sc_module(name),
      time_(time),
      banks_(banks),
      report_(std::move(figures)),
      capacity_(machine.object_capacity) {
  SC_HAS_PROCESS(Clocked);
  SC_METHOD(edge);
  dont_initialize();
  sensitive << clock.pos();
  decode(firmware::stage_program("priority_processor"));
  ready_ = program_[0].take;
  start.ready.initialize(ready_);
}

void Clocked::decode(const firmware::Program& program) {
  const auto place = [&](const char* name) { return program.format.place(name); };
  const auto op = place("op"), pol = place("pol"), d = place("d"), address = place("address"),
             cond = place("cond"), take = place("take"), src = place("src"), load = place("load"),
             mar = place("mar"), bar = place("bar"), acc = place("acc"), count = place("count"),
             rest = place("rest"), list = place("list"), rank = place("rank"),
             level = place("level"), places = place("place"), planes = place("planes"),
             put = place("put"), fault = place("fault");
  for (const firmware::Microword& word : program.words) {
    const auto get = [&](const firmware::FieldPlace& field) {
      return static_cast<std::uint8_t>(field.get(word));
    };
    Instruction i{};
    i.op = static_cast<firmware::SequencerOp>(get(op));
    i.pol = get(pol);
    i.d_data = get(d);
    i.address = static_cast<std::uint16_t>(address.get(word));
    i.take = get(take);
    i.planes = get(planes);
    i.fault = get(fault);
    i.cond = get(cond);
    i.src = get(src);
    i.load = get(load);
    i.mar = get(mar);
    i.bar = get(bar);
    i.acc = get(acc);
    i.count = get(count);
    i.rest = get(rest);
    i.list = get(list);
    i.rank = get(rank);
    i.level = get(level);
    i.place = get(places);
    i.put = get(put);
    program_.push_back(i);
  }
  last_ = program.address("finish");
}

void Clocked::edge() {
  if (!clock.posedge()) return;  // woken from sleep between two edges: the next one counts
  const Cycle now = time_.cycle();
  if (stalled_) figures_.activity.stalled += now - last_edge_ - 1;  // slept through
  last_edge_ = now;
  execute(program_[sequencer_.address()], now);
  address_ = sequencer_.address();
  const Instruction& next = program_[address_];
  if (next.take != ready_) start.ready.write(ready_ = next.take);
  if (address_ == last_) finish(now);
  sleep(next);
}

// All fields act on the registers' values from before, so what is read goes before what is written.
void Clocked::execute(const Instruction& word, Cycle now) {
  const bool free = !valid_ || items.ready.read();  // PP8
  const bool counted = word.put == kPutItem || word.put == kPutGround;
  const bool dropped = counted && capacity_ != 0 && put_items_ == capacity_;
  const bool full = !free && !dropped;
  const std::uint32_t value = bus(word);
  const bool pass = condition(word, value, full) != word.pol;
  if (free && valid_) items.valid.write(valid_ = false);
  if (word.take && start.valid.read()) {
    take();
    figures_.activity.start = now;
  }
  if (word.put != kNoPut && !full) {
    if (dropped)
      ++figures_.dropped;
    else
      put(word, value);
    if (word.put == kPutGround) {
      ++ground_item_;
      --ground_;
    }
  }
  stalled_ = full && word.cond == kFull;
  figures_.activity.stalled += stalled_;
  if (word.fault)
    figures_.faults.push_back((group_ - banks_[parity_].first_record()) / kRecordWords);
  if (word.acc != kAccHold) accumulate(word, value);
  if (word.count == kCountPair)
    count_pair(value);
  else if (word.count == kCountClear)
    counts_.fill(0);
  const std::uint32_t member = members_ + first_of_rest();
  if (word.list != kListHold || word.rest != kRestHold) list_member(word, value);
  if (word.place != kPlaceHold || word.level != kLevelHold) step_level(word);
  if (word.rank == kRankClear) rank_ = 0;
  if (word.rank == kRankInc) rank_ = (rank_ + 1) % kGroupCapacity;
  if (word.planes) --planes_;
  address_memories(word, word.mar == kAddressSpecial ? member : value);
  load(word, value);
  sequencer_.step(
      word.op, pass,
      word.d_data ? static_cast<std::uint16_t>(value & firmware::kAddressMask) : word.address);
}

std::uint32_t Clocked::bus(const Instruction& word) const {
  switch (word.src) {
    case kMem:
      return banks_[parity_].memory().words[mar_];
    case kBank:
      return banks_[parity_].at(bar_);
    case kOrder:
      return order_[order_address(places_[level_].place)];
    case kT:
      return t_;
    default:
      return 0;
  }
}

bool Clocked::condition(const Instruction& word, std::uint32_t value, bool full) const {
  switch (word.cond) {
    case kStart:
      return start.valid.read();
    case kZero:
      return value == 0;
    case kBit31:
      return (value & 0x8000'0000) != 0;
    case kMany:
      return (mask_ & (mask_ - 1)) != 0;
    case kPlanes:
      return planes_ != 0;
    case kMembers:
      return rest_ != 0;
    case kFault:
      return twice_ || (listed_ != 0 && largest_ >= listed_);
    case kLastRank:
      return rank_ == kGroupCapacity - 1;
    case kOpened:
      return places_[level_].place == places_[level_].number;
    case kInside:
      return level_ != kOutside;
    case kFull:
      return full;
    case kGrounds:
      return ground_ != 0;
    default:
      return true;
  }
}

std::uint32_t Clocked::first_of_rest() const {
  return rest_ == 0 ? 0 : static_cast<std::uint32_t>(std::countr_zero(rest_));
}

void Clocked::take() {
  const FrameWord word = start.word.read();
  figures_ = {};
  figures_.frame = word.frame;
  parity_ = word.frame & 1;
  const std::size_t depth = banks_[parity_].memory().depth;
  if (depth > places_.size()) {
    places_.resize(depth);
    order_.resize(depth * kGroupCapacity);
  }
  bar_ = 0;
  put_items_ = 0;
  ground_item_ = 0;
  level_ = kOutside;
}

void Clocked::accumulate(const Instruction& word, std::uint32_t value) {
  const auto product = [&](Word eye) {
    return static_cast<std::uint64_t>(static_cast<Accumulator>(static_cast<Word>(value)) * eye);
  };
  switch (word.acc) {
    case kAccX:
      accumulator_ = product(eye_[0]);
      break;
    case kAccY:
      accumulator_ += product(eye_[1]);
      break;
    case kAccZ:
      accumulator_ += product(eye_[2]);
      break;
    case kAccLow:
      accumulator_ -= value;
      break;
    case kAccHigh:
      accumulator_ -= static_cast<std::uint64_t>(value) << 32;
      ++figures_.planes;
      break;
  }
}

void Clocked::count_pair(std::uint32_t pair) {
  const std::uint32_t true_member = pair & 63, false_member = pair >> 8 & 63;
  const bool eye_true = static_cast<Accumulator>(accumulator_) >= 0;
  std::uint8_t& count = counts_[eye_true ? false_member : true_member];
  const bool both = (mask_ >> true_member & 1) && (mask_ >> false_member & 1);
  if (both && count < kMostCount) ++count;
  ++figures_.pairs;
}

void Clocked::list_member(const Instruction& word, std::uint32_t value) {
  const bool group = (value & kGroupBit) != 0;
  const std::uint32_t entry = group ? kGroupBit | next_child_ : value;
  const std::uint32_t count = counts_[first_of_rest()];
  switch (word.list) {
    case kListClear:
      listed_ = largest_ = 0;
      seen_ = 0;
      twice_ = false;
      break;
    case kListCount:
      order_[order_address(count)] = entry;
      twice_ = twice_ || (seen_ >> count & 1);
      seen_ |= std::uint64_t{1} << count;
      largest_ = std::max(largest_, count);
      ++listed_;
      break;
    case kListRank:
      if (count == rank_) order_[order_address(listed_++)] = entry;
      break;
  }
  if (word.rest == kRestLoad) {
    rest_ = mask_;
    next_child_ = child_;
  } else if (word.rest == kRestNext) {
    rest_ &= rest_ - 1;
    if (group) next_child_ += kRecordWords;
  }
}

void Clocked::step_level(const Instruction& word) {
  if (word.place == kPlaceBegin) {
    places_[level_] = {0, static_cast<std::uint8_t>(listed_)};
    ++figures_.groups;
  } else if (word.place == kPlaceNext) {
    ++places_[level_].place;
  }
  if (word.level == kLevelInc) {
    ++level_;
    group_ = bar_;
  } else if (word.level == kLevelDec) {
    --level_;
  }
}

void Clocked::address_memories(const Instruction& word, std::uint32_t value) {
  if (word.mar == kAddressInc) ++mar_;
  if (word.mar == kAddressLoad || word.mar == kAddressSpecial) mar_ = value;
  if (word.bar == kAddressInc) ++bar_;
  if (word.bar == kAddressLoad) bar_ = value & ~kGroupBit;
  if (word.bar == kAddressSpecial)
    bar_ = value & kGroupBit ? value & ~kGroupBit : directory_ + (value & kItemMask);
}

void Clocked::load(const Instruction& word, std::uint32_t value) {
  switch (word.load) {
    case kLoadEyeX:
    case kLoadEyeY:
    case kLoadEyeZ:
      eye_[word.load - kLoadEyeX] = static_cast<Word>(value);
      break;
    case kLoadDirectory:
      directory_ = value;
      break;
    case kLoadGround:
      ground_ = value;
      break;
    case kLoadMaskLow:
      mask_ = (mask_ & 0xffff'ffff'0000'0000) | value;
      break;
    case kLoadMaskHigh:
      mask_ = (mask_ & 0xffff'ffff) | static_cast<std::uint64_t>(value) << 32;
      break;
    case kLoadChild:
      child_ = value;
      break;
    case kLoadMembers:
      members_ = value;
      break;
    case kLoadPlanes:
      planes_ = value;
      break;
    case kLoadT:
      t_ = value;
      break;
  }
}

void Clocked::put(const Instruction& word, std::uint32_t value) {
  ItemWord item;
  if (word.put == kPutItem)
    item = {value & kMovingBit ? SetId::kMoving : SetId::kStatic, value & kItemMask, false};
  else if (word.put == kPutGround)
    item = {SetId::kGround, ground_item_, false};
  else
    item.end = true;
  if (!item.end) ++put_items_;
  items.word.write(item);
  items.valid.write(valid_ = true);
}

// The end word was taken in cycle `now`.
void Clocked::finish(Cycle now) {
  figures_.activity.finish = now;
  figures_.items = put_items_;
  if (report_) report_(figures_);
}

// An instruction that only waits for a pin costs nothing until the pin rises.
void Clocked::sleep(const Instruction& next) {
  if (stalled_)
    next_trigger(items.ready.posedge_event());
  else if (next.take && !start.valid.read())
    next_trigger(start.valid.posedge_event());
}

void Clocked::trace(sc_core::sc_trace_file* file) const {
  const Tracer show(file, *this);
  show.pins(start, "start");
  show.pins(items, "items");
  show.state(address_, "microaddress");
  show.state(mar_, "mar");
  show.state(bar_, "bar");
  show.state(t_, "t");
  show.state(accumulator_, "accumulator");
  show.state(mask_, "mask");
  show.state(rest_, "rest");
  show.state(planes_, "planes");
  show.state(listed_, "listed");
  show.state(largest_, "largest");
  show.state(twice_, "twice");
  show.state(rank_, "rank");
  show.state(level_, "level");
  show.state(group_, "group");
  show.state(put_items_, "items_put");
}

}  // namespace cigsim::priority_processor
