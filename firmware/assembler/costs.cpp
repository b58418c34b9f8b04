// SPDX-License-Identifier: MIT
#include "firmware/assembler/costs.hpp"

#include <stdexcept>
#include <string>

#include "firmware/sequencer.hpp"

namespace cigsim::firmware {
namespace {

constexpr Cycle kLongestPath = 1'000'000;

bool uses_condition(SequencerOp op) {
  switch (op) {
    case SequencerOp::kJz:
    case SequencerOp::kJmap:
    case SequencerOp::kRfct:
    case SequencerOp::kRpct:
    case SequencerOp::kLdct:
    case SequencerOp::kCont:
      return false;
    default:
      return true;
  }
}

bool uses_counter(SequencerOp op, bool pass) {
  switch (op) {
    case SequencerOp::kRfct:
    case SequencerOp::kRpct:
      return true;
    case SequencerOp::kTwb:
    case SequencerOp::kJsrp:
    case SequencerOp::kJrp:
      return !pass;
    default:
      return false;
  }
}

bool takes_top(SequencerOp op, bool pass) {
  return (op == SequencerOp::kCrtn && pass) || (op == SequencerOp::kLoop && !pass) ||
         op == SequencerOp::kRfct;
}

bool takes_d(SequencerOp op, bool pass, std::uint16_t counter) {
  switch (op) {
    case SequencerOp::kCjs:
    case SequencerOp::kCjp:
    case SequencerOp::kJsrp:
    case SequencerOp::kJrp:
    case SequencerOp::kCjpp:
      return pass;
    case SequencerOp::kRpct:
      return counter != 0;
    case SequencerOp::kTwb:
      return !pass && counter == 0;
    default:
      return false;
  }
}

class Walk {
 public:
  Walk(const Program& program, const Path& path)
      : program_(program),
        path_(path),
        op_(program.format.place("op")),
        pol_(program.format.place("pol")),
        d_(program.format.place("d")),
        address_(program.format.place("address")),
        cond_(program.format.place("cond")) {
    sequencer_.step(SequencerOp::kCjp, true, static_cast<std::uint16_t>(path.from));
  }

  Cycle count() {
    Cycle cycles = 0;
    do {
      if (sequencer_.address() >= program_.words.size()) fail("leaves the program");
      if (++cycles > kLongestPath) fail("does not reach its end");
      step(program_.words[sequencer_.address()]);
    } while (sequencer_.address() != path_.to);
    return cycles;
  }

 private:
  void step(const Microword& word) {
    const auto op = static_cast<SequencerOp>(op_.get(word));
    const auto told = path_.outcomes.find(sequencer_.address());
    const bool is_told = told != path_.outcomes.end();
    const bool known_d = d_.get(word) == 0;
    const auto d = static_cast<std::uint16_t>(address_.get(word));

    bool pass = pol_.get(word) == 0;
    if (uses_condition(op) && cond_.get(word) != 0) {
      if (!is_told) fail_here("depends on data", "divide the path, or say pass or fail");
      pass = told->second;
    }
    if (op == SequencerOp::kJmap || (op == SequencerOp::kCjv && pass))
      fail_here("goes where data say", "divide the path");
    if (takes_top(op, pass) && sequencer_.stack_level() == 0)
      fail_here("returns beyond its beginning", "end the path there");
    if (uses_counter(op, pass) && !counter_known_) {
      if (op != SequencerOp::kRpct && op != SequencerOp::kRfct)
        fail_here("needs a counter that is not known", "divide the path");
      if (!is_told) fail_here("loops as often as data say", "say pass or fail");
      leave_or_repeat(op, told->second, d);
      return;
    }
    if (takes_d(op, pass, sequencer_.counter()) && !known_d)
      fail_here("goes where data say", "divide the path");
    sequencer_.step(op, pass, d);
    if (op == SequencerOp::kLdct || (op == SequencerOp::kPush && pass)) counter_known_ = known_d;
  }

  // A counted loop whose count is not known, as the path says.
  void leave_or_repeat(SequencerOp op, bool repeat, std::uint16_t d) {
    if (op == SequencerOp::kRpct)
      sequencer_.step(SequencerOp::kCjp, repeat, d);
    else
      sequencer_.step(SequencerOp::kLoop, !repeat, d);
  }

  [[noreturn]] void fail_here(const std::string& what, const std::string& to_do) const {
    const std::uint32_t at = sequencer_.address();
    fail(what + " at address " + std::to_string(at) + " (line " +
         std::to_string(program_.sources[at].line) + "); " + to_do);
  }
  [[noreturn]] static void fail(const std::string& what) { throw std::invalid_argument(what); }

  const Program& program_;
  const Path& path_;
  const FieldPlace op_, pol_, d_, address_, cond_;
  Sequencer sequencer_;
  bool counter_known_ = false;
};

}  // namespace

Cycle count_path(const Program& program, const Path& path) { return Walk(program, path).count(); }

}  // namespace cigsim::firmware
