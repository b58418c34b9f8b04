// SPDX-License-Identifier: MIT
#include "models/edge_orderer/functional.hpp"

namespace cigsim::edge_orderer {
namespace {

EdgeWord edge_word(const Edge<MachineWord>& edge, std::uint32_t face) {
  EdgeWord word;
  word.face = face;
  word.first_line = static_cast<std::uint16_t>(edge.first_line);
  word.end_line = static_cast<std::uint16_t>(edge.end_line);
  word.left = edge.left;
  word.x = edge.x.raw;
  word.slope = edge.slope.raw;
  return word;
}

}  // namespace

Figures Functional<MachineWord>::compute(const EdgeList<MachineWord>& edges, const Raster& raster,
                                         OrderedCrossings& out) {
  EdgeBank bank(raster.height);
  for (std::uint32_t f = 0; f < edges.faces.size(); ++f) {
    const RasterFace& face = edges.faces[f];
    for (std::uint32_t e = face.first_edge; e < face.first_edge + face.edge_count; ++e)
      bank.add(edge_word(edges.edges[e], f));
  }
  LineOrderer orderer(raster.width, capacity_, policy_);
  orderer.begin(bank);
  out.crossings.clear();
  out.first.assign(1, 0);
  out.limit.clear();
  for (int r = 0; r < raster.height; ++r) {
    const OrderedLine& line = orderer.next();
    line.for_each_kept([&](const ActiveEdge& edge) {
      out.crossings.push_back({edge.face(), edge.element(), edge.left()});
    });
    out.first.push_back(static_cast<std::uint32_t>(out.crossings.size()));
    out.limit.push_back(line.cut ? line.cut_element : static_cast<std::uint16_t>(raster.width));
  }
  return orderer.figures();
}

}  // namespace cigsim::edge_orderer
