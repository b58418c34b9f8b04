// SPDX-License-Identifier: MIT
#include "models/edge_orderer/timed.hpp"

#include <algorithm>
#include <limits>

namespace cigsim::edge_orderer {

Timed::Timed(sc_core::sc_module_name name, const MachineDescription& machine, OverloadPolicy policy,
             const Links& links, FiguresFunction figures)
    : sc_module(name),
      links_(links),
      report_(std::move(figures)),
      height_(static_cast<std::uint32_t>(machine.raster.height)),
      pass_size_(policy == OverloadPolicy::kExtend && machine.crossing_capacity > 0
                     ? machine.crossing_capacity
                     : std::numeric_limits<std::uint32_t>::max()),
      banks_{EdgeBank(machine.raster.height), EdgeBank(machine.raster.height)},
      orderer_(machine.raster.width, machine.crossing_capacity, policy) {
  SC_HAS_PROCESS(Timed);
  SC_THREAD(load);
  SC_THREAD(order);
}

// EO5, EO6.
void Timed::load() {
  Cycle from = 0;
  for (std::uint32_t frame = 0;; ++frame) {
    EdgeBank& bank = banks_[frame % 2];
    links_.edges.available();  // until then the bank may still be read
    bank.clear();
    for (bool more = true; more;) {
      const Cycle at = std::max(links_.edges.available(), from);
      more = !links_.edges.front().end;
      if (more) bank.add(links_.edges.front());
      links_.edges.take(at);
      from = at + 1;
    }
    from = links_.loaded.push_from({frame}, from) + 1;
  }
}

void Timed::order() {
  for (Cycle idle_from = 0;;) {
    const Cycle start = std::max(links_.start.available(), idle_from);  // EO7
    const std::uint32_t frame = links_.start.front().frame;
    orderer_.begin(banks_[frame % 2]);
    links_.start.take(start);
    filled_ = drained_ = start;
    words_ = stalled_ = 0;
    first_offer_ = start + 1;
    for (std::uint32_t r = 0; r < height_; ++r) line();
    const Cycle finish = links_.crossings.last_push();
    stalled_ += finish - first_offer_ + 1 - words_;
    idle_from = finish + 1;
    if (!report_) continue;
    Figures figures = orderer_.figures();
    figures.frame = frame;
    figures.activity = {start, finish, 0, stalled_};
    report_(figures);
  }
}

void Timed::line() {
  const OrderedLine& line = orderer_.next();
  const auto n = static_cast<std::uint32_t>(line.crossings.size());
  begin_pass(n);
  std::uint32_t left = pass_size_;
  line.for_each_kept([&](const ActiveEdge& edge) {
    if (left-- == 0) {
      begin_pass(n);
      left = pass_size_ - 1;
    }
    offer({edge.face(), edge.element(), edge.left(), false, false});
  });
  offer({0, line.cut_element, false, true, line.cut});
}

// EO8 to EO10 and EO12: the next pass, through `crossings` crossings. Words of the pass before are
// offered, and are waited for here: only then are their cycles needed.
void Timed::begin_pass(std::uint32_t crossings) {
  const Cycle drained = words_ == 0 ? filled_ : links_.crossings.last_push();
  stalled_ += words_ == 0 ? 0 : drained - first_offer_ + 1 - words_;
  filled_ = std::max(filled_, drained_) + 1 + crossings;
  drained_ = drained;
  first_offer_ = std::max(filled_, drained_) + 1;
  words_ = 0;
}

void Timed::offer(const CrossingWord& word) {
  links_.crossings.offer(word, first_offer_);
  ++words_;
}

}  // namespace cigsim::edge_orderer
