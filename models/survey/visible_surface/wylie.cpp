// SPDX-License-Identifier: MIT
// Wylie, Romney, Evans and Erdahl 1967, as Sandor 1979 (sec. 5.2) tells it: edges sorted by line,
// crossings by element (into buckets), and one depth comparison a span for each further face there,
// since faces are taken not to pass through each other. Depth coherence: while a line has the
// crossings of the line before in the same order, its spans show the same faces, and no depth is
// compared. Crossings that share an element count as in order only if they share it on both lines.
#include "models/survey/visible_surface/depth_order.hpp"
#include "models/survey/visible_surface/scan_line.hpp"

namespace cigsim::survey {
namespace {

// Where groups of crossings at one element end: with the order, all that decides the spans.
void groups_of(const std::vector<LineEdge>& edges, std::vector<bool>& ends) {
  ends.resize(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
    ends[i] = i + 1 == edges.size() || edges[i + 1].element != edges[i].element;
}

}  // namespace

void wylie(const FaceList& list, FacePicture& out, Work& work) {
  out.clear(list.raster);
  const DepthOrder order(list);
  ScanLines lines(list, XSort::kDistribution, work);
  ActiveFaces active(list.faces.size());
  std::vector<bool> groups, groups_before;
  std::vector<std::uint32_t> seen;  // by span, of this line or the one before
  for (int r = 0; r < list.raster.height; ++r) {
    lines.next();
    groups_before.swap(groups);
    groups_of(lines.edges(), groups);
    work.comparisons += lines.edges().size();
    const bool coherent = lines.same_order() && groups == groups_before;
    if (!coherent) seen.clear();
    std::size_t span = 0;
    for_each_span(lines.edges(), active,
                  [&](int first, int end, const std::vector<std::uint32_t>& faces) {
                    if (!coherent) {
                      std::uint32_t best = faces.front();
                      for (std::size_t i = 1; i < faces.size(); ++i) {
                        ++work.depths;
                        if (order.nearer(faces[i], best, first, r)) best = faces[i];
                      }
                      seen.push_back(best);
                    }
                    ++work.segments;
                    out.fill(r, first, end, seen[span++], work);
                  });
  }
  work.exact_tests += order.exact_tests();
}

}  // namespace cigsim::survey
