// SPDX-License-Identifier: MIT
#include "sim/cosim/so_vectors.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <stdexcept>

#include "rtl/priority_processor/so_engine.pins.hpp"
#include "sim/host_time.hpp"

namespace cigsim::cosim {
namespace {

using priority_processor::kSoMost;
using priority_processor::SoAnswers;
using priority_processor::SoBits;
using priority_processor::SoGolden;
using Pins = rtl::so_engine::Pins;

constexpr unsigned kEyesOfOneMatrix = 16;

struct Eye {
  SoBits sides{}, active{};
};

/// The outputs of a cycle. `answers` holds nothing where no row is due.
struct Expected {
  bool start_ready = true, valid = false, last = false, unique = false, resolved = false;
  unsigned row = 0;
  const SoAnswers* answers = nullptr;
};

/// The two words of 32 bits that are word `w` of 64. Shifts, so that it is right on any machine.
std::uint64_t joined(const std::uint32_t* words, std::size_t w) {
  return std::uint64_t{words[2 * w + 1]} << 32 | words[2 * w];
}

void split(const SoBits& bits, std::uint32_t* words) {
  for (std::size_t w = 0; w < bits.size(); ++w) {
    words[2 * w] = static_cast<std::uint32_t>(bits[w]);
    words[2 * w + 1] = static_cast<std::uint32_t>(bits[w] >> 32);
  }
}

std::string hexadecimal(const SoBits& bits, unsigned count) {
  std::string digits;
  for (unsigned nibble = (count + 3) / 4; nibble-- > 0;)
    digits += fmt::format("{:x}", bits[nibble / 16] >> nibble % 16 * 4 & 15);
  return digits;
}

/// All outputs by name. `pins` is a Pins, or a const one.
template <class AnyPins, class Visit>
void visit_outputs(AnyPins& pins, Visit visit) {
  visit("start_ready_o", pins.start_ready_o);
  visit("answer_valid_o", pins.answer_valid_o);
  visit("answer_row_o", pins.answer_row_o);
  visit("answer_hides_o", pins.answer_hides_o);
  visit("answer_hidden_o", pins.answer_hidden_o);
  visit("answer_unresolved_o", pins.answer_unresolved_o);
  visit("answer_count_o", pins.answer_count_o);
  visit("answer_last_o", pins.answer_last_o);
  visit("answer_unique_o", pins.answer_unique_o);
  visit("answer_resolved_o", pins.answer_resolved_o);
}

/// Holds a bit of an output.
class Stuck {
 public:
  Stuck(Pins& pins, const SoStuckBit& fault, unsigned objects) : value_(fault.value) {
    const unsigned index_width = static_cast<unsigned>(std::bit_width(objects - 1));
    visit_outputs(pins, [&](const char* name, auto& field) {
      using Field = std::remove_reference_t<decltype(field)>;
      if (fault.output != name) return;
      unsigned width = index_width;
      if constexpr (std::is_array_v<Field>) {
        width = objects;
        word_ = &field[fault.bit / 32 % Pins::kWords];
      } else if constexpr (std::is_same_v<Field, bool>) {
        width = 1;
        flag_ = &field;
      } else {
        word_ = &field;
      }
      if (fault.bit >= width)
        throw std::invalid_argument(
            fmt::format("{} of so_engine has bits 0 to {}", name, width - 1));
    });
    if (word_ == nullptr && flag_ == nullptr)
      throw std::invalid_argument("so_engine has no output named " + fault.output);
    mask_ = std::uint32_t{1} << fault.bit % 32;
  }
  void apply() const {
    if (flag_ != nullptr) *flag_ = value_;
    if (word_ != nullptr) *word_ = value_ ? *word_ | mask_ : *word_ & ~mask_;
  }

 private:
  std::uint32_t* word_ = nullptr;
  bool* flag_ = nullptr;
  std::uint32_t mask_ = 0;
  bool value_;
};

/// RTL and golden model side by side. Functions that step tell whether all is well.
class LockStep {
 public:
  explicit LockStep(const SoVectorOptions& options)
      : options_(options),
        model_(options.library, sizeof(Pins), options.seed),
        pins_(model_.pins<Pins>()),
        golden_(options.objects, options.planes),
        words_((options.objects + 63) / 64) {
    if (options.stuck) stuck_.emplace(pins_, *options.stuck, options.objects);
    if (options.begin) options.begin(model_);
    pins_.rst_i = true;
    pins_.cfg_last_row_i = options.objects - 1;
    model_.edge();
    model_.edge();
    pins_.rst_i = false;
    inputs_.objects = options.objects;
    inputs_.planes = options.planes;
  }

