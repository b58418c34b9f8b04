// SPDX-License-Identifier: MIT
// What the video processor reads beside its links, in two banks by the parity of the picture.
#pragma once

#include <array>

#include "models/boundary/transactions.hpp"

namespace cigsim::video_processor {

struct VideoBank {
  Colour background;
};

using VideoBanks = std::array<VideoBank, 2>;

}  // namespace cigsim::video_processor
