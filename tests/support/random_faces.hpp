// SPDX-License-Identifier: MIT
// Random memories and views in machine words for the geometry processor: sensible bodies ahead of
// the eyepoint beside degenerate, tiny and huge ones, such as lie behind it, at it, or all round.
#pragma once

#include <algorithm>
#include <cmath>

#include "models/environment/random.hpp"
#include "models/geometry_processor/memory.hpp"

namespace cigsim::test {

class RandomFaces {
 public:
  RandomFaces(Random& random, const MachineDescription& machine)
      : random_(random), formats_(machine.formats), view_{} {
    view_.raster = machine.raster;
    for (Word& e : view_.eye) e = coordinate(std::ldexp(random_.between(-1, 1), bits() - 1));
    const bool wild = random_.below(4) == 0;
    const double h = random_.between(-4, 4), p = random_.between(-2, 2);
    const double rows[3][3] = {
        {std::cos(h) * std::cos(p), std::sin(h) * std::cos(p), std::sin(p)},
        {std::sin(h), -std::cos(h), 0},
        {-std::cos(h) * std::sin(p), -std::sin(h) * std::sin(p), std::cos(p)}};
    const double factors[3] = {random_.between(0.1, 1), random_.between(0.1, 1),
                               random_.between(0.1, 1)};
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        axes_[r][c] = rows[r][c];
        view_.matrix[r][c] = direction(wild ? random_.between(-2, 2) : factors[r] * rows[r][c]);
      }
  }

  const ViewWords& view() const { return view_; }

  /// A set of `items` items.
  geometry_processor::FaceMemory memory(std::uint32_t items) {
    geometry_processor::FaceMemory memory;
    for (std::uint32_t i = 0; i < items; ++i) add_item(memory);
    return memory;
  }

 private:
  int bits() const { return formats_.coordinate_bits; }
  Word coordinate(double value) const {
    const double limit = std::ldexp(1, bits() - 1);
    return static_cast<Word>(std::clamp(std::floor(value), -limit, limit - 1));
  }
  Word direction(double value) const {
    return static_cast<Word>(std::ldexp(
        std::floor(std::ldexp(std::clamp(value, -1.0, 1.0), formats_.direction_fraction)),
        kDirectionFraction - formats_.direction_fraction));
  }
  double size() {
    return std::ldexp(random_.between(0.5, 1),
                      1 + static_cast<int>(random_.below(static_cast<std::uint64_t>(bits()))));
  }

  void add_item(geometry_processor::FaceMemory& memory) {
    const std::uint32_t kind = random_.below(6);
    const auto put = [](std::vector<Word>& words, std::size_t value) {
      words.push_back(static_cast<Word>(value));
    };
    const std::uint32_t vertices = 1 + random_.below(9), faces = 1 + random_.below(7);
    put(memory.items, memory.faces.size());
    put(memory.items, faces);
    put(memory.items, memory.vertices.size());
    put(memory.items, vertices);
    const double away = kind == 0 ? 0 : size(), wide = kind < 3 ? size() : away * 1.5;
    for (std::uint32_t v = 0; v < vertices; ++v) {
      if (v > 0 && random_.below(16) == 0) {  // the one before again
        for (int axis = 0; axis < 3; ++axis)
          memory.vertices.push_back(Word{memory.vertices[memory.vertices.size() - 3]});
        continue;
      }
      const bool at_eye = random_.below(60) == 0;
      for (int axis = 0; axis < 3; ++axis)
        memory.vertices.push_back(
            at_eye ? view_.eye[axis]
                   : coordinate(view_.eye[axis] + away * axes_[0][axis] +
                                wide * random_.between(-1, 1) / (kind == 5 ? 20 : 1)));
    }
    for (std::uint32_t f = 0; f < faces; ++f) add_face(memory, vertices);
  }

  void add_face(geometry_processor::FaceMemory& memory, std::uint32_t vertices) {
    const std::uint32_t corners = 3 + random_.below(random_.below(8) == 0 ? 20 : 3);
    memory.faces.push_back(static_cast<Word>(memory.corners.size()));
    memory.faces.push_back(static_cast<Word>(corners));
    const bool none = random_.below(20) == 0;
    for (int axis = 0; axis < 3; ++axis)
      memory.faces.push_back(none ? 0 : direction(random_.between(-1, 1)));
    memory.faces.push_back(random_.below(2) != 0);
    memory.faces.push_back(static_cast<Word>(random_.below(70000)));
    memory.faces.push_back(static_cast<Word>(random_.below(1u << 24)));
    for (std::uint32_t c = 0; c < corners; ++c)
      memory.corners.push_back(static_cast<Word>(random_.below(vertices)));
  }

  Random& random_;
  const WordFormats formats_;
  ViewWords view_;
  double axes_[3][3] = {};
};

/// A machine with words of random widths, and now and then with capacities and a frame time.
inline MachineDescription random_machine(Random& random) {
  MachineDescription machine;
  const auto number = [&](std::uint32_t least, std::uint32_t most) {
    return static_cast<int>(least + random.below(most - least + 1));
  };
  if (random.below(2)) {
    machine.formats.coordinate_bits = number(16, 31);
    machine.formats.direction_fraction = number(12, 30);
    machine.formats.quotient_fraction = 2 * number(4, 15);
    machine.formats.raster_fraction = number(4, 18);
  }
  machine.hither = number(1, random.below(2) ? 4 : 1000);
  machine.raster = {number(1, random.below(2) ? 64 : 8191), number(1, random.below(2) ? 64 : 8191)};
  if (random.below(3) == 0) machine.edge_capacity = 3 + random.below(100);
  if (random.below(3) == 0) machine.face_capacity = 1 + random.below(30);
  if (random.below(3) == 0) machine.frame_cycles = 100 + random.below(20000);
  machine.deadline_margin = random.below(100);
  return machine;
}

}  // namespace cigsim::test
