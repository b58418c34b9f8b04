// SPDX-License-Identifier: MIT
// Edge orderer, timed level (docs/machine/edge_orderer.md): the load side and the line side as
// processes that compute exact cycles, without a clock.
#pragma once

#include <array>
#include <systemc>

#include "models/boundary/link.hpp"
#include "models/boundary/words.hpp"
#include "models/edge_orderer/line_orderer.hpp"

namespace cigsim::edge_orderer {

class Timed : public sc_core::sc_module {
 public:
  struct Links {
    Link<EdgeWord>& edges;
    Link<FrameWord>& loaded;
    Link<FrameWord>& start;
    Link<CrossingWord>& crossings;
  };

  /// `figures`, which may be empty, is called once a frame, when its last word is in the link.
  Timed(sc_core::sc_module_name name, const MachineDescription& machine, OverloadPolicy policy,
        const Links& links, FiguresFunction figures = {});

 private:
  void load();
  void order();
  void line();
  void begin_pass(std::uint32_t crossings);
  void offer(const CrossingWord& word);

  Links links_;
  FiguresFunction report_;
  std::uint32_t height_, pass_size_;
  std::array<EdgeBank, 2> banks_;
  LineOrderer orderer_;

  Cycle filled_ = 0;       // F of the last pass
  Cycle drained_ = 0;      // D of the pass before it, whose words are all in the link
  Cycle first_offer_ = 0;  // of the last pass
  Cycle words_ = 0;        // of the last pass
  Cycle stalled_ = 0;
};

}  // namespace cigsim::edge_orderer