  SoVectorResult& result() { return result_; }

  /// Writes SEPL. The engine answers nothing, or the last row, and no eye is offered.
  bool write(const std::vector<priority_processor::SoRow>& rows) {
    if (busy_ && !idle(1)) return false;
    inputs_.rows = rows;
    pins_.row_valid_i = true;
    for (unsigned o = 0; o < options_.objects; ++o) {
      golden_.set_row(o, rows[o]);
      pins_.row_index_i = o;
      split(rows[o].tells, pins_.row_tells_i);
      split(rows[o].plus, pins_.row_plus_i);
      if (!step({})) return false;
    }
    pins_.row_valid_i = false;
    return true;
  }

  bool idle(unsigned cycles) {
    for (; cycles > 0; --cycles)
      if (!step({})) return false;
    busy_ = false;
    return true;
  }

  /// Answers all rows for an eye; the engine answers nothing, or the last row of the eye before.
  /// `offer`, if any: the eye to come next is on the pins from the first row on, and has to wait.
  bool answer(const Eye& eye, const Eye* offer) {
    const SoBits& active = eye.active;
    inputs_.eye = eye.sides;
    inputs_.active = active;
    if (options_.compare) golden_.mark(eye.sides, active);
    start(eye);

    SoBits counts{}, unresolved{};
    for (unsigned row = 0; row < options_.objects; ++row) {
      Expected expected{.start_ready = false, .valid = true, .row = row};
      expected.last = expected.start_ready = row + 1 == options_.objects;
      if (options_.compare) {
        expected.answers = &golden_.row(row);
        if (active[row / 64] >> row % 64 & 1)
          counts[expected.answers->count / 64] |= std::uint64_t{1} << expected.answers->count % 64;
        for (unsigned w = 0; w < words_; ++w) unresolved[w] |= expected.answers->unresolved[w];
        if (expected.last) {
          expected.unique = is_permutation(counts, active);
          expected.resolved = unresolved == SoBits{};
        }
      }
      if (!step(expected)) return false;
      if (row == 0) pins_.start_valid_i = false;
      if (row == 0 && offer != nullptr) start(*offer);
      ++result_.vectors;
    }
    busy_ = true;
    std::uint64_t asked = 0;
    for (const std::uint64_t word : active) asked += static_cast<unsigned>(std::popcount(word));
    result_.pairs += asked == 0 ? 0 : asked * (asked - 1);
    return true;
  }

 private:
  void start(const Eye& eye) {
    pins_.start_valid_i = true;
    split(eye.sides, pins_.start_eye_i);
    split(eye.active, pins_.start_active_i);
  }

  /// n counts that are 0 .. n-1, each once.
  static bool is_permutation(const SoBits& counts, const SoBits& active) {
    unsigned n = 0, found = 0;
    bool gap = false, well = true;
    for (const std::uint64_t word : active) n += static_cast<unsigned>(std::popcount(word));
    for (const std::uint64_t word : counts) {
      const auto run = static_cast<unsigned>(std::countr_one(word));
      well = well && !(gap && word != 0) && (run == 64 || word >> run == 0);
      gap = gap || run < 64;
      found += run;
    }
    return well && found == n;
  }

  bool step(const Expected& expected) {
    try {
      model_.edge();
    } catch (const std::runtime_error& error) {
      result_.mismatch = SoMismatch{.vector = result_.vectors,
                                    .cycle = result_.cycles,
                                    .row = expected.row,
                                    .field = "contract",
                                    .expected = "kept",
                                    .got = error.what(),
                                    .inputs = inputs_};
      return false;
    }
    if (stuck_) stuck_->apply();
    const std::uint64_t cycle = result_.cycles++;
    if (options_.each_cycle) options_.each_cycle(model_, cycle);
    if (!options_.compare || same(expected)) return true;
    report(expected, cycle);
    return false;
  }

  bool same(const Expected& expected) const {
    static constexpr SoAnswers kNothing;
    const SoAnswers& answers = expected.answers != nullptr ? *expected.answers : kNothing;
    std::uint64_t differ =
        (pins_.start_ready_o ^ expected.start_ready) | (pins_.answer_valid_o ^ expected.valid) |
        (pins_.answer_last_o ^ expected.last) | (pins_.answer_unique_o ^ expected.unique) |
        (pins_.answer_resolved_o ^ expected.resolved);
    differ |= (pins_.answer_row_o ^ expected.row) | (pins_.answer_count_o ^ answers.count);
    for (unsigned w = 0; w < words_; ++w)
      differ |= (joined(pins_.answer_hides_o, w) ^ answers.hides[w]) |
                (joined(pins_.answer_hidden_o, w) ^ answers.hidden[w]) |
                (joined(pins_.answer_unresolved_o, w) ^ answers.unresolved[w]);
    return differ == 0;
  }

