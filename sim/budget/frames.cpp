// SPDX-License-Identifier: MIT
#include "sim/budget/frames.hpp"

#include <algorithm>

namespace cigsim {

FrameSample sample_frames(std::size_t frames, std::size_t most) {
  FrameSample sample;
  const std::size_t count = std::min(most, (frames + 1) / 2);
  for (std::size_t i = 0; i < count; ++i)
    sample.sampled.push_back(count == 1 ? 0 : (i * (frames - 1) + (count - 1) / 2) / (count - 1));
  std::vector<std::size_t> rest;
  for (std::size_t frame = 0; frame < frames; ++frame)
    if (!std::binary_search(sample.sampled.begin(), sample.sampled.end(), frame))
      rest.push_back(frame);
  const std::size_t held = std::min(most, rest.size());
  for (std::size_t i = 0; i < held; ++i)
    sample.held_back.push_back(rest[(2 * i + 1) * rest.size() / (2 * held)]);
  return sample;
}

}  // namespace cigsim
