// SPDX-License-Identifier: MIT
// The six stages at the functional level, assembled: a viewpoint goes in, a picture comes out.
#pragma once

#include <cstdint>
#include <memory>

#include "models/boundary/transactions.hpp"
#include "models/database/database.hpp"
#include "models/machine/description.hpp"
#include "models/priority_processor/group_order.hpp"
#include "sim/frame_faces.hpp"
#include "sim/frame_stats.hpp"

namespace cigsim {

enum class NumberType { kFloat, kDouble, kMachine, kCertified, kExact };
using PriorityMethod = priority_processor::Method;
enum class ResolverMethod {
  kAuto,       ///< painter or coverage, by how much the frame's faces overlap
  kPainter,    ///< faces from the lowest priority up, each over those before it; no spans
  kCoverage,   ///< faces in priority order against a coverage mask a line: same spans, less work
  kActiveList  ///< the machine's own: crossings in element order and a list of active faces
};

struct MachineOptions {
  NumberType number = NumberType::kDouble;
  PriorityMethod priority = PriorityMethod::kCounters;
  ResolverMethod resolver = ResolverMethod::kAuto;
  Raster raster;
  MachineDescription description;  ///< for NumberType::kMachine; its raster is `raster`
  OverloadPolicy overload = OverloadPolicy::kDrop;
  double eye_reach = 0;  ///< for NumberType::kMachine: as coordinate_scale()
  /// What the thresholds of levels of detail are multiplied by; 0: the most detailed throughout.
  double detail = 1;
  /// Only what spheres against the pyramid of vision leave is active; false: everything is. Not on
  /// machine words.
  bool retrieval = true;
  /// Orders of groups are kept while the eyepoint crosses no plane of theirs. The same lists either
  /// way. Not on machine words.
  bool coherence = true;
};

/// Keeps its working memory from frame to frame. One thread.
class FunctionalMachine {
 public:
  /// The database must outlive the machine. Throws std::invalid_argument for a raster outside
  /// 1 x 1 .. 16384 x 16384.
  FunctionalMachine(const Database& database, const MachineOptions& options);
  ~FunctionalMachine();
  FunctionalMachine(FunctionalMachine&&) noexcept;

  /// Computes one frame. `frame` places the moving models. The picture is valid until the next
  /// call.
  const Picture& compute(const Viewpoint& viewpoint, double frame);
  /// Figures of the last frame. Those that its method had no need of (the spans, with the painter)
  /// are worked out at the first call, outside the times.
  const FrameStats& stats() const;
  /// What the edges of the last frame's faces cross.
  FrameFaces faces() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// The attitude that looks from `eye` to `target`, without roll. Looking straight up or down keeps
/// heading 0. Throws std::invalid_argument when the two coincide.
Placement look_at(const Vec3& eye, const Vec3& target);

}  // namespace cigsim
