// SPDX-License-Identifier: MIT
// Stages and levels of fidelity: which exist, and which a run has chosen.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace cigsim {

enum class Stage {
  kFrameCalculator,
  kPriorityProcessor,
  kGeometryProcessor,
  kEdgeOrderer,
  kPriorityResolver,
  kVideoProcessor
};
inline constexpr std::size_t kStageCount = 6;
inline constexpr std::array<Stage, kStageCount> kAllStages{
    Stage::kFrameCalculator, Stage::kPriorityProcessor, Stage::kGeometryProcessor,
    Stage::kEdgeOrderer,     Stage::kPriorityResolver,  Stage::kVideoProcessor};

enum class Level {
  kFunctional,  ///< results without time
  kTimed,       ///< exact cycles by arithmetic on transactions
  kClocked,     ///< cycle by cycle, with pins
  kRtl          ///< SystemVerilog through Verilator
};
inline constexpr std::array kAllLevels{Level::kFunctional, Level::kTimed, Level::kClocked,
                                       Level::kRtl};

std::string_view name_of(Stage stage);
std::string_view name_of(Level level);

/// A stage by its name. `what` names the argument in the message. Throws UsageError.
Stage parse_stage(std::string_view what, std::string_view text);

bool exists(Stage stage, Level level);

/// Has pins that change with a clock.
inline bool has_pins(Level level) { return level == Level::kClocked || level == Level::kRtl; }

/// A level for each stage: all functional, or none.
class LevelChoice {
 public:
  LevelChoice() { levels_.fill(Level::kFunctional); }

  /// From the text of --level: one level for all stages (a stage without that level takes the
  /// nearest simpler one), or STAGE=LEVEL,… with the other stages timed. Throws UsageError.
  static LevelChoice parse(const std::string& text);

  Level operator[](Stage stage) const { return levels_[static_cast<std::size_t>(stage)]; }
  Level& operator[](Stage stage) { return levels_[static_cast<std::size_t>(stage)]; }
  bool functional() const { return levels_.front() == Level::kFunctional; }
  /// "timed", or "geometry_processor=clocked,…" naming the stages that are not timed.
  std::string text() const;
  friend bool operator==(const LevelChoice&, const LevelChoice&) = default;

 private:
  std::array<Level, kStageCount> levels_;
};

}  // namespace cigsim
