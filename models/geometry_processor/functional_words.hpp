// SPDX-License-Identifier: MIT
// Geometry processor, functional level on machine words (docs/machine/geometry_processor.md): the
// bit-true model of the timed and the clocked level. Without time there is no deadline.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "models/geometry_processor/face_walk.hpp"

namespace cigsim::geometry_processor {

class FunctionalWords {
 public:
  /// Takes capacities, formats and the hither distance of `machine`.
  explicit FunctionalWords(const MachineDescription& machine) : walk_(machine, pace_) {}
  FunctionalWords(const FunctionalWords&) = delete;
  FunctionalWords& operator=(const FunctionalWords&) = delete;

  /// The faces and edges of the items up to the end word (or the span's end). A face's number is
  /// its place in `out.faces`. `figures` is set, all but the frame and its activity.
  void compute(const GeometryBank& bank, std::span<const ItemWord> items,
               EdgeList<MachineWord>& out, Figures& figures) {
    out.faces.clear();
    out.edges.clear();
    figures = {};
    pace_.items = items;
    pace_.out = &out;
    walk_.run(bank, figures);
  }

 private:
  struct Pace {
    void spend(Step, std::size_t = 1) {}
    bool late() const { return false; }
    ItemWord take() {
      if (items.empty()) return {SetId::kStatic, 0, true};
      const ItemWord word = items.front();
      items = items.subspan(1);
      return word;
    }
    void edge(const EdgeWord& e) {
      out->edges.push_back({e.first_line, e.end_line, e.left, {e.x}, {e.slope}});
    }
    void face(const FaceWord& word) {
      RasterFace face;
      face.object = word.object;
      face.colour = {static_cast<std::uint8_t>(word.colour),
                     static_cast<std::uint8_t>(word.colour >> 8),
                     static_cast<std::uint8_t>(word.colour >> 16)};
      if (!out->faces.empty())
        face.first_edge = out->faces.back().first_edge + out->faces.back().edge_count;
      face.edge_count = static_cast<std::uint32_t>(out->edges.size()) - face.first_edge;
      measure(face);
      out->faces.push_back(face);
    }
    /// The lines that the face covers, and its area from where its edges are in the middle.
    void measure(RasterFace& face) const {
      const auto edges = std::span(out->edges).subspan(face.first_edge);
      face.first_line = edges.front().first_line;
      double area = 0;
      for (const Edge<MachineWord>& e : edges) {
        face.first_line = std::min(face.first_line, e.first_line);
        face.end_line = std::max(face.end_line, e.end_line);
        const double lines = e.end_line - e.first_line;
        const double strip = lines * (to_double(e.x) + to_double(e.slope) * (lines - 1) / 2);
        area += e.left ? -strip : strip;
      }
      face.area = static_cast<float>(std::abs(area));
    }

    std::span<const ItemWord> items;
    EdgeList<MachineWord>* out = nullptr;
  };

  Pace pace_;
  FaceWalk<Pace> walk_;
};

}  // namespace cigsim::geometry_processor
