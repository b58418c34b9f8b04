// SPDX-License-Identifier: MIT
// The writers behind write_environment.
#pragma once

#include <ostream>

#include "models/environment/emitter.hpp"
#include "models/environment/environment.hpp"

namespace cigsim {

/// The project's own format, as JSON or CBOR by the emitter. Throws std::invalid_argument when an
/// object or model refers to a model or system that is not there.
void write_scene(const Environment& environment, Emitter& out);

/// Wavefront OBJ: one `o` line an object, coordinates in the environment's axes (a moving system
/// stands where its first key says). A face's colour is its material's name, `rgb_RRGGBB`, and
/// `rgb_none` takes it back, so that one file says everything.
void write_obj(const Environment& environment, std::ostream& out);

}  // namespace cigsim
