// SPDX-License-Identifier: MIT
// The sweeps of the growth experiment (growth.hpp), one by one.
#pragma once

#include <memory>

#include "models/database/database.hpp"
#include "sim/experiments/growth.hpp"
#include "sim/functional_machine.hpp"

namespace cigsim {

/// A scene of a sweep, its machine, and what was measured of it.
struct GrowthSubject {
  double x = 0;
  std::shared_ptr<const Database> database;
  Viewpoint viewpoint;
  MachineOptions machine;
  std::vector<FrameStats> frames = {};  ///< one a round
  double preparation_s = 0;
};

/// Frames of all subjects in `rounds` rounds of random order; each is measured after one that is
/// not, so that it finds its machine warm. Times are the processor's, so that what other programs
/// take of the host meanwhile does not count; a stage has the share that it has of the frame's.
void measure_frames(std::vector<GrowthSubject>& subjects, std::size_t rounds, std::uint64_t seed);

/// A curve's points from the frames of a sweep.
std::vector<GrowthPoint> frame_points(const std::vector<GrowthSubject>& subjects,
                                      const std::function<double(const FrameStats&)>& value);

/// Whether all subjects, of one or more, show the same: colours, and the numbers of the first
/// `in_view` objects.
bool same_views(const std::vector<GrowthSubject>& subjects, std::uint32_t in_view);

/// Bytes of everything in a prepared database that grows with its scene.
double database_bytes(const Database& database);

std::vector<GrowthCurve> grow_out_of_view(const GrowthOptions& options, bool& same_pictures);
std::vector<GrowthCurve> grow_in_view(const GrowthOptions& options);
std::vector<GrowthCurve> grow_planes(const GrowthOptions& options);
std::vector<GrowthCurve> grow_edges(const GrowthOptions& options);
std::vector<GrowthCurve> grow_raster(const GrowthOptions& options);

}  // namespace cigsim
