// SPDX-License-Identifier: MIT
// Eight rays at a time. The file is compiled for AVX2: call only where the processor has it.
#pragma once

#include <embree3/rtcore.h>

#include <cstdint>

namespace cigsim::benchmarks {

/// Rays of a frame: element (c, r) looks along corner + c * right + r * down.
struct RayFrame {
  float eye[3], corner[3], right[3], down[3];
  int width = 0, height = 0;  ///< multiples of 4 and 2
};

/// What an element gets where face k is hit: entry k + 1; entry 0 is the background.
struct FaceTable {
  const std::uint32_t* colours;
  const std::uint16_t* numbers;
};

/// Casts packets of 4 x 2 elements and writes both pictures.
void cast_packets(RTCScene scene, const RayFrame& frame, const FaceTable& table,
                  std::uint32_t* colours, std::uint16_t* numbers);

}  // namespace cigsim::benchmarks