  void report(const Expected& expected, std::uint64_t cycle) {
    const SoAnswers answers = expected.answers != nullptr ? *expected.answers : SoAnswers{};
    SoMismatch mismatch{.vector = result_.vectors,
                        .cycle = cycle,
                        .row = expected.row,
                        .field = {},
                        .expected = {},
                        .got = {},
                        .inputs = inputs_};
    Pins should = pins_;
    should.start_ready_o = expected.start_ready;
    should.answer_valid_o = expected.valid;
    should.answer_row_o = expected.row;
    split(answers.hides, should.answer_hides_o);
    split(answers.hidden, should.answer_hidden_o);
    split(answers.unresolved, should.answer_unresolved_o);
    should.answer_count_o = answers.count;
    should.answer_last_o = expected.last;
    should.answer_unique_o = expected.unique;
    should.answer_resolved_o = expected.resolved;
    std::vector<std::string> should_be;
    visit_outputs(should,
                  [&](const char*, const auto& field) { should_be.push_back(text(field)); });
    std::size_t n = 0;
    visit_outputs(pins_, [&](const char* name, const auto& field) {
      const std::string got = text(field);
      const std::string& right = should_be[n++];
      if (!mismatch.field.empty() || got == right) return;
      mismatch.field = name;
      mismatch.expected = right;
      mismatch.got = got;
    });
    result_.mismatch = std::move(mismatch);
  }

  template <class Field>
  std::string text(const Field& field) const {
    if constexpr (std::is_array_v<Field>) {
      SoBits bits;
      for (std::size_t w = 0; w < bits.size(); ++w) bits[w] = joined(field, w);
      return hexadecimal(bits, options_.objects);
    } else {
      return fmt::format("{}", static_cast<std::uint32_t>(field));
    }
  }

  const SoVectorOptions& options_;
  RtlModel model_;
  Pins& pins_;
  SoGolden golden_;
  unsigned words_;
  std::optional<Stuck> stuck_;
  SoCase inputs_;
  bool busy_ = false;
  SoVectorResult result_;
};

void check(const SoVectorOptions& options) {
  if (options.objects < 2 || options.objects > kSoMost || options.planes < 1 ||
      options.planes > kSoMost)
    throw std::invalid_argument("so_engine has 2 to 256 objects and 1 to 256 planes");
}

}  // namespace

void check_stuck(const SoStuckBit& fault, unsigned objects) {
  Pins pins{};
  const Stuck stuck(pins, fault, objects);
}

SoVectorResult run_so_vectors(const SoVectorOptions& options) {
  check(options);
  LockStep lock_step(options);
  Random random(options.seed);
  HostTime time;
  SoVectorResult& result = lock_step.result();
  Eye eye;
  const auto look = [&](const Eye& before) {
    return Eye{random_so_eye(random, options.planes, before.sides),
               random_so_active(random, options.objects)};
  };
  bool well = true;
  for (unsigned matrix = 0; well && result.vectors < options.vectors; ++matrix) {
    const auto kind = static_cast<SoKind>(matrix % static_cast<unsigned>(SoKind::kCount));
    well = lock_step.write(random_so_rows(random, kind, options.objects, options.planes));
    eye = look(eye);
    for (unsigned n = 1; well && n <= kEyesOfOneMatrix && result.vectors < options.vectors; ++n) {
      const Eye next = look(eye);
      const bool offered = n < kEyesOfOneMatrix && random.below(2) == 0;
      well = lock_step.answer(eye, offered ? &next : nullptr);
      if (well && !offered && random.below(4) == 0) well = lock_step.idle(1 + random.below(3));
      eye = next;
    }
    if (options.progress && matrix % 64 == 63 && !options.progress(result.vectors)) break;
  }
  time.lap();
  result.seconds = time.total() / 1000;
  return result;
}

SoVectorResult replay_so_case(const SoVectorOptions& options, const SoCase& inputs) {
  check(options);
  if (inputs.objects != options.objects || inputs.planes != options.planes ||
      inputs.rows.size() != inputs.objects)
    throw std::invalid_argument("the case is of another size than the engine");
  LockStep lock_step(options);
  HostTime time;
  if (lock_step.write(inputs.rows) && lock_step.answer({inputs.eye, inputs.active}, nullptr))
    lock_step.idle(2);
  time.lap();
  lock_step.result().seconds = time.total() / 1000;
  return lock_step.result();
}

}  // namespace cigsim::cosim
