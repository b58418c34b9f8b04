// SPDX-License-Identifier: MIT
// llvmpipe at its best: colour and object number in one word of one pass, so 255 objects at most.
#pragma once

#include "benchmarks/mesa_context.hpp"

namespace cigsim::benchmarks {

class MesaPacked {
 public:
  /// Throws as MesaContext does, and std::invalid_argument for an object number above 255.
  MesaPacked(const Mesh& mesh, const Raster& raster);

  /// Draws a frame and waits until it lies in memory: R, G, B and the object number, a byte each,
  /// rows from the top. Valid until the next call.
  const std::vector<std::uint32_t>& draw(const ViewTransform& view);

  std::string description() const { return context_.description(); }

 private:
  std::vector<std::uint32_t> elements_;
  MesaContext context_;
};

}  // namespace cigsim::benchmarks
