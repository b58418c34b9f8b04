// SPDX-License-Identifier: MIT
// Frame calculator, functional level: what the general-purpose computer does in frame 1.
// Retrieval by spheres against the pyramid of vision follows Levine 1975 (ch. II, COCA trees) and
// Sandor 1979 (cluster clipping); that moving models find their place among the static separation
// planes here is a reconstruction.
#pragma once

#include "models/boundary/transactions.hpp"

namespace cigsim::frame_calculator {

/// Throws std::invalid_argument unless the numbers are finite and the field of view lies in
/// (0, 180) degrees.
ViewTransform view_transform(const Viewpoint& viewpoint, const Raster& raster);

/// Where a moving system stands at a frame.
Placement placement_at(const PreparedSystem& system, double frame);

/// Works out a frame. `moving` receives the pieces of moving models, placed (each vertex rounded to
/// doubles once) and cut where a static plane passes through them.
class Functional {
 public:
  /// `detail`: what the thresholds of levels of detail are multiplied by (description_shown()).
  /// `retrieval`: false takes everything as in view.
  explicit Functional(const Database& database, double detail = 1, bool retrieval = true)
      : database_(database), detail_(detail), retrieval_(retrieval) {}

  void compute(const Viewpoint& viewpoint, const Raster& raster, double frame,
               ActiveEnvironment& out, FaceSet& moving) const;

 private:
  const Database& database_;
  double detail_;
  bool retrieval_;
};

}  // namespace cigsim::frame_calculator
