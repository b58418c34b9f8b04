// SPDX-License-Identifier: MIT
#include "models/geometry_processor/timed.hpp"

#include <algorithm>
#include <iterator>

#include "models/geometry_processor/program.hpp"

namespace cigsim::geometry_processor {
namespace {

// By Step.
constexpr const char* kCosts[] = {
    "item",     "late_item",    "drop_item",      "vertex_out", "vertex_in",    "vertices",
    "item_out", "late_face",    "drop_face",      "back",       "shown",        "corner",
    "outside",  "whole",        "whole_over",     "clip",       "plane_passed", "plane",
    "both_in",  "leaving",      "both_out",       "entering",   "plane_done",   "clipped_away",
    "project",  "project_over", "project_corner", "projected",  "points",       "level",
    "long",     "edge_out",     "short",          "short_out",  "made",         "face_out",
    "no_face"};
static_assert(std::size(kCosts) == static_cast<std::size_t>(Step::kCount));

}  // namespace

Timed::Timed(sc_core::sc_module_name name, const MachineDescription& machine,
             OverloadPolicy overload, Links links, const std::array<GeometryBank, 2>& banks,
             FiguresFunction figures)
    : sc_module(name),
      banks_(banks),
      report_(std::move(figures)),
      pace_{links},
      walk_(machine, pace_) {
  SC_HAS_PROCESS(Timed);
  SC_THREAD(run);
  const firmware::Program code = program(machine.formats);
  for (std::size_t i = 0; i < pace_.cost.size(); ++i) pace_.cost[i] = code.cost(kCosts[i]);
  pace_.deadline = deadline(machine, overload);
  pace_.take_cost = code.cost("take_item");
  start_cost_ = code.cost("start");
  end_faces_ = code.cost("end_faces");
  end_edges_ = code.cost("end_edges");
  finish_ = code.cost("finish");
}

void Timed::run() {
  for (;;) frame();
}

void Timed::frame() {
  Link<FrameWord>& start = pace_.links.start;
  pace_.start = std::max(start.available(), free_);  // GP18
  const std::uint32_t frame = start.front().frame;
  start.take(pace_.start);
  pace_.now = pace_.start + start_cost_;
  pace_.idle = pace_.stalled = 0;
  figures_ = {};
  figures_.frame = frame;
  walk_.run(banks_[frame & 1], figures_);
  FaceWord last_face;
  last_face.end = true;
  pace_.put(pace_.links.faces, last_face);
  pace_.now += end_faces_;
  EdgeWord last_edge;
  last_edge.end = true;
  pace_.put(pace_.links.edges, last_edge);
  pace_.now += end_edges_;
  const Cycle finish = std::max(pace_.links.edges.last_push(), pace_.links.faces.last_push());
  figures_.activity = {pace_.start, finish, pace_.idle, pace_.stalled + finish - pace_.now};
  free_ = finish + finish_;
  if (report_) report_(figures_);
}

ItemWord Timed::Pace::take() {
  const Cycle at = std::max(now, links.items.available());
  idle += at - now;
  const ItemWord word = links.items.front();
  links.items.take(at);
  now = at + take_cost;
  return word;
}

// GP17: in the first cycle in which the register is free; offered from the next one on.
template <class T>
void Timed::Pace::put(Link<T>& link, const T& word) {
  const Cycle free = std::max(now, link.last_push());
  stalled += free - now;
  now = free;
  link.offer(word, now + 1);
}

}  // namespace cigsim::geometry_processor
