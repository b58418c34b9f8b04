// SPDX-License-Identifier: MIT
#include "models/geometry_processor/clocked.hpp"

#include <algorithm>
#include <stdexcept>

#include "models/boundary/tracer.hpp"
#include "models/geometry_processor/program.hpp"

namespace cigsim::geometry_processor {
namespace {

// Codes of the fields, as firmware/geometry_processor/format.fmt declares them.
enum Condition : std::uint8_t {
  kTrue,
  kStart,
  kItem,
  kEnd,
  kLate,
  kNeg,
  kZero,
  kOneF,
  kOver,
  kOut,
  kAll,
  kAny,
  kLast,
  kLastVertex,
  kLastFace,
  kShown,
  kPlane,
  kLastPlane,
  kMade,
  kFullEdge,
  kFullFace,
  kHeld
};
enum Take : std::uint8_t { kNoTake, kTakeStart, kTakeItem };
// Operands: 1..4 a, 5..8 b, 9..12 S, 13..16 T, 17..23 general registers, then
enum Operand : std::uint8_t {
  kLastPoint = 16,
  kEyeX = 24,
  kHither = 27,
  kHalf = 28,
  kCeil = 29,
  kOneConstant = 30,
  kThree = 31,
  kWidth = 32,
  kHeight = 33,
  kLastRegister = 33,
  kBoundA = 34,
  kBoundB = 35,
  kQuot = 36,
  kAcc = 37,
  kRoom = 38,
  kCount = 39,
  kWritten = 40,
  kFaces = 41,
  kVertexWord = 42,
  kItemWord = 43,
  kFaceWord = 44,
  kDx = 45,
  kPtU = 48
};
enum Adder : std::uint8_t { kAdd, kSub, kAddPlane };
enum Shift : std::uint8_t { kNoShift, kShiftLine, kShiftRow };
enum Multiplicand : std::uint8_t { kX22 = 8, kXA, kXOne, kXElement, kXQuot, kXRest };
enum Mac : std::uint8_t { kMacHold, kMacLoad, kMacAdd, kMacSub };
enum AccRead : std::uint8_t { kAccPoint, kAccPlace, kAccLong, kAccShort };
enum Div : std::uint8_t { kNoDiv, kDivPoint, kDivCut, kDivDrop, kDivSlope };
enum LoopWrite : std::uint8_t { kNoLoop, kLoopU, kLoopV, kLoopW, kLoopColumn, kLoopLine };
enum Points : std::uint8_t { kPtHold, kPtLoad, kPtFirst, kPtNext, kPtSwap };
enum Code : std::uint8_t { kCodeHold, kCodeShift, kCodeStore, kCodeNote, kCodeStart };
// Of address registers and counters.
enum Address : std::uint8_t { kHold, kInc, kLoad, kNext };
enum Counter : std::uint8_t { kCounterHold, kCounterLoad, kCounterDec, kCounterReload };
enum Clearable : std::uint8_t { kClearHold, kClear, kClearInc };
enum Select : std::uint8_t { kSelHold, kSelDown, kSelA, kSelB };
enum Side : std::uint8_t { kSideHold, kSideBoth, kSideFront };
enum WordField : std::uint8_t { kNoField, kFieldFirst, kFieldEnd, kFieldSlope, kFieldObject };
enum Put : std::uint8_t { kNoPut, kPutEdge, kPutFace, kPutEndEdges, kPutEndFaces };
enum TallyOf : std::uint8_t { kNoTally, kTallyFace, kTallyClipped, kTallyDrop };

constexpr std::uint32_t kRest = 17 + 6;
constexpr std::int64_t kOne = std::int64_t{1} << kQuotientFraction;
constexpr std::int64_t kHalfElement = std::int64_t{1} << (kRasterFraction - 1);
constexpr std::int64_t kNoLimit = std::int64_t{1} << 31;
constexpr std::uint8_t kAllPlanes = 0x1f;
constexpr int kMostElements = 8191;

}  // namespace

Clocked::Clocked(sc_core::sc_module_name name, const MachineDescription& machine,
                 OverloadPolicy overload, const Clock& time,
                 const std::array<GeometryBank, 2>& banks, FiguresFunction figures)
    : sc_module(name),
      time_(time),
      banks_(banks),
      report_(std::move(figures)),
      formats_(machine.formats),
      edge_capacity_(machine.edge_capacity),
      face_capacity_(machine.face_capacity),
      deadline_(deadline(machine, overload)),
      divider_(machine.formats) {
  if (machine.raster.width > kMostElements || machine.raster.height > kMostElements)
    throw std::invalid_argument(
        "the geometry processor's raster words (13.18) hold 8191 lines of 8191 elements at most; "
        "take a smaller raster");
  SC_HAS_PROCESS(Clocked);
  SC_METHOD(edge);
  dont_initialize();
  sensitive << clock.pos();
  decode(program(machine.formats));
  registers_[kHither] = machine.hither;
  registers_[kHalf] = kHalfElement;
  registers_[kCeil] = kHalfElement - 1;
  registers_[kOneConstant] = kOne;
  registers_[kThree] = 3;
  vertex_memory_.resize(1);
  for (auto& part : loop_memory_) part.resize(1);
  start_ready_ = program_[0].take == kTakeStart;
  start.ready.initialize(start_ready_);
}

void Clocked::decode(const firmware::Program& program) {
  const auto& format = program.format;
  const auto read = [&](const char* name, auto member) {
    const firmware::FieldPlace place = format.place(name);
    for (std::size_t i = 0; i < program_.size(); ++i)
      program_[i].*member = static_cast<std::uint8_t>(place.get(program.words[i]));
  };
  const auto flag = [&](const char* name, bool Instruction::*member) {
    const firmware::FieldPlace place = format.place(name);
    for (std::size_t i = 0; i < program_.size(); ++i)
      program_[i].*member = place.get(program.words[i]) != 0;
  };
  program_.assign(program.words.size(), Instruction{});
  const auto op = format.place("op"), address = format.place("address");
  for (std::size_t i = 0; i < program_.size(); ++i) {
    program_[i].op = static_cast<firmware::SequencerOp>(op.get(program.words[i]));
    program_[i].address = static_cast<std::uint16_t>(address.get(program.words[i]));
  }
  flag("pol", &Instruction::pol);
  flag("ip", &Instruction::ip);
  flag("flip", &Instruction::flip);
  using Member = std::uint8_t Instruction::*;
  const std::pair<const char*, Member> fields[] = {
      {"cond", &Instruction::cond},   {"take", &Instruction::take},  {"a", &Instruction::a},
      {"b", &Instruction::b},         {"alu", &Instruction::alu},    {"shift", &Instruction::shift},
      {"to", &Instruction::to},       {"x", &Instruction::x},        {"y", &Instruction::y},
      {"mac", &Instruction::mac},     {"acc", &Instruction::acc},    {"div", &Instruction::div},
      {"vm", &Instruction::vm},       {"lm", &Instruction::lm},      {"lw", &Instruction::lw},
      {"pt", &Instruction::pt},       {"va", &Instruction::va},      {"code", &Instruction::code},
      {"fp", &Instruction::fp},       {"vp", &Instruction::vp},      {"v", &Instruction::v},
      {"f", &Instruction::f},         {"k", &Instruction::k},        {"sel", &Instruction::sel},
      {"plane", &Instruction::plane}, {"side", &Instruction::side},  {"word", &Instruction::word},
      {"put", &Instruction::put},     {"tally", &Instruction::tally}};
  for (const auto& [name, member] : fields) read(name, member);
  last_ = program.address("finished");
}

void Clocked::edge() {
  if (!clock.posedge()) return;  // woken from sleep between two edges: the next one counts
  const Cycle now = time_.cycle();
  const Cycle slept = now - last_edge_ - 1;
  if (waits_ == Wait::kItem) figures_.activity.idle += slept;
  if (waits_ == Wait::kOut) figures_.activity.stalled += slept;
  last_edge_ = now;
  execute(program_[sequencer_.address()], now);
  address_ = sequencer_.address();
  const Instruction& next = program_[address_];
  const bool start_next = next.take == kTakeStart, item_next = next.take == kTakeItem;
  if (start_next != start_ready_) start.ready.write(start_ready_ = start_next);
  if (item_next != items_ready_) items.ready.write(items_ready_ = item_next);
  if (address_ == last_) finish(now);
  sleep(next);
}

// All fields act on the registers' values from before, so what is read goes before what is written.
void Clocked::execute(const Instruction& word, Cycle now) {
  edge_free_ = !edge_valid_ || edges.ready.read();  // GP17
  face_free_ = !face_valid_ || faces.ready.read();
  is_late_ = late(now);
  const bool edge_put = word.put == kPutEdge || word.put == kPutEndEdges;
  const bool full = word.put != kNoPut && !(edge_put ? edge_free_ : face_free_);
  const std::int64_t a = operand(word.a, word), b = operand(word.b, word);
  const std::int64_t value = add(word, a, b);
  const bool pass = condition(word, value, full) != word.pol;
  const bool held = word.cond == kHeld && pass;
  waits_ = full || held ? Wait::kOut : Wait::kNone;
  if (word.take == kTakeItem && !items.valid.read()) waits_ = Wait::kItem;
  figures_.activity.stalled += waits_ == Wait::kOut;
  figures_.activity.idle += waits_ == Wait::kItem;
  if (edge_valid_ && edge_free_) edges.valid.write(edge_valid_ = false);
  if (face_valid_ && face_free_) faces.valid.write(face_valid_ = false);

  multiply(word, a);
  divider_.step();
  if (word.div != kNoDiv) divide(word, a, b, value);
  if (word.code != kCodeHold) step_code(word, value < 0);
  if (word.vm != 0 || word.lm != kNoLoop) write_memories(word, static_cast<Word>(value));
  const std::size_t to = place(word.to);
  const std::uint32_t current = current_;
  step_flags(word, value);
  if (to != 0) registers_[to] = value;
  if (word.flip) current_ = current ^ 1;
  if (word.pt != kPtHold) step_points(word, value);
  step_addresses(word, value);
  step_counters(word, value);
  if (word.put != kNoPut && !full) put(word, value);
  if (word.take != kNoTake) take(word, now);
  sequencer_.step(word.op, pass, word.address);
}

// Where the register of an operand's code is.
std::size_t Clocked::place(std::uint8_t code) const {
  if (code == 0 || code > kLastPoint) return code;
  const std::uint32_t which = (code - 1u) >> 2;
  const std::uint32_t set = (which < 2 ? current_ : selected_) ^ (which & 1);
  return 1 + 4 * set + ((code - 1u) & 3);
}

std::int64_t Clocked::operand(std::uint8_t code, const Instruction& word) {
  return code <= kLastRegister ? registers_[place(code)] : unit(code, word);
}

std::int64_t Clocked::unit(std::uint8_t code, const Instruction& word) {
  switch (code) {
    case kBoundA:
    case kBoundB: {
      if (plane_ == 0) return registers_[kHither];
      const std::uint32_t set = current_ ^ (code == kBoundB ? 1 : 0);
      return registers_[1 + 4 * set + (plane_ < 3 ? 1 : 2)];
    }
    case kQuot:
      return divider_.result();
    case kAcc:
      return read_accumulator(word.acc);
    case kRoom:
      return edge_capacity_ == 0 ? kNoLimit : std::int64_t{edge_capacity_} - edges_put_;
    case kCount:
      return count_;
    case kWritten:
      return lw_;
    case kFaces:
      return faces_left_;
    case kVertexWord:
      return memory_->vertices[vp_];
    case kItemWord:
      return memory_->items[ip_];
    case kFaceWord:
      return memory_->faces[fp_];
    default:
      break;
  }
  if (code < kPtU) return vertex_memory_[va_].field[code - kDx];
  const std::uint32_t field = code - kPtU;
  return points_in_loop_ ? loop_memory_[read_part_][lr_].field[field]
                         : vertex_memory_[va_].field[3 + field];
}

std::int64_t Clocked::read_accumulator(std::uint8_t how) {
  if (how == kAccPoint)
    return saturate(round_shift(accumulator_, kDirectionFraction), formats_.coordinate_bits + 1,
                    figures_.overflows);
  constexpr int kFraction[] = {0, 31, 36, 48};
  const int kept = formats_.raster_fraction;
  return round_shift(accumulator_, kFraction[how] - kept) << (kRasterFraction - kept);
}

std::int64_t Clocked::add(const Instruction& word, std::int64_t a, std::int64_t b) const {
  if (word.shift == kShiftRow) a <<= kRasterFraction;
  bool subtract = word.alu == kSub;
  if (word.alu == kAddPlane) subtract = plane_ != 1 && plane_ != 4;
  const std::int64_t sum = subtract ? a - b : a + b;
  return word.shift == kShiftLine ? sum >> kRasterFraction : sum;
}

bool Clocked::condition(const Instruction& word, std::int64_t value, bool full) const {
  switch (word.cond) {
    case kStart:
      return start.valid.read();
    case kItem:
      return items.valid.read();
    case kEnd:
      return item_end_;
    case kLate:
      return is_late_;
    case kNeg:
      return value < 0;
    case kZero:
      return value == 0;
    case kOneF:
      return value == 1;
    case kOver:
      return value < 0 || (face_capacity_ != 0 && faces_put_ >= face_capacity_);
    case kOut:
      return code_ != 0;
    case kAll:
      return all_ != 0;
    case kAny:
      return any_ != 0;
    case kLast:
      return k_ == 1;
    case kLastVertex:
      return vertices_left_ == 1;
    case kLastFace:
      return faces_left_ == 1;
    case kShown:
      return accumulator_ < 0 || (accumulator_ > 0 && two_sided_);
    case kPlane:
      return (any_ >> plane_ & 1) != 0;
    case kLastPlane:
      return plane_ == 4;
    case kMade:
      return made_;
    case kFullEdge:
    case kFullFace:
      return full;
    case kHeld:
      return !edge_free_ || !face_free_;
    default:
      return true;
  }
}

void Clocked::take(const Instruction& word, Cycle now) {
  if (word.take == kTakeStart) {
    if (!start.valid.read()) return;
    figures_ = {};
    figures_.frame = start.word.read().frame;
    figures_.activity.start = now;
    bank_ = &banks_[figures_.frame & 1];
    for (std::size_t i = 0; i < 3; ++i) registers_[kEyeX + i] = bank_->view.eye[i];
    registers_[kWidth] = bank_->view.raster.width;
    registers_[kHeight] = bank_->view.raster.height;
    edges_put_ = faces_put_ = 0;
  } else if (items.valid.read()) {
    const ItemWord item = items.word.read();
    item_end_ = item.end;
    if (item.end) return;
    memory_ = bank_->sets[static_cast<std::size_t>(item.set)];
    ip_ = item.item * kItemWords;
  }
}

// The product of the operands that the clock before has latched goes into the accumulator.
void Clocked::multiply(const Instruction& word, std::int64_t a) {
  if (mac_ != kMacHold) {
    const auto product = static_cast<std::uint64_t>(x_ * y_);
    const auto sum = static_cast<std::uint64_t>(accumulator_);
    accumulator_ = static_cast<std::int64_t>(mac_ == kMacLoad  ? product
                                             : mac_ == kMacAdd ? sum + product
                                                               : sum - product);
  }
  mac_ = word.mac;
  if (mac_ == kMacHold) return;
  if (word.x <= kX22)
    x_ = bank_->view.matrix[word.x / 3][word.x % 3];
  else if (word.x == kXA)
    x_ = a;
  else if (word.x == kXOne)
    x_ = kOne;
  else if (word.x == kXElement)
    x_ = std::int64_t{1} << kRasterFraction;
  else
    x_ = word.x == kXQuot ? divider_.result() : registers_[kRest];
  y_ = operand(word.y, word);
}

void Clocked::divide(const Instruction& word, std::int64_t a, std::int64_t b, std::int64_t value) {
  switch (word.div) {
    case kDivPoint:
      divider_.begin_quotient(b, a);
      break;
    case kDivCut:
      divider_.begin_quotient(a, value);
      break;
    case kDivDrop:
      divider_.begin_quotient(value, operand(word.y, word));
      break;
    default:
      divider_.begin_slope(value, operand(word.y, word));
  }
}

void Clocked::write_memories(const Instruction& word, Word value) {
  if (word.vm != 0) vertex_memory_[va_].field[word.vm - 1] = value;
  if (word.lm == kNoLoop) return;
  const bool written = word.lm <= kLoopW;
  std::vector<LoopPoint>& part = loop_memory_[written ? read_part_ ^ 1 : read_part_];
  const std::uint32_t at = written ? lw_ : lr_;
  if (at >= part.size()) part.resize(at + 1);
  part[at].field[word.lm - 1] = value;
}

void Clocked::step_points(const Instruction& word, std::int64_t value) {
  switch (word.pt) {
    case kPtLoad:
      first_corner_ = static_cast<std::uint32_t>(value);
      points_in_loop_ = false;
      made_ = false;
      break;
    case kPtFirst:
      va_ = static_cast<std::uint32_t>(memory_->corners[first_corner_]);
      next_corner_ = 1;
      break;
    case kPtNext:
      if (points_in_loop_) {
        lr_ = lr_ + 1 == count_ ? 0 : lr_ + 1;
      } else {
        if (next_corner_ >= count_) next_corner_ = 0;
        va_ = static_cast<std::uint32_t>(memory_->corners[first_corner_ + next_corner_++]);
      }
      break;
    default:  // swap
      read_part_ ^= 1;
      points_in_loop_ = true;
      lr_ = 0;
      count_ = k_ = lw_;
  }
}

void Clocked::step_code(const Instruction& word, bool negative) {
  if (word.code == kCodeShift) {
    code_ = static_cast<std::uint8_t>(code_ >> 1 | negative << 4);
  } else if (word.code == kCodeStart) {
    all_ = kAllPlanes;
    any_ = 0;
  } else {
    if (word.code == kCodeStore) vertex_memory_[va_].code = code_;
    const std::uint8_t code = vertex_memory_[va_].code;
    all_ &= code;
    any_ |= code;
  }
}

void Clocked::step_addresses(const Instruction& word, std::int64_t value) {
  ip_ += word.ip;
  if (word.fp == kInc) ++fp_;
  if (word.fp == kLoad) fp_ = static_cast<std::uint32_t>(value);
  if (word.fp == kNext) fp_ = (fp_ | (kFaceWords - 1)) + 1;
  if (word.vp == kInc) ++vp_;
  if (word.vp == kLoad) vp_ = static_cast<std::uint32_t>(value);
  if (word.va == kClear) va_ = 0;
  if (word.va == kClearInc && ++va_ >= vertex_memory_.size()) vertex_memory_.resize(va_ + 1);
  if (word.lw == kClear) lw_ = 0;
  if (word.lw == kClearInc) ++lw_;
  if (word.plane == kClear) plane_ = 0;
  if (word.plane == kClearInc) ++plane_;
}

void Clocked::step_counters(const Instruction& word, std::int64_t value) {
  if (word.v == kCounterLoad) vertices_left_ = static_cast<std::uint32_t>(value);
  if (word.v == kCounterDec) --vertices_left_;
  if (word.f == kCounterLoad) faces_left_ = static_cast<std::uint32_t>(value);
  if (word.f == kCounterDec) --faces_left_;
  if (word.k == kCounterLoad) count_ = k_ = static_cast<std::uint32_t>(value);
  if (word.k == kCounterDec) --k_;
  if (word.k == kCounterReload) k_ = count_;
  if (word.tally == kTallyFace) ++figures_.faces;
  if (word.tally == kTallyClipped) ++figures_.clipped_faces;
  if (word.tally == kTallyDrop) figures_.dropped += static_cast<std::uint64_t>(value);
}

void Clocked::step_flags(const Instruction& word, std::int64_t value) {
  if (word.sel == kSelDown) {
    down_ = value < 0;
    selected_ = down_ ? current_ : current_ ^ 1;
  } else if (word.sel != kSelHold) {
    selected_ = word.sel == kSelA ? current_ : current_ ^ 1;
  }
  if (word.side == kSideBoth) two_sided_ = value != 0;
  if (word.side == kSideFront) front_ = accumulator_ < 0;
  switch (word.word) {
    case kFieldFirst:
      edge_word_.first_line = static_cast<std::uint16_t>(value);
      break;
    case kFieldEnd:
      edge_word_.end_line = static_cast<std::uint16_t>(value);
      break;
    case kFieldSlope:
      edge_word_.slope = static_cast<Word>(value);
      break;
    case kFieldObject:
      face_word_.object = static_cast<std::uint32_t>(value);
      break;
  }
}

void Clocked::put(const Instruction& word, std::int64_t value) {
  if (word.put == kPutEdge || word.put == kPutEndEdges) {
    EdgeWord out;
    out.end = true;
    if (word.put == kPutEdge) {
      out = edge_word_;
      out.face = faces_put_;
      out.left = down_ == front_;
      out.x = static_cast<Word>(value);
      ++edges_put_;
      made_ = true;
    }
    edges.word.write(out);
    edges.valid.write(edge_valid_ = true);
  } else {
    FaceWord out;
    out.end = true;
    if (word.put == kPutFace)
      out = {faces_put_++, false, face_word_.object, static_cast<std::uint32_t>(value)};
    faces.word.write(out);
    faces.valid.write(face_valid_ = true);
  }
}

// Both end words were taken by cycle `now`.
void Clocked::finish(Cycle now) {
  figures_.activity.finish = now;
  figures_.edges = edges_put_;
  figures_.front_faces = faces_put_;
  if (report_) report_(figures_);
}

// An instruction that only waits for one pin costs nothing until the pin rises.
void Clocked::sleep(const Instruction& next) {
  if (waits_ == Wait::kOut) {
    if (!face_valid_) next_trigger(edges.ready.posedge_event());
    if (!edge_valid_) next_trigger(faces.ready.posedge_event());
  } else if (!edge_valid_ && !face_valid_) {
    if (next.take == kTakeStart && !start.valid.read()) next_trigger(start.valid.posedge_event());
    if (waits_ == Wait::kItem) next_trigger(items.valid.posedge_event());
  }
}

void Clocked::trace(sc_core::sc_trace_file* file) const {
  const Tracer show(file, *this);
  show.pins(start, "start");
  show.pins(items, "items");
  show.pins(edges, "edges");
  show.pins(faces, "faces");
  show.state(address_, "microaddress");
  show.state(accumulator_, "accumulator");
  show.state(divider_.result_register(), "quotient");
  show.state(divider_.clocks_left(), "divider_clocks");
  show.state(ip_, "ip");
  show.state(fp_, "fp");
  show.state(vp_, "vp");
  show.state(va_, "va");
  show.state(lr_, "lr");
  show.state(lw_, "lw");
  show.state(k_, "k");
  show.state(code_, "code");
  show.state(any_, "any");
  show.state(all_, "all");
  show.state(plane_, "plane");
  show.state(faces_left_, "faces_left");
  show.state(edges_put_, "edges_put");
  show.state(faces_put_, "faces_put");
}

}  // namespace cigsim::geometry_processor
