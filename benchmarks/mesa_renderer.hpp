// SPDX-License-Identifier: MIT
// Mesa llvmpipe through OSMesa, set up for its best case: see docs/performance.md.
#pragma once

#include <memory>
#include <string>

#include "benchmarks/mesh.hpp"
#include "models/boundary/transactions.hpp"

namespace cigsim::benchmarks {

class MesaRenderer {
 public:
  /// Throws std::runtime_error when there is no llvmpipe, std::invalid_argument when an object
  /// number does not fit into eight bits.
  MesaRenderer(const Mesh& mesh, const Raster& raster);
  ~MesaRenderer();

  /// Draws a frame and waits until it lies in memory: R, G, B and the object number, a byte each,
  /// rows from the top. Valid until the next call.
  const std::vector<std::uint32_t>& draw(const ViewTransform& view);

  /// What GL says of itself.
  std::string description() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cigsim::benchmarks
