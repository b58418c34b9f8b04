// SPDX-License-Identifier: MIT
#include "models/database/detail/hindrance.hpp"

#include <algorithm>

namespace cigsim {
namespace {

// In which order an eye on one side of the plane meets what is seen from that side in the plane.
enum class Place { kFront, kMiddle, kBack };

struct Coplanar {
  std::uint32_t item;
  bool composite;
  int where;  // WorkSet::classify
  std::array<InPlane, 2> sides;
};

bool boxes_meet(const WorkItem& a, const WorkItem& b) {
  for (int i = 0; i < 3; ++i)
    if (a.low[i] > b.high[i] || b.low[i] > a.high[i]) return false;
  return true;
}

class Hindrance {
 public:
  Hindrance(const WorkSet& set, const Composites& composites, const Plane& plane,
            std::uint32_t face_plane)
      : set_(set), composites_(composites), plane_(plane), face_plane_(face_plane) {}

  std::vector<std::uint32_t> find(const std::vector<std::uint32_t>& items) {
    for (const std::uint32_t item : items) look_at(item);
    std::vector<std::uint32_t> hindered;
    for (const Coplanar& a : coplanar_)
      if (a.composite && (!can_cut(a) || loses_its_place(a))) hindered.push_back(a.item);
    return hindered;
  }

 private:
  void look_at(std::uint32_t item) {
    const bool composite = composites_.find(item) != nullptr;
    const WorkItem& source = set_.items[item];
    Coplanar c{item, composite, 0, in_plane(set_, plane_, source)};
    if (!c.sides[0].any && !c.sides[1].any && !composite) return;
    c.where = set_.classify(plane_, source, face_plane_);
    if (c.where == 0 && !composite)
      for (int side = 0; side < 2; ++side) sheet_[side] = sheet_[side] || c.sides[side].any;
    coplanar_.push_back(c);
  }

  bool can_cut(const Coplanar& c) const {
    return c.where != 2 ||
           (composites_.may_cut && !composites_.holds_two_sided_in(set_, plane_, c.item));
  }

  // Cut bodies have their faces behind the plane that these are seen from, and a composite gives
  // its polygons there. Faces of other items join the sheet where there is one.
  Place place(const Coplanar& c, int side) const {
    if (c.where == 0 || (!c.composite && sheet_[side])) return Place::kMiddle;
    return c.where == (side == 0 ? 1 : -1) ? Place::kFront : Place::kBack;
  }

  bool loses_its_place(const Coplanar& a) const {
    return std::any_of(coplanar_.begin(), coplanar_.end(), [&](const Coplanar& b) {
      return a.item != b.item && boxes_meet(set_.items[a.item], set_.items[b.item]) &&
             (wrong_order(a, b, 0) || wrong_order(a, b, 1));
    });
  }

  bool wrong_order(const Coplanar& a, const Coplanar& b, int side) const {
    const InPlane &of_a = a.sides[side], &of_b = b.sides[side];
    if (!of_a.any || !of_b.any) return false;
    const Place at_a = place(a, side), at_b = place(b, side);
    if (at_a == at_b) return at_a == Place::kMiddle;
    return at_a < at_b ? of_a.last_order > of_b.first_order : of_b.last_order > of_a.first_order;
  }

  const WorkSet& set_;
  const Composites& composites_;
  const Plane& plane_;
  const std::uint32_t face_plane_;
  std::array<bool, 2> sheet_{};  // plain polygons lie in the plane, seen from this side
  std::vector<Coplanar> coplanar_;
};

}  // namespace

std::vector<std::uint32_t> hindered_by(const WorkSet& set, const Composites& composites,
                                       const Plane& plane, std::uint32_t face_plane,
                                       const std::vector<std::uint32_t>& items) {
  return Hindrance(set, composites, plane, face_plane).find(items);
}

}  // namespace cigsim
