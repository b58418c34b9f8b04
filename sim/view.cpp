// SPDX-License-Identifier: MIT
#include "sim/view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/arguments.hpp"
#include "sim/embedded.hpp"
#include "sim/functional_machine.hpp"

namespace cigsim {
namespace {

constexpr std::uint64_t kMostFrames = 1000000;

// The middle of the box around what the scene holds; the ground counts when there is no object.
Vec3 centre_of(const Database& database) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  const auto include = [&](const Sphere& s) {
    const Vec3 reach{s.radius, s.radius, s.radius};
    const Vec3 a = s.centre - reach, b = s.centre + reach;
    low = {std::min(low.x, a.x), std::min(low.y, a.y), std::min(low.z, a.z)};
    high = {std::max(high.x, b.x), std::max(high.y, b.y), std::max(high.z, b.z)};
  };
  for (const Item& item : database.systems.front().set.items) include(item.sphere);
  for (std::size_t i = 1; i < database.systems.size(); ++i) {
    const PreparedSystem& system = database.systems[i];
    if (system.set.items.empty()) continue;
    const Placement& place = system.motion.empty() ? system.placement : system.motion[0].placement;
    include({place.position, system.sphere.radius});
  }
  if (low.x > high.x)
    for (const Item& item : database.ground.items) include(item.sphere);
  return low.x > high.x ? Vec3{} : low * 0.5 + high * 0.5;
}

Placement turned(const Placement& eye, const Attitude& attitude) {
  return {eye.position, attitude.heading, attitude.pitch, attitude.roll};
}

Placement fixed_eye(const ViewOptions& options, const Database& database) {
  Placement eye = database.view.eye;
  if (options.eye) eye.position = *options.eye;
  if (options.attitude) return turned(eye, *options.attitude);
  if (options.look_at) {
    if (*options.look_at == eye.position)
      throw UsageError("--look-at: the eye stands at that point; give another one or --attitude");
    return look_at(eye.position, *options.look_at);
  }
  if (!options.eye) return eye;
  const Vec3 centre = centre_of(database);
  return centre == eye.position ? turned(eye, {}) : look_at(eye.position, centre);
}

}  // namespace

void add_view_options(CLI::App& command, ViewOptions& o) {
  using Text = std::string;
  const auto add = [&](const char* name, const char* form, auto take, const char* help) {
    return command.add_option_function<Text>(name, take, help)->type_name(form)->group("View");
  };
  CLI::Option* eye = add(
      "--eye", "X,Y,Z", [&](const Text& t) { o.eye = parse_vector("--eye", t); },
      "Where the eye stands: x east, y north, z up, in units of the scene. Default: the scene's "
      "own view");
  CLI::Option* look = add(
      "--look-at", "X,Y,Z", [&](const Text& t) { o.look_at = parse_vector("--look-at", t); },
      "The point that the eye looks at. Default with --eye: the centre of the scene");
  CLI::Option* attitude = add(
      "--attitude", "H,P,R",
      [&](const Text& t) {
        const std::vector<double> v = parse_list("--attitude", t, "H,P,R");
        o.attitude = {v[0], v[1], v[2]};
      },
      "Instead of --look-at: heading clockwise from north, pitch up, roll right, in degrees");
  add(
      "--fov", "DEG", [&](const Text& t) { o.fov = parse_fov("--fov", t); },
      "Vertical field of view, between 0 and 180 degrees. Default: the path's or the scene's");
  CLI::Option* path = add(
      "--path", "FILE.csv", [&](const Text& t) { o.path = t; },
      "Instead of --eye: fly along a table of viewpoints: its first line names the columns "
      "x,y,z,heading,pitch,roll "
      "and, if wanted, fov; one row a frame. The word 'builtin' means the airfield's approach");
  add(
      "--frames", "N",
      [&](const Text& t) { o.frames = parse_whole("--frames", t, 1, kMostFrames); },
      "How many frames. With a path they are spread evenly along it; without one the eye stays and "
      "moving models move. Default: the rows of the path, or 1");
  add(
      "--raster", "WxH", [&](const Text& t) { o.raster = parse_raster("--raster", t); },
      "Elements a line and lines, each 1 to 16384. Default: 1024x1024, or the machine's own");
  look->excludes(attitude);
  path->excludes(eye)->excludes(look)->excludes(attitude);
}

std::vector<PathRow> load_path(const ViewOptions& options) {
  if (!options.path) return {};
  if (*options.path == "builtin")
    return parse_path(embedded_text(embedded_scenes(), "airfield-approach.csv"),
                      "built-in approach");
  return read_path(*options.path);
}

std::vector<FrameView> frame_views(const ViewOptions& options, const std::vector<PathRow>& path,
                                   const Database& database) {
  std::vector<FrameView> frames;
  const double fov = options.fov.value_or(database.view.fov);
  if (path.empty()) {
    const Placement eye = fixed_eye(options, database);
    for (std::size_t i = 0; i < options.frames.value_or(1); ++i)
      frames.push_back({{eye, fov}, static_cast<double>(i)});
    return frames;
  }
  const std::size_t count = options.frames.value_or(path.size());
  for (const double position : even_positions(path.size(), count)) {
    const PathRow row = at_position(path, position);
    frames.push_back({{row.eye, options.fov ? fov : row.fov.value_or(fov)}, position});
  }
  return frames;
}

double eye_reach(const std::vector<FrameView>& views) {
  double reach = 0;
  for (const FrameView& view : views) {
    const Vec3& eye = view.viewpoint.eye.position;
    reach = std::max({reach, std::abs(eye.x), std::abs(eye.y), std::abs(eye.z)});
  }
  return reach;
}

}  // namespace cigsim
