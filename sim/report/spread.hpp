// SPDX-License-Identifier: MIT
// Some of many, spread evenly.
#pragma once

#include <cstddef>
#include <vector>

namespace cigsim {

/// `shown` of the numbers below `count`, ascending, the first and the last among them; all where
/// there are no more.
inline std::vector<std::size_t> spread_evenly(std::size_t count, std::size_t shown) {
  std::vector<std::size_t> out;
  if (shown >= count)
    for (std::size_t i = 0; i < count; ++i) out.push_back(i);
  else
    for (std::size_t i = 0; i < shown; ++i)
      out.push_back(shown == 1 ? 0 : i * (count - 1) / (shown - 1));
  return out;
}

}  // namespace cigsim
