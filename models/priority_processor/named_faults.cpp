// SPDX-License-Identifier: MIT
#include "models/priority_processor/named_faults.hpp"

namespace cigsim::priority_processor {
namespace {

// PP1.
bool eye_on_true_side(const PlaneWords& plane, const ViewWords& view) {
  Accumulator sum = -plane.distance;
  for (int i = 0; i < 3; ++i) sum += Accumulator{plane.normal[i]} * view.eye[i];
  return sum >= 0;
}

}  // namespace

std::vector<ListabilityFault> named_faults(const PriorityHierarchy& hierarchy,
                                           const FaceSet& objects, const ActiveEnvironment& active,
                                           const ViewWords& view, int scale,
                                           const WordFormats& formats,
                                           const std::vector<std::uint32_t>& faults) {
  std::vector<ListabilityFault> named;
  for (const std::uint32_t f : faults) {
    const ActiveGroup& at = active.groups[f];
    const Group& group = hierarchy.groups[at.group];
    std::uint64_t eye_true = 0;
    for (std::uint32_t n = 0; n < group.node_count; ++n) {
      const Plane& plane = hierarchy.planes[hierarchy.nodes[group.first_node + n].plane];
      if (eye_on_true_side(plane_words(plane, scale, formats), view))
        eye_true |= std::uint64_t{1} << n;
    }
    named.push_back(listability_fault(hierarchy, objects, at.group, at.active, eye_true));
  }
  return named;
}

}  // namespace cigsim::priority_processor
