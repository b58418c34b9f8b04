// SPDX-License-Identifier: MIT
#include "models/frame_calculator/timed.hpp"

#include <utility>

namespace cigsim::frame_calculator {

Timed::Timed(sc_core::sc_module_name name, const MachineDescription& machine, const Links& links,
             Calculate calculate, std::function<void(const Figures&)> report)
    : sc_module(name),
      costs_(machine.frame_calculator),
      links_(links),
      calculate_(std::move(calculate)),
      report_(std::move(report)) {
  SC_HAS_PROCESS(Timed);
  SC_THREAD(run);
}

void Timed::run() {
  for (;;) {
    const Cycle start = links_.start.available();  // FC1
    const FrameWord word = links_.start.front();
    links_.start.take(start);
    const Work work = calculate_(word.frame);
    const Cycle cycles = costs_.frame + costs_.sphere * static_cast<Cycle>(work.spheres) +
                         costs_.vertex * static_cast<Cycle>(work.vertices);      // FC2
    const Cycle finish = links_.calculated.push_from(word, start + cycles + 1);  // FC3
    Figures figures;
    figures.frame = word.frame;
    figures.activity = {start, finish, 0, finish - (start + cycles + 1)};
    figures.overflows = work.overflows;
    figures.spheres = work.spheres;
    figures.vertices = work.vertices;
    if (report_) report_(figures);
  }
}

}  // namespace cigsim::frame_calculator
