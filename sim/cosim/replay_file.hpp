// SPDX-License-Identifier: MIT
// Replay files: a mismatch with all that reproduces it, as JSON.
#pragma once

#include <filesystem>
#include <optional>
#include <variant>

#include "models/boundary/mismatch.hpp"
#include "sim/cosim/plan.hpp"
#include "sim/cosim/so_vectors.hpp"

namespace cigsim::cosim {

/// A case of the SO engine.
struct SoReplay {
  SoCase inputs;
  std::uint32_t seed = 1;
  std::optional<SoStuckBit> stuck;
  std::string difference;  ///< what was seen
};

/// Frames through the machine.
struct FrameReplay {
  ComparePlan plan;
  Mismatch mismatch;  ///< what was seen
};

using Replay = std::variant<FrameReplay, SoReplay>;

/// Throws InputError when it cannot be written.
void write_replay(const Replay& replay, const std::filesystem::path& file);

/// Throws InputError (file, line where known, what, what to do) when it is no replay file.
Replay read_replay(const std::filesystem::path& file);

}  // namespace cigsim::cosim
