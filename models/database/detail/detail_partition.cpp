// SPDX-License-Identifier: MIT
#include "models/database/detail/detail_partition.hpp"

#include <algorithm>
#include <cmath>

#include "models/database/hierarchy.hpp"
#include "models/database/sphere/sphere.hpp"

namespace cigsim {
namespace {

using ItemList = std::vector<std::uint32_t>;

// How often choices may be cut along, before those that a plane must cut are given up.
constexpr int kPassesWithCuts = 3;

// Beyond this a smallest sphere may not fit into doubles.
constexpr double kLargest = 0x1p1000;

Sphere sphere_around(const WorkSet& work, const WorkItem& item) {
  std::vector<Vec3> points;
  for (std::uint32_t p = item.first_polygon; p < item.first_polygon + item.polygon_count; ++p) {
    const WorkPolygon& polygon = work.polygons[p];
    for (std::uint32_t c = 0; c < polygon.corner_count; ++c)
      points.push_back(work.vertex(work.corners(polygon)[c]));
  }
  for (const Vec3& p : points)
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kLargest)
      return enclosing(points);
  const BoundingSphere smallest = minimum_sphere(points);
  return {smallest.centre, smallest.radius};
}

// One attempt: composites from the innermost choices out, then the partition.
class Attempt {
 public:
  Attempt(const Environment& environment, const std::vector<bool>& given_up, DetailPartition& out)
      : environment_(environment), given_up_(given_up), out_(out) {
    for (const Choice& choice : environment.choices)
      lists_.emplace_back(choice.thresholds.size() + 1);
  }

  // Returns the choices given up; `again` when one of them had been cut.
  ItemList run(const std::vector<ItemRange>& objects, bool may_cut,
               const std::function<void(std::uint64_t, std::uint64_t)>& progress, bool& again) {
    composites_.may_cut = may_cut;
    for (std::size_t o = 0; o < objects.size(); ++o)
      for (std::uint32_t i = objects[o].first; i < objects[o].end; ++i)
        list(environment_.objects[o].within).push_back(i);
    // Choices come after those that they stand in.
    for (std::size_t c = environment_.choices.size(); c-- > 0;) gather(c);
    out_.tree = partition(out_.work, composites_, top_, progress);
    ItemList given_up = out_.tree.given_up;
    again = std::any_of(given_up.begin(), given_up.end(),
                        [&](std::uint32_t c) { return composites_.was_cut(c); });
    return given_up;
  }

 private:
  ItemList& list(const std::optional<DescriptionRef>& within) {
    return within ? lists_[within->choice][within->description] : top_;
  }

  void gather(std::size_t c) {
    std::vector<ItemList>& descriptions = lists_[c];
    const Choice& choice = environment_.choices[c];
    const bool nothing = std::all_of(descriptions.begin(), descriptions.end(),
                                     [](const ItemList& list) { return list.empty(); });
    if (nothing) return;
    ItemList& outside = list(choice.within);
    const ItemList& last = descriptions.back();
    if (last.empty()) {
      ++out_.without_detail;
    } else if (descriptions.size() == 1 || given_up_[c]) {
      outside.insert(outside.end(), last.begin(), last.end());
    } else {
      const std::uint32_t item =
          composites_.add(out_.work, {static_cast<std::uint32_t>(c), descriptions});
      out_.choices[c] = {sphere_around(out_.work, out_.work.items[item]), choice.thresholds};
      outside.push_back(item);
    }
  }

  const Environment& environment_;
  const std::vector<bool>& given_up_;
  DetailPartition& out_;
  Composites composites_;
  ItemList top_;
  std::vector<std::vector<ItemList>> lists_;  // by choice and description
};

}  // namespace

DetailPartition partition_with_choices(
    const Environment& environment, const WorkSet& work, const std::vector<ItemRange>& objects,
    const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  std::vector<bool> given_up(environment.choices.size(), false);
  for (int pass = 1;; ++pass) {
    DetailPartition out;
    out.work = work;
    out.choices.resize(environment.choices.size());
    bool again = false;
    for (const std::uint32_t c :
         Attempt(environment, given_up, out).run(objects, pass <= kPassesWithCuts, progress, again))
      given_up[c] = true;
    if (again) continue;
    out.given_up = static_cast<std::uint64_t>(std::count(given_up.begin(), given_up.end(), true));
    return out;
  }
}

void take_choices(const std::vector<PreparedChoice>& choices, PriorityHierarchy& hierarchy) {
  std::vector<std::uint32_t> place(choices.size(), kNone);
  for (const Group& group : hierarchy.groups)
    if (group.choice != kNone) place[group.choice] = 0;
  for (std::size_t c = 0; c < choices.size(); ++c) {
    if (place[c] == kNone) continue;
    place[c] = static_cast<std::uint32_t>(hierarchy.choices.size());
    hierarchy.choices.push_back(choices[c]);
  }
  for (Group& group : hierarchy.groups)
    if (group.choice != kNone) group.choice = place[group.choice];
}

}  // namespace cigsim
