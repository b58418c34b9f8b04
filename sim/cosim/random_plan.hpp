// SPDX-License-Identifier: MIT
// Random frames for comparisons: seeded scenes of all kinds that `cigsim generate` knows, seen from
// anywhere, on a small raster, with memories that overflow and waits on every link.
#pragma once

#include "sim/cosim/plan.hpp"

namespace cigsim::cosim {

/// `frames` of them. The same seed gives the same plan; `seed` is not 0.
ComparePlan random_plan(std::uint32_t seed, OverloadPolicy policy, std::size_t frames,
                        const std::vector<Stage>& stages);

}  // namespace cigsim::cosim
