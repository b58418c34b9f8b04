// SPDX-License-Identifier: MIT
// What a comparison runs: frames of databases through a machine with stages of RTL. All of it
// together reproduces a run, and it is what a replay file holds.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "models/boundary/stuck_bit.hpp"
#include "models/database/database.hpp"
#include "models/machine/description.hpp"
#include "sim/level.hpp"
#include "sim/rtl/variant.hpp"
#include "sim/view.hpp"

namespace cigsim::cosim {

struct PlannedFrame {
  std::size_t database = 0;  ///< into ComparePlan::databases
  FrameView view;
};

struct ComparePlan {
  std::string name;  ///< of the scene, or of what else is compared
  std::vector<std::shared_ptr<const Database>> databases;
  std::vector<PlannedFrame> frames;
  MachineDescription description;
  OverloadPolicy overload = OverloadPolicy::kDrop;
  double eye_reach = 0;
  std::vector<Stage> stages;            ///< at the RTL level
  std::vector<RtlVariant> variants;     ///< a stage each
  std::uint32_t seed = 1;               ///< of registers without reset, not 0
  std::optional<std::uint64_t> stalls;  ///< seed of random waits on all links
  std::optional<std::pair<Stage, StuckBit>> stuck;
};

/// Sizes that hold the plan's databases.
void choose_variants(ComparePlan& plan);

}  // namespace cigsim::cosim
