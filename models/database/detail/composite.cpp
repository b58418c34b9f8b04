// SPDX-License-Identifier: MIT
#include "models/database/detail/composite.hpp"

#include <algorithm>

namespace cigsim {
namespace {

constexpr unsigned kBothSides = 3;

// A part that may lie beside others in a plane: a polygon, or composites of such.
bool is_flat_part(const WorkItem& part) { return part.polygon_count == 1 || part.flat_parts; }

}  // namespace

std::uint32_t Composites::add(WorkSet& set, Composite composite) {
  std::uint32_t count = 0;
  bool flat_parts = false;
  for (const std::vector<std::uint32_t>& description : composite.descriptions)
    for (const std::uint32_t part : description) {
      const WorkItem source = set.items[part];
      for (std::uint32_t p = 0; p < source.polygon_count; ++p) {
        const WorkPolygon polygon = set.polygons[source.first_polygon + p];
        set.polygons.push_back(polygon);
      }
      count += source.polygon_count;
      flat_parts = flat_parts || is_flat_part(source);
    }
  const std::uint32_t item = set.add_item(count);
  set.items[item].flat_parts = flat_parts;
  by_item_.emplace(item, std::move(composite));
  return item;
}

Composites::Cut Composites::cut(WorkSet& set, const Plane& plane, std::uint32_t item) {
  const Composite source = by_item_.at(item);
  if (was_cut_.size() <= source.choice) was_cut_.resize(source.choice + 1, false);
  was_cut_[source.choice] = true;
  Cut result;
  std::array<Composite, 2> halves;
  std::array<bool, 2> filled{};
  for (Composite& half : halves) {
    half.choice = source.choice;
    half.descriptions.resize(source.descriptions.size());
  }
  const auto put = [&](int half, std::size_t description, std::uint32_t part) {
    if (part == WorkSet::kNothing) return;
    halves[half].descriptions[description].push_back(part);
    filled[half] = true;
  };
  for (std::size_t d = 0; d < source.descriptions.size(); ++d)
    for (const std::uint32_t part : source.descriptions[d]) {
      bool tolerated = false;
      const int where = set.classify(plane, set.items[part], WorkSet::kNothing, &tolerated);
      result.tolerated += tolerated;
      if (where == 1 || where == -1) {
        put(where == 1 ? 0 : 1, d, part);
      } else if (where == 0) {
        put(set.seen_from(plane, set.items[part]) == 2 ? 0 : 1, d, part);
      } else if (find(part) != nullptr) {
        const Cut inner = cut(set, plane, part);
        for (int half = 0; half < 2; ++half) put(half, d, inner.items[half]);
        result.cuts += inner.cuts;
        result.tolerated += inner.tolerated;
      } else {
        const auto parts = set.cut(plane, part);
        for (int half = 0; half < 2; ++half) put(half, d, parts[half]);
        ++result.cuts;
      }
    }
  for (int half = 0; half < 2; ++half)
    result.items[half] = filled[half] ? add(set, std::move(halves[half])) : WorkSet::kNothing;
  return result;
}

bool Composites::holds_two_sided_in(const WorkSet& set, const Plane& plane,
                                    std::uint32_t item) const {
  const Composite* composite = find(item);
  if (composite == nullptr)
    return set.classify(plane, set.items[item]) == 0 &&
           set.seen_from(plane, set.items[item]) == kBothSides;
  for (const std::vector<std::uint32_t>& description : composite->descriptions)
    for (const std::uint32_t part : description)
      if (holds_two_sided_in(set, plane, part)) return true;
  return false;
}

bool Composites::was_cut(std::uint32_t choice) const {
  return choice < was_cut_.size() && was_cut_[choice];
}

std::array<InPlane, 2> in_plane(const WorkSet& set, const Plane& plane, const WorkItem& item) {
  std::array<InPlane, 2> found;
  if (!set.reaches(plane, item)) return found;
  for (std::uint32_t p = 0; p < item.polygon_count; ++p) {
    const WorkPolygon& polygon = set.polygons[item.first_polygon + p];
    if (!set.lies_in(plane, polygon)) continue;
    const unsigned sides = set.seen_from(plane, polygon);
    for (unsigned side = 0; side < 2; ++side) {
      if (!(sides >> side & 1)) continue;
      InPlane& in = found[side];
      const std::uint32_t order = polygon.origin.order;
      in.first_order = in.any ? std::min(in.first_order, order) : order;
      in.last_order = in.any ? std::max(in.last_order, order) : order;
      in.any = true;
    }
  }
  return found;
}

}  // namespace cigsim
