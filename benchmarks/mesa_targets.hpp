// SPDX-License-Identifier: MIT
// llvmpipe making what cigsim makes: one pass into a picture and 16-bit object numbers, both read
// into memory.
#pragma once

#include "benchmarks/mesa_context.hpp"

namespace cigsim::benchmarks {

class MesaTargets {
 public:
  /// Throws as MesaContext does, and std::runtime_error when GL refuses the shaders or targets.
  MesaTargets(const Mesh& mesh, const Raster& raster);

  /// Draws a frame and reads it. Valid until the next call.
  const Picture& draw(const ViewTransform& view);

 private:
  std::array<float, 4> clear_;
  std::vector<std::uint32_t> default_framebuffer_;
  MesaContext context_;
  GLint matrix_ = 0;
  Picture picture_;
};

}  // namespace cigsim::benchmarks
