// SPDX-License-Identifier: MIT
// Counting what preparation drops and repairs.
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "models/environment/read.hpp"

namespace cigsim {

class Notices {
 public:
  void add(std::string_view what, std::uint64_t count = 1) {
    if (count == 0) return;
    const auto at = std::find_if(list_.begin(), list_.end(),
                                 [&](const Notice& notice) { return notice.what == what; });
    if (at != list_.end())
      at->count += count;
    else
      list_.push_back({std::string(what), count});
  }
  const std::vector<Notice>& list() const { return list_; }

 private:
  std::vector<Notice> list_;
};

}  // namespace cigsim
