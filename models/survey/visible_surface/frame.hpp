// SPDX-License-Identifier: MIT
// The survey's list of faces for one frame of a prepared database.
#pragma once

#include <vector>

#include "models/survey/visible_surface/face_list.hpp"

namespace cigsim::survey {

struct Frame {
  FaceList list;
  std::vector<ListabilityFault> faults;  ///< groups for which the machine has no right order
};

/// `frame` places the moving models. Throws std::invalid_argument as view_transform().
Frame make_frame(const Database& database, const Viewpoint& viewpoint, const Raster& raster,
                 double frame);

}  // namespace cigsim::survey
