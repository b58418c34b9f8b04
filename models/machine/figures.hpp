// SPDX-License-Identifier: MIT
// The figures of a machine description, one by one: name, unit and range
// (docs/machine/description.md).
#pragma once

#include <type_traits>

#include "models/machine/description.hpp"

namespace cigsim {

/// Names with a dot are grouped by what stands before it.
struct FigureKind {
  const char* name;
  const char* unit;
  double low, high;       ///< both allowed
  bool even = false;      ///< only even numbers
  bool fraction = false;  ///< any number; else a whole one
};

/// Calls f(kind, field) for every figure in the order of the file; `field` is a reference to the
/// description's member, of whatever arithmetic type that has.
template <class Description, class F>
void for_each_figure(Description& machine, F&& f) {
  static_assert(std::is_same_v<std::remove_const_t<Description>, MachineDescription>);
  constexpr double kCycles = 1e9, kItems = 16'777'216, kDepth = 65'536, kRaster = 4'096;
  f(FigureKind{"clock_ns", "ns", 0.001, 1e9, false, true}, machine.clock_ns);
  f(FigureKind{"frame_cycles", "cycles", 0, kCycles}, machine.frame_cycles);
  f(FigureKind{"line_cycles", "cycles", 0, kCycles}, machine.line_cycles);
  f(FigureKind{"raster.width", "elements", 1, kRaster}, machine.raster.width);
  f(FigureKind{"raster.height", "lines", 1, kRaster}, machine.raster.height);
  f(FigureKind{"elements_per_cycle", "elements", 1, kRaster}, machine.elements_per_cycle);
  f(FigureKind{"object_capacity", "items", 0, kItems}, machine.object_capacity);
  f(FigureKind{"face_capacity", "faces", 0, kItems}, machine.face_capacity);
  f(FigureKind{"edge_capacity", "edges", 0, kItems}, machine.edge_capacity);
  f(FigureKind{"crossing_capacity", "crossings", 0, kItems}, machine.crossing_capacity);
  f(FigureKind{"vertex_capacity", "vertices", 0, kItems}, machine.vertex_capacity);
  f(FigureKind{"corner_capacity", "corners", 0, kItems}, machine.corner_capacity);
  f(FigureKind{"hierarchy_depth", "levels", 0, kDepth}, machine.hierarchy_depth);
  f(FigureKind{"links.items", "words", 1, kDepth}, machine.links.items);
  f(FigureKind{"links.edges", "words", 1, kDepth}, machine.links.edges);
  f(FigureKind{"links.faces", "words", 1, kDepth}, machine.links.faces);
  f(FigureKind{"links.crossings", "words", 1, kDepth}, machine.links.crossings);
  f(FigureKind{"links.spans", "words", 1, kDepth}, machine.links.spans);
  f(FigureKind{"formats.coordinate_bits", "bits", 16, 31}, machine.formats.coordinate_bits);
  f(FigureKind{"formats.direction_fraction", "bits", 12, 30}, machine.formats.direction_fraction);
  f(FigureKind{"formats.quotient_fraction", "bits", 8, 30, true},
    machine.formats.quotient_fraction);
  f(FigureKind{"formats.raster_fraction", "bits", 4, 18}, machine.formats.raster_fraction);
  f(FigureKind{"hither", "coordinate units", 1, 1'073'741'824}, machine.hither);
  f(FigureKind{"deadline_margin", "cycles", 0, kCycles}, machine.deadline_margin);
  f(FigureKind{"frame_calculator.frame", "cycles", 0, kCycles}, machine.frame_calculator.frame);
  f(FigureKind{"frame_calculator.sphere", "cycles", 0, kCycles}, machine.frame_calculator.sphere);
  f(FigureKind{"frame_calculator.vertex", "cycles", 0, kCycles}, machine.frame_calculator.vertex);
}

}  // namespace cigsim
