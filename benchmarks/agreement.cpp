// SPDX-License-Identifier: MIT
#include "benchmarks/agreement.hpp"

#include <algorithm>

namespace cigsim::benchmarks {
namespace {

// Whether `picture` shows at or beside element (c, r) what `other` shows at it.
bool shown_beside(const Picture& picture, const Picture& other, int c, int r) {
  const std::size_t wanted = static_cast<std::size_t>(r) * other.width + c;
  for (int y = std::max(r - 1, 0); y <= std::min(r + 1, picture.height - 1); ++y)
    for (int x = std::max(c - 1, 0); x <= std::min(c + 1, picture.width - 1); ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * picture.width + x;
      if (picture.colours[at] == other.colours[wanted] &&
          picture.numbers[at] == other.numbers[wanted])
        return true;
    }
  return false;
}

}  // namespace

Agreement& Agreement::operator+=(const Agreement& more) {
  elements += more.elements;
  differing += more.differing;
  astray += more.astray;
  return *this;
}

Agreement compare(const Picture& reference, const Picture& other) {
  Agreement result;
  result.elements = reference.colours.size();
  for (int r = 0; r < reference.height; ++r)
    for (int c = 0; c < reference.width; ++c) {
      const std::size_t at = static_cast<std::size_t>(r) * reference.width + c;
      if (reference.colours[at] == other.colours[at] && reference.numbers[at] == other.numbers[at])
        continue;
      ++result.differing;
      if (!shown_beside(reference, other, c, r)) ++result.astray;
    }
  return result;
}

}  // namespace cigsim::benchmarks
