// SPDX-License-Identifier: MIT
// One bank of the face memory (docs/machine/video_processor.md): what each face of a picture looks
// like, by the face's number.
#pragma once

#include <cassert>
#include <vector>

#include "models/boundary/words.hpp"
#include "models/video_processor/fill.hpp"

namespace cigsim::video_processor {

/// What an element shows, as in Picture.
struct Shade {
  std::uint32_t colour = 0;  ///< 0xAABBGGRR, A = 255
  std::uint16_t number = 0;  ///< object number
};

class FaceMemory {
 public:
  void store(const FaceWord& word) {
    if (word.face >= faces_.size()) faces_.resize(2 * std::size_t{word.face} + 64);
    faces_[word.face] = {0xff000000u | word.colour, number_of(word.object)};
  }
  /// `face` must have been stored.
  const Shade& operator[](std::uint32_t face) const {
    assert(face < faces_.size());
    return faces_[face];
  }

 private:
  std::vector<Shade> faces_;
};

}  // namespace cigsim::video_processor
