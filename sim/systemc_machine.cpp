// SPDX-License-Identifier: MIT
#include "sim/systemc_machine.hpp"

#include <stdexcept>
#include <utility>

namespace cigsim {

class SystemcMachine::Impl {
 public:
  Next next;
  Out out;
};

SystemcMachine::SystemcMachine(const std::string&, const PipelineOptions&) {
  throw std::runtime_error("--level: the pipeline is not assembled yet");
}
SystemcMachine::~SystemcMachine() = default;
void SystemcMachine::feed(Next next, Out out) {
  impl_->next = std::move(next);
  impl_->out = std::move(out);
}
void SystemcMachine::simulate() {}
void SystemcMachine::set_probe(const Probe&) {}

}  // namespace cigsim
