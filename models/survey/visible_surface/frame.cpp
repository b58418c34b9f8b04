// SPDX-License-Identifier: MIT
#include "models/survey/visible_surface/frame.hpp"

#include <utility>

#include "models/frame_calculator/functional.hpp"
#include "models/priority_processor/functional.hpp"

namespace cigsim::survey {
namespace {

// Planes with members in view on both sides.
std::uint64_t plane_tests(const PriorityHierarchy& hierarchy, const ActiveEnvironment& active) {
  std::uint64_t count = 0;
  for (const ActiveGroup& at : active.groups) {
    const Group& group = hierarchy.groups[at.group];
    for (std::uint32_t n = group.first_node; n < group.first_node + group.node_count; ++n)
      count += (hierarchy.nodes[n].true_members & at.active) != 0 &&
               (hierarchy.nodes[n].false_members & at.active) != 0;
  }
  return count;
}

}  // namespace

Frame make_frame(const Database& database, const Viewpoint& viewpoint, const Raster& raster,
                 double frame) {
  const PreparedSystem& environment = database.systems[0];
  ActiveEnvironment active;
  FaceSet moving;
  frame_calculator::Functional(database).compute(viewpoint, raster, frame, active, moving);
  PriorityList priority;
  priority_processor::Functional<Exact>(priority_processor::Method::kCounters)
      .compute(environment.hierarchy, environment.set, active, database.ground, priority);
  const FaceSet* const sets[3] = {&environment.set, &moving, &database.ground};
  Frame out{make_face_list(active.view, sets, priority.items), std::move(priority.faults)};
  out.list.plane_tests = plane_tests(environment.hierarchy, active);
  return out;
}

}  // namespace cigsim::survey
