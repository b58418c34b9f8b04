// SPDX-License-Identifier: MIT
// Embree: coherent packets of eight primary rays on one thread.
#pragma once

#include <memory>
#include <string>

#include "benchmarks/mesh.hpp"
#include "models/boundary/transactions.hpp"

namespace cigsim::benchmarks {

class EmbreeRenderer {
 public:
  /// Whether the processor has what the packets need.
  static bool available();

  /// Builds the tree. Throws std::runtime_error when Embree reports a fault. The raster must be a
  /// multiple of 4 x 2.
  EmbreeRenderer(const Mesh& mesh, const Raster& raster);
  ~EmbreeRenderer();

  /// Draws a frame, colours and object numbers. Valid until the next call.
  const Picture& draw(const ViewTransform& view);

  std::string description() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cigsim::benchmarks
