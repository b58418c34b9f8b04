// SPDX-License-Identifier: MIT
// Priority processor, functional level in machine words: the list that the timed and the clocked
// level give, without time.
#pragma once

#include <vector>

#include "models/priority_processor/list_walk.hpp"

namespace cigsim::priority_processor {

class FunctionalWords {
 public:
  /// `capacity`: most items of a frame, 0 for any number (MachineDescription::object_capacity).
  explicit FunctionalWords(std::uint32_t capacity) : capacity_(capacity) {}

  /// The items of a frame from the highest priority to the lowest, then the end word. `figures` has
  /// no activity.
  void compute(const PriorityBank& bank, std::vector<ItemWord>& out, Figures& figures) {
    out.clear();
    figures = {};
    Collector collector{out};
    ListWalk<Collector>(collector).run(bank, capacity_, figures);
    out.push_back({SetId::kStatic, 0, true});
  }

 private:
  struct Collector {
    std::vector<ItemWord>& items;
    void put(const ItemWord& item) { items.push_back(item); }
    void spend(Step, std::uint64_t = 1) {}
  };

  std::uint32_t capacity_;
};

}  // namespace cigsim::priority_processor
