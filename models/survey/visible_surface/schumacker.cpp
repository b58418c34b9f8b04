// SPDX-License-Identifier: MIT
// Schumacker 1969, as Sandor 1979 (sec. 5.2) tells it: the eyepoint's sides of the separating
// planes put the clusters in order, the order of faces within a cluster is fixed in the database,
// and on each line the face of highest priority between its two edges is shown. No depth is
// computed. Clusters and planes are those of the project's own priority processor.
#include "models/priority_resolver/active_list.hpp"
#include "models/survey/visible_surface/scan_line.hpp"

namespace cigsim::survey {

void schumacker(const FaceList& list, FacePicture& out, Work& work) {
  out.clear(list.raster);
  std::vector<std::uint32_t> priority(list.faces.size());
  for (std::uint32_t k = 0; k < list.priority.size(); ++k) priority[list.priority[k]] = k;
  work.comparisons += list.plane_tests;
  ++work.sorts;  // of the clusters
  ScanLines lines(list, XSort::kBubble, work);
  priority_resolver::ActiveList active;
  active.grow(list.faces.size());
  for (int r = 0; r < list.raster.height; ++r) {
    lines.next();
    const std::vector<LineEdge>& edges = lines.edges();
    for (std::size_t i = 0; i < edges.size();) {
      const int element = edges[i].element;
      for (; i < edges.size() && edges[i].element == element; ++i)
        active.pass(priority[edges[i].face], edges[i].left);
      const std::uint32_t first = active.first();
      if (first == kNone || i == edges.size()) continue;
      ++work.segments;
      out.fill(r, element, edges[i].element, list.priority[first], work);
    }
    active.clear();
  }
}

}  // namespace cigsim::survey
