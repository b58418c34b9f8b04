// SPDX-License-Identifier: MIT
#include "models/frame_calculator/functional.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "models/environment/placement.hpp"
#include "models/frame_calculator/detail.hpp"
#include "models/frame_calculator/moving.hpp"
#include "models/frame_calculator/retrieval.hpp"

namespace cigsim::frame_calculator {

ViewTransform view_transform(const Viewpoint& viewpoint, const Raster& raster) {
  const Placement& eye = viewpoint.eye;
  for (const double value : {eye.position.x, eye.position.y, eye.position.z, eye.heading, eye.pitch,
                             eye.roll, viewpoint.fov})
    if (!std::isfinite(value)) throw std::invalid_argument("viewpoint: a number is not finite");
  if (!(viewpoint.fov > 0 && viewpoint.fov < 180))
    throw std::invalid_argument("viewpoint: the field of view must lie between 0 and 180 degrees");
  ViewTransform view;
  view.eye = eye.position;
  view.rotation = body_axes(eye);
  const double half = viewpoint.fov / 2;
  view.focal = raster.height / 2.0 * (cos_degrees(half) / sin_degrees(half));
  if (!std::isfinite(view.focal))
    throw std::invalid_argument(
        "viewpoint: the field of view is too narrow for a focal length; take a wider one");
  view.raster = raster;
  return view;
}

Placement placement_at(const PreparedSystem& system, double frame) {
  const std::vector<MotionKey>& keys = system.motion;
  if (keys.empty()) return system.placement;
  const auto after = std::upper_bound(keys.begin(), keys.end(), frame,
                                      [](double f, const MotionKey& key) { return f < key.frame; });
  if (after == keys.begin()) return keys.front().placement;
  if (after == keys.end()) return keys.back().placement;
  const MotionKey& before = *(after - 1);
  const double t = (frame - before.frame) / (after->frame - before.frame);
  return interpolate(before.placement, after->placement, t);
}

void Functional::compute(const Viewpoint& viewpoint, const Raster& raster, double frame,
                         ActiveEnvironment& out, FaceSet& moving) const {
  out.view = view_transform(viewpoint, raster);
  ForcedMembers forced;
  out.detail.clear();
  Choices choices(database_.systems[0].hierarchy, out.view, detail_);
  place_moving_models(database_, frame, detail_, choices, out, moving, forced);
  retrieve(database_.systems[0].hierarchy, out.view, forced, retrieval_, choices, out.groups);
  choices.count(out.detail);
}

}  // namespace cigsim::frame_calculator
