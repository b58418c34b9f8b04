// SPDX-License-Identifier: MIT
#include "models/database/separation_table.hpp"

#include <algorithm>
#include <cmath>

#include "models/database/hierarchy.hpp"
#include "models/environment/input_error.hpp"

namespace cigsim {
namespace {

[[noreturn]] void fail(const std::string& file, const std::string& what) {
  throw InputError(file, 0, what);
}

std::string plane_name(std::size_t plane) {
  return "separation plane " + std::to_string(plane + 1);
}

// The plane's point lies on the axis that the normal is nearest to.
Plane exact_plane(const SeparationPlane& source, std::size_t number, const std::string& file) {
  const double n[3] = {source.normal.x, source.normal.y, source.normal.z};
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(n[k]) > std::abs(n[axis])) axis = k;
  const double at = source.distance / n[axis];
  if (!std::isfinite(at))
    fail(file, plane_name(number) + " is beyond all numbers; lengthen its normal");
  return plane_with_normal({axis == 0 ? at : 0, axis == 1 ? at : 0, axis == 2 ? at : 0},
                           source.normal);
}

class Table {
 public:
  Table(const Environment& environment, const WorkSet& work, const FaceSet& set,
        const std::string& file)
      : environment_(environment), work_(work), set_(set), file_(file) {}

  PriorityHierarchy run() {
    for (std::size_t p = 0; p < environment_.separation.size(); ++p) add_plane(p);
    for (std::uint32_t i = 0; i < set_.items.size(); ++i)
      out_.members.push_back({false, i, set_.items[i].sphere});
    out_.groups.push_back({0, static_cast<std::uint32_t>(out_.members.size()), 0,
                           static_cast<std::uint32_t>(out_.nodes.size())});
    return std::move(out_);
  }

 private:
  void add_plane(std::size_t number) {
    const SeparationPlane& source = environment_.separation[number];
    SeparationNode node;
    node.plane = static_cast<std::uint32_t>(out_.planes.size());
    node.first_pair = static_cast<std::uint32_t>(out_.pairs.size());
    node.pair_count = static_cast<std::uint32_t>(source.pairs.size());
    out_.planes.push_back(exact_plane(source, number, file_));
    for (const ObjectPair& pair : source.pairs) {
      const MemberPair members{static_cast<std::uint8_t>(pair.true_object - 1),
                               static_cast<std::uint8_t>(pair.false_object - 1)};
      node.true_members |= std::uint64_t{1} << members.true_member;
      node.false_members |= std::uint64_t{1} << members.false_member;
      out_.pairs.push_back(members);
    }
    check_sides(number, node.true_members, 1);
    check_sides(number, node.false_members, -1);
    out_.nodes.push_back(node);
  }

  void check_sides(std::size_t plane, std::uint64_t members, int side) const {
    for (std::uint32_t m = 0; m < kGroupCapacity; ++m) {
      if (!(members >> m & 1)) continue;
      const int where = work_.classify(out_.planes.back(), work_.items[m]);
      if (where == side) continue;
      fail(file_, "object " + std::to_string(m + 1) + " is listed as " +
                      (side > 0 ? "TRUE" : "FALSE") + " at " + plane_name(plane) + ", but " +
                      (where == 2 ? "the plane cuts it" : "it lies on the other side") +
                      "; correct the plane or its pairs");
    }
  }

  const Environment& environment_;
  const WorkSet& work_;
  const FaceSet& set_;
  const std::string& file_;
  PriorityHierarchy out_;
};

}  // namespace

void check_table(const Environment& environment, const std::string& file) {
  const std::size_t objects = environment.objects.size();
  if (objects > kGroupCapacity)
    fail(file, "a separation table takes at most " + std::to_string(kGroupCapacity) +
                   " objects, not " + std::to_string(objects) + "; remove \"separation\"");
  if (environment.separation.size() > kTablePlanes)
    fail(file, "a separation table takes at most " + std::to_string(kTablePlanes) +
                   " planes, not " + std::to_string(environment.separation.size()) +
                   "; gather the pairs on fewer");
  for (std::size_t p = 0; p < environment.separation.size(); ++p)
    for (const auto& [a, b] : environment.separation[p].pairs)
      if (std::min(a, b) < 1 || std::max(a, b) > objects)
        fail(file, plane_name(p) +
                       " names an object that is not there; objects are numbered from " + "1 to " +
                       std::to_string(objects));
  if (!environment.choices.empty())
    fail(file, "choice \"" + environment.choices.front().name +
                   "\" has several descriptions, which a separation table cannot order; remove one "
                   "of the two");
  for (const CoordinateSystem& system : environment.systems)
    if (!system.motion.empty())
      fail(file, "system \"" + system.name +
                     "\" moves, which a separation table cannot order; remove one of the two");
}

PriorityHierarchy table_hierarchy(const Environment& environment, const WorkSet& work,
                                  const FaceSet& set, const std::string& file) {
  return Table(environment, work, set, file).run();
}

}  // namespace cigsim
