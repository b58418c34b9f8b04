// SPDX-License-Identifier: MIT
// OFF (Object File Format, Geomview): one mesh, polygons of any number of corners.
#pragma once

#include <ostream>

#include "models/environment/environment.hpp"

namespace cigsim {

/// All objects as one mesh, coordinates as the objects have them, in the shortest form that reads
/// back as the same doubles. Colours, names, coordinate systems and ground are not kept.
void write_off(const Environment& environment, std::ostream& out);

}  // namespace cigsim
