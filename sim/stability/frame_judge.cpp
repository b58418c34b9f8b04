// SPDX-License-Identifier: MIT
#include "sim/stability/frame_judge.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "models/frame_calculator/functional.hpp"
#include "models/frame_calculator/memory_loader.hpp"
#include "models/priority_processor/functional.hpp"
#include "models/priority_processor/functional_words.hpp"
#include "sim/stability/directions.hpp"
#include "sim/stability/edge_distance.hpp"
#include "sim/stability/shown_faces.hpp"
#include "sim/stability/sight.hpp"

namespace cigsim::stability {
MachineOptions options_for(const Format& format, const Raster& raster, double eye_reach) {
  MachineOptions options;
  options.raster = raster;
  options.eye_reach = eye_reach;
  switch (format.arithmetic) {
    case Arithmetic::kFloat:
      options.number = NumberType::kFloat;
      break;
    case Arithmetic::kDouble:
      options.number = NumberType::kDouble;
      break;
    case Arithmetic::kMachine:
      options.number = NumberType::kMachine;
      options.resolver = ResolverMethod::kActiveList;
      options.description = with_raster(machine_preset("unlimited"), raster);
      options.description.formats = format.machine.formats;
      options.description.hither = format.machine.hither;
      break;
    case Arithmetic::kCertified:
      options.number = NumberType::kCertified;
      break;
    case Arithmetic::kExact:
      options.number = NumberType::kExact;
      break;
  }
  return options;
}

ExactFrame::ExactFrame(const Database& database, const Viewpoint& viewpoint, const Raster& raster,
                       double position)
    : database_(database), viewpoint_(viewpoint), raster_(raster), position_(position) {
  frame_calculator::Functional(database).compute(viewpoint, raster, position, active_, moving_);
  const PreparedSystem& system = database.systems[0];
  priority_processor::Functional<Exact> priority(PriorityMethod::kCounters);
  priority.compute(system.hierarchy, system.set, active_, database.ground, list_);
  MachineOptions options;
  options.number = NumberType::kExact;
  options.raster = raster;
  picture_ = FunctionalMachine(database, options).compute(viewpoint, position);
  judge_sides();
}

// The exact list, and those of doubles, come of side(): it is held against the planes' polynomials.
void ExactFrame::judge_sides() {
  const Vec3& eye = active_.view.eye;
  const PriorityHierarchy& hierarchy = database_.systems[0].hierarchy;
  for (const ActiveGroup& in_view : active_.groups) {
    const Group& group = hierarchy.groups[in_view.group];
    for (std::uint32_t n = group.first_node; n < group.first_node + group.node_count; ++n) {
      const Plane& plane = hierarchy.planes[hierarchy.nodes[n].plane];
      wrong_sides_ += side(plane, eye) != exact_side(plane.exact, eye);
    }
  }
  for (const ItemRef& ref : list_.items) {
    const FaceSet& from = *sets()[static_cast<std::size_t>(ref.set)];
    const Item& item = from.items[ref.item];
    for (std::uint32_t f = item.first_face; f < item.first_face + item.face_count; ++f)
      facings_.push_back(exact_side(from.planes[from.faces[f].plane].exact, eye));
  }
}

std::array<const FaceSet*, 3> ExactFrame::sets() const {
  return {&database_.systems[0].set, &moving_, &database_.ground};
}

double ExactFrame::eye_reach() const { return largest_coordinate(viewpoint_.eye.position); }

FrameFaults ExactFrame::judge(const Format& format) const {
  FrameFaults faults;
  switch (format.arithmetic) {
    case Arithmetic::kFloat:
      compare_decisions<float>(faults);
      break;
    case Arithmetic::kDouble:
      compare_decisions<double>(faults);
      break;
    case Arithmetic::kCertified:
      compare_decisions<Certified>(faults);
      break;
    case Arithmetic::kMachine:
      compare_words(format, faults);
      break;
    case Arithmetic::kExact:
      compare_decisions<Exact>(faults);
      break;
  }
  compare_pictures(format, faults);
  return faults;
}

void ExactFrame::compare_pictures(const Format& format, FrameFaults& faults) const {
  FunctionalMachine machine(database_, options_for(format, raster_, eye_reach()));
  const Picture& got = machine.compute(viewpoint_, position_);
  for (std::size_t i = 0; i < picture_.numbers.size(); ++i) {
    if (got.numbers[i] == picture_.numbers[i]) continue;
    ++faults.elements;
    if (faults.away_from_edges) continue;
    const int column = static_cast<int>(i) % raster_.width;
    const int row = static_cast<int>(i) / raster_.width;
    const double distance = distance_to_edges(active_.view, sets(), list_.items,
                                              picture_.numbers[i], got.numbers[i], column, row);
    faults.away_from_edges = !(distance <= kEdgeMargin);
    faults.distance = faults.away_from_edges ? distance : std::max(faults.distance, distance);
  }
}

template <class N>
void ExactFrame::compare_decisions(FrameFaults& faults) const {
  const PreparedSystem& system = database_.systems[0];
  priority_processor::Functional<N> priority(PriorityMethod::kCounters);
  PriorityList list;
  priority.compute(system.hierarchy, system.set, active_, database_.ground, list);
  faults.priorities = misplaced(list.items);
  // Certified faces are turned away as those of doubles are.
  using Decider = std::conditional_t<std::is_same_v<N, Certified>, double, N>;
  auto right = facings_.begin();
  for (const ItemRef& ref : list_.items) {
    const FaceSet& from = *sets()[static_cast<std::size_t>(ref.set)];
    const Item& item = from.items[ref.item];
    for (std::uint32_t f = item.first_face; f < item.first_face + item.face_count; ++f) {
      const Plane& plane = from.planes[from.faces[f].plane];
      const int got = geometry_processor::Functional<Decider>::facing(plane, active_.view.eye);
      faults.facings += got != *right++;
    }
  }
}

void ExactFrame::compare_words(const Format& format, FrameFaults& faults) const {
  const MachineOptions options = options_for(format, raster_, eye_reach());
  frame_calculator::MemoryLoader loader(options.description, options.eye_reach);
  loader.load(database_, viewpoint_, position_, 0);
  std::vector<ItemWord> words;
  priority_processor::Figures priority;
  priority_processor::FunctionalWords(0).compute(loader.priority_banks()[0], words, priority);
  std::vector<ItemRef> items;
  for (const ItemWord& word : words)
    if (!word.end) items.push_back({word.set, word.item});
  faults.priorities = misplaced(items);
  auto of_item = facings_.begin();
  for (const ItemRef& ref : list_.items) {
    const FaceSet& from = *sets()[static_cast<std::size_t>(ref.set)];
    const Item& item = from.items[ref.item];
    const std::vector<bool> shown =
        shown_faces(options.description, loader.geometry_banks()[0], {ref.set, ref.item, false});
    for (std::uint32_t f = 0; f < shown.size() && f < item.face_count; ++f) {
      const PreparedFace& face = from.faces[item.first_face + f];
      const int right = of_item[f];
      faults.facings += shown[f] != (right > 0 || (right < 0 && face.two_sided));
    }
    of_item += item.face_count;
  }
}

std::uint64_t ExactFrame::misplaced(const std::vector<ItemRef>& items) const {
  std::uint64_t count = wrong_sides_;
  count += items.size() > list_.items.size() ? items.size() - list_.items.size()
                                             : list_.items.size() - items.size();
  for (std::size_t i = 0; i < std::min(items.size(), list_.items.size()); ++i)
    count += !(items[i] == list_.items[i]);
  return count;
}

}  // namespace cigsim::stability
