// SPDX-License-Identifier: MIT
#include "models/priority_processor/timed.hpp"

#include <algorithm>

#include "firmware/programs.hpp"

namespace cigsim::priority_processor {
namespace {

// By Step.
constexpr const char* kCosts[] = {
    "in_view",   "nothing",    "pieces_only", "group_of_one", "group_bare", "group",   "plane",
    "pair",      "next_plane", "last_plane",  "order",        "member",     "ordered", "fault",
    "rank",      "ranked",     "next_rank",   "last_rank",    "to_group",   "to_item", "to_list",
    "item",      "up",         "out",         "list",         "list_on",    "list_up", "list_out",
    "to_ground", "ground",     "to_end"};
static_assert(std::size(kCosts) == static_cast<std::size_t>(Step::kCount));

}  // namespace

Timed::Timed(sc_core::sc_module_name name, const MachineDescription& machine, Links links,
             const std::array<PriorityBank, 2>& banks, FiguresFunction figures)
    : sc_module(name),
      start_(links.start),
      banks_(banks),
      capacity_(machine.object_capacity),
      report_(std::move(figures)),
      pace_{links.items},
      walk_(pace_) {
  SC_HAS_PROCESS(Timed);
  SC_THREAD(run);
  const firmware::Program program = firmware::stage_program("priority_processor");
  for (std::size_t i = 0; i < pace_.cost.size(); ++i) pace_.cost[i] = program.cost(kCosts[i]);
  take_ = program.cost("take");
  end_ = program.cost("end");
  finish_ = program.cost("finish");
}

void Timed::run() {
  for (;;) frame();
}

void Timed::frame() {
  const Cycle start = std::max(start_.available(), free_);  // PP7
  const std::uint32_t frame = start_.front().frame;
  start_.take(start);
  figures_ = {};
  figures_.frame = frame;
  pace_.now = start + take_;
  pace_.stalled = 0;
  walk_.run(banks_[frame & 1], capacity_, figures_);
  pace_.put({SetId::kStatic, 0, true});
  pace_.now += end_;
  const Cycle finish = pace_.out.last_push();
  figures_.activity = {start, finish, 0, pace_.stalled + finish - pace_.now};
  free_ = finish + 1 + finish_;
  if (report_) report_(figures_);
}

// PP8: in the first cycle in which the register is free; offered from the next one on.
void Timed::Pace::put(const ItemWord& item) {
  const Cycle free = std::max(now, out.last_push());
  stalled += free - now;
  now = free;
  out.offer(item, now + 1);
}

}  // namespace cigsim::priority_processor
