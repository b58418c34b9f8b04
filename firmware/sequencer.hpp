// SPDX-License-Identifier: MIT
// The microsequencer: one microinstruction a clock, in the manner of the Am2910 (Advanced Micro
// Devices 1977: the sixteen instructions, the 12-bit addresses, the register/counter and the stack
// of five are published there). That a machine of 1975 had such a sequencer is a reconstruction.
//
// docs/machine/microprograms.md, "Sequencer", lists the instructions and where this differs from
// the chip: no carry input (the program counter always counts), no register load input, no
// three-state outputs; addresses past the end of the control store are a fault of the program.
#pragma once

#include <array>
#include <cstdint>

namespace cigsim::firmware {

inline constexpr unsigned kAddressBits = 12;
inline constexpr std::uint16_t kAddressMask = (1u << kAddressBits) - 1;
inline constexpr unsigned kStackDepth = 5;

/// The instructions, with their codes. D is the sequencer's data input, R the register/counter, F
/// the top of the stack, PC the address after the current one. `pass` is the condition's outcome.
enum class SequencerOp : std::uint8_t {
  kJz = 0,     ///< to 0, the stack is emptied
  kCjs = 1,    ///< pass: push PC, to D; else PC
  kJmap = 2,   ///< to D, which the processor's map drives
  kCjp = 3,    ///< pass: to D; else PC
  kPush = 4,   ///< push PC; pass: R = D; to PC
  kJsrp = 5,   ///< push PC; pass: to D; else to R
  kCjv = 6,    ///< pass: to D, which the processor's vector drives; else PC
  kJrp = 7,    ///< pass: to D; else to R
  kRfct = 8,   ///< R != 0: R = R - 1, to F; else pop, PC
  kRpct = 9,   ///< R != 0: R = R - 1, to D; else PC
  kCrtn = 10,  ///< pass: to F, pop; else PC
  kCjpp = 11,  ///< pass: to D, pop; else PC
  kLdct = 12,  ///< R = D; to PC
  kLoop = 13,  ///< pass: pop, PC; else to F
  kCont = 14,  ///< to PC
  kTwb = 15    ///< pass: pop, PC (R counts down unless 0); else R != 0: R = R - 1, to F;
               ///< else pop, to D
};

class Sequencer {
 public:
  /// Address of the microinstruction that is executed in this clock.
  std::uint16_t address() const { return address_; }
  std::uint16_t counter() const { return counter_; }
  /// Return addresses on the stack, 0..kStackDepth.
  unsigned stack_level() const { return level_; }
  /// The top of the stack; 0 when it is empty.
  std::uint16_t stack_top() const { return level_ == 0 ? std::uint16_t{0} : stack_[level_ - 1]; }

  /// To address 0, stack empty, counter 0.
  void reset() { *this = Sequencer(); }

  /// One clock: works out the next address. `d`: 12 bits. A push on a full stack overwrites its
  /// top, a pop of the empty stack changes nothing, as with the chip.
  void step(SequencerOp op, bool pass, std::uint16_t d) {
    const auto pc = static_cast<std::uint16_t>((address_ + 1) & kAddressMask);
    const std::uint16_t top = stack_top();
    const bool counting = counter_ != 0;
    std::uint16_t next = pc;
    switch (op) {
      case SequencerOp::kJz:
        next = 0;
        level_ = 0;
        break;
      case SequencerOp::kCjs:
        if (pass) {
          push(pc);
          next = d;
        }
        break;
      case SequencerOp::kJmap:
        next = d;
        break;
      case SequencerOp::kCjp:
      case SequencerOp::kCjv:
        if (pass) next = d;
        break;
      case SequencerOp::kPush:
        push(pc);
        if (pass) counter_ = d;
        break;
      case SequencerOp::kJsrp:
        push(pc);
        next = pass ? d : counter_;
        break;
      case SequencerOp::kJrp:
        next = pass ? d : counter_;
        break;
      case SequencerOp::kRfct:
        if (counting) {
          --counter_;
          next = top;
        } else {
          pop();
        }
        break;
      case SequencerOp::kRpct:
        if (counting) {
          --counter_;
          next = d;
        }
        break;
      case SequencerOp::kCrtn:
        if (pass) {
          next = top;
          pop();
        }
        break;
      case SequencerOp::kCjpp:
        if (pass) {
          next = d;
          pop();
        }
        break;
      case SequencerOp::kLdct:
        counter_ = d;
        break;
      case SequencerOp::kLoop:
        if (pass)
          pop();
        else
          next = top;
        break;
      case SequencerOp::kCont:
        break;
      case SequencerOp::kTwb:
        if (!pass) next = counting ? top : d;
        if (pass || !counting) pop();
        if (counting) --counter_;
        break;
    }
    address_ = next;
  }

 private:
  void push(std::uint16_t value) {
    if (level_ < kStackDepth) ++level_;
    stack_[level_ - 1] = value;
  }
  void pop() {
    if (level_ > 0) --level_;
  }

  std::uint16_t address_ = 0, counter_ = 0;
  std::uint8_t level_ = 0;
  std::array<std::uint16_t, kStackDepth> stack_{};
};

}  // namespace cigsim::firmware
