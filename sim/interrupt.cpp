// SPDX-License-Identifier: MIT
#include "sim/interrupt.hpp"

#include <csignal>
#include <initializer_list>

namespace cigsim {
namespace {

volatile std::sig_atomic_t arrived = 0;  // a handler reaches nothing else

void mark(int signal) { arrived = signal; }

void install(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESETHAND;
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
  arrived = 0;
  install(mark);
}
Interrupt::~Interrupt() { install(SIG_DFL); }

int Interrupt::signal() const { return arrived; }

}  // namespace cigsim
