// SPDX-License-Identifier: MIT
// Where the eye stands, frame by frame: the command's view options.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "sim/path.hpp"

namespace cigsim {

struct Attitude {
  double heading = 0, pitch = 0, roll = 0;
};

/// As given on the command line. Eye, look_at and attitude exclude a path.
struct ViewOptions {
  std::optional<Vec3> eye, look_at;
  std::optional<Attitude> attitude;
  std::optional<double> fov;
  std::optional<std::string> path;  ///< a file, or "builtin"
  std::optional<std::size_t> frames;
  std::optional<Raster> raster;
};

void add_view_options(CLI::App& command, ViewOptions& options);

/// One frame to compute.
struct FrameView {
  Viewpoint viewpoint;
  double position = 0;  ///< the frame at which moving models stand: place on the path in rows
};

/// The path that the options name. Empty without one. Throws InputError.
std::vector<PathRow> load_path(const ViewOptions& options);

/// The largest coordinate, either way, of the frames' eyepoints.
double eye_reach(const std::vector<FrameView>& views);

/// The frames, at least one. What the options leave open comes from the scene: an eye without a
/// direction looks at the centre of the scene (north, if it stands there), and no eye at all is the
/// scene's own view. Throws UsageError.
std::vector<FrameView> frame_views(const ViewOptions& options, const std::vector<PathRow>& path,
                                   const Database& database);

}  // namespace cigsim
