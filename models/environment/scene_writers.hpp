// SPDX-License-Identifier: MIT
// The writers behind write_environment.
#pragma once

#include <ostream>

#include "models/environment/emitter.hpp"
#include "models/environment/environment.hpp"

namespace cigsim {

/// The project's own format, as JSON or CBOR by the emitter. Throws std::invalid_argument when an
/// object or model refers to a model or system that is not there, for what check_choices() refuses,
/// and when the objects of a choice are not all together, description after description.
void write_scene(const Environment& environment, Emitter& out);

/// Wavefront OBJ: one `o` line an object, coordinates in the environment's axes (a moving system
/// stands where its first key says). A face's colour is its material's name, `rgb_RRGGBB`, and
/// `rgb_none` takes it back, so that one file says everything. Of a choice it has the most detailed
/// description; objects of the others are empty.
void write_obj(const Environment& environment, std::ostream& out);

}  // namespace cigsim
