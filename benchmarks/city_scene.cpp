// SPDX-License-Identifier: MIT
#include "benchmarks/city_scene.hpp"

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"

namespace cigsim::benchmarks {
namespace {

constexpr int kEyepoints = 16;
constexpr double kStep = 0.25;  ///< environment units from eyepoint to eyepoint

}  // namespace

CityScene make_city(bool with_ground) {
  Environment environment = generate_environment("city", {200, 1});
  if (!with_ground) environment.ground.clear();
  CityScene scene{prepare(environment), {}};
  for (int k = 0; k < kEyepoints; ++k) {
    Viewpoint viewpoint{environment.view->eye, environment.view->fov};
    viewpoint.eye.position.x += kStep * (k - kEyepoints / 2);
    scene.path.push_back(viewpoint);
  }
  return scene;
}

}  // namespace cigsim::benchmarks
