// SPDX-License-Identifier: MIT
// Only what a scene requires, shown: each economy of the machine beside the same without it, over
// the same frames, in turns, with the time, the memory and the work that it saves.
//
// An economy changes the work, not the picture: where the two pictures differ and it is not one
// that trades them, the experiment has failed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/experiments/so_steps.hpp"
#include "sim/measure/interleave.hpp"
#include "sim/measure/setting.hpp"
#include "sim/view.hpp"

namespace cigsim {

struct EconomyOptions {
  std::size_t frames = 60;  ///< of a scene; at levels that know time a tenth of them
  Raster raster{1024, 1024};
  std::size_t rounds = 5;
  std::uint64_t seed = 1;  ///< of the order of the trials
  double limit_s = 600;    ///< for one trial
  /// Told the share of the scene's work that is done, and what comes next.
  std::function<void(double, const std::string&)> progress;
};

/// One economy of a scene, to be measured.
struct Economy {
  std::string name;           ///< "retrieval"
  std::string with, without;  ///< in words: "spheres", "everything active"
  Setting setting_with, setting_without;
  /// The scene's own, or one from which an attribute was taken.
  const Database *database_with = nullptr, *database_without = nullptr;
  bool same_pictures = true;  ///< else they may differ, and the difference is what is traded
  bool same_cycles = false;   ///< delays too
  /// The stage on which it tells, by the name of its time.
  std::optional<std::pair<Stage, double StageTimes::*>> stage = {};
};

/// Work that is counted, summed over the frames.
struct EconomyCount {
  std::string what;  ///< "planes tested"
  std::uint64_t with = 0, without = 0;
};

struct EconomySide {
  Spread frame_ms, memory_mib;
  Spread stage_ms;  ///< mean of a frame; where the economy names a stage
  /// Of each round, in its order: all its pictures, and the delays of its frames.
  std::vector<std::uint64_t> digests;
  std::vector<std::vector<Cycle>> delays;
};

struct EconomyResult {
  Economy economy;
  std::size_t frames = 0;
  EconomySide with, without;
  std::vector<EconomyCount> counts;  ///< at the functional level
  /// Elements of all pictures, and those that differ in colour or number; at levels that know time
  /// they are not counted.
  std::uint64_t elements = 0, differing = 0;

  /// Rounds of either side with a picture, and those with a delay, that is not the one of the first
  /// round without: of that side's own first round where pictures may differ; delays only where
  /// they must be the same.
  std::size_t wrong_rounds() const;
  /// Pictures and cycles are the same where they have to be.
  bool holds() const { return (!economy.same_pictures || differing == 0) && wrong_rounds() == 0; }
  /// Share of the time that is saved, negative where it costs.
  double saved() const {
    return without.frame_ms.median > 0 ? 1 - with.frame_ms.median / without.frame_ms.median : 0;
  }
};

/// A scene and its frames.
struct EconomyScene {
  std::string name;
  const Database* database = nullptr;
  std::vector<FrameView> views;
};

/// The frames of a slow flight past the scene's own view: an eye that moves sideways, a thousandth
/// of the way to the scene's centre at a time.
std::vector<FrameView> slow_flight(const Database& database, std::size_t frames);

/// Databases from which attributes were taken; what an Economy points to.
struct LeanDatabases {
  std::optional<Database> without_moving, without_ground;
};

/// The economies that tell on a scene: of stages, retrieval and coherence always; of levels of
/// detail, moving models and the ground where it has them. Throws UsageError for a raster that the
/// machine cannot have.
std::vector<Economy> economies_of(const EconomyScene& scene, const EconomyOptions& options,
                                  LeanDatabases& lean);

/// Measures one. Throws MeasureError.
EconomyResult run_economy(const Economy& economy, const EconomyScene& scene,
                          const EconomyOptions& options);

/// All of a scene's.
struct SceneEconomies {
  EconomyScene scene;
  std::vector<EconomyResult> results;
  SoSteps so;

  bool holds() const;
};
SceneEconomies run_economies(const EconomyScene& scene, const EconomyOptions& options);

}  // namespace cigsim
