// SPDX-License-Identifier: MIT
// The right pictures: what a frame shows when nothing is rounded and nothing is left out.
#pragma once

#include <functional>
#include <vector>

#include "sim/functional_machine.hpp"
#include "sim/measure/picture_error.hpp"
#include "sim/view.hpp"

namespace cigsim {

/// The number type whose pictures are the exact ones, at the least cost.
NumberType exact_number();

/// Exact, of the most detailed descriptions, for each view; whatever the host. `progress`, when
/// there is one, is told the share that is done. `number` is exact_number(), or kExact to check
/// that. Throws std::invalid_argument as FunctionalMachine.
std::vector<ReferencePicture> reference_pictures(const Database& database,
                                                 const std::vector<FrameView>& views,
                                                 const Raster& raster,
                                                 const std::function<void(double)>& progress = {},
                                                 NumberType number = exact_number());

}  // namespace cigsim
