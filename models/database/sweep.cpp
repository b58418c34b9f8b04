// SPDX-License-Identifier: MIT
#include "models/database/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cigsim {
namespace {

// The extent of an item, and the same without what may overlap its neighbours.
struct Extent {
  double low, high, inner_low, inner_high;
  std::uint32_t item;
  bool flat;  // it may lie in a plane across the axis
};

// True for an extent of nothing; that of a rounded vertex reaches an ulp further to both sides.
bool is_flat(double low, double high) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  return std::nextafter(std::nextafter(low, inf), inf) >= high;
}

Sweep sweep(const std::vector<Extent>& sorted, int axis) {
  Sweep result;
  result.axis = axis;
  double reach = -std::numeric_limits<double>::infinity();
  double inner_reach = reach, flat_at = reach;
  std::size_t run = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const Extent& e = sorted[i];
    // Where a polygon lies in the plane across the axis, others may have faces in it too, which
    // that plane does not order (the partition makes them one sheet).
    const bool flat_touch = e.low <= reach && (e.flat || flat_at >= e.low);
    if (i == 0 || (e.inner_low >= inner_reach && !flat_touch)) {
      if (i > 0) {
        result.positions.push_back(e.low);
        result.largest = std::max(result.largest, i - run);
      }
      result.starts.push_back(i);
      run = i;
    }
    if (e.flat) flat_at = std::max(flat_at, e.high);
    reach = std::max(reach, e.high);
    inner_reach = std::max(inner_reach, e.inner_high);
    result.order.push_back(e.item);
  }
  result.largest = std::max(result.largest, sorted.size() - run);
  return result;
}

}  // namespace

Sweep best_sweep(const WorkSet& set, const std::vector<std::uint32_t>& items) {
  Sweep best;
  best.largest = std::numeric_limits<std::size_t>::max();
  std::vector<Extent> extents(items.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const WorkItem& item = set.items[items[i]];
      const double low = item.low[axis], high = item.high[axis];
      const double overlap = set.contact_tolerance_of(item, high - low) / 2;
      extents[i] = {low,           high,
                    low + overlap, high - overlap,
                    items[i],      item.flat_parts || is_flat(low, high)};
    }
    std::sort(extents.begin(), extents.end(), [](const Extent& a, const Extent& b) {
      if (a.inner_low != b.inner_low) return a.inner_low < b.inner_low;
      if (a.high != b.high) return a.high < b.high;
      return a.item < b.item;
    });
    Sweep candidate = sweep(extents, axis);
    if (candidate.largest < best.largest) best = std::move(candidate);
  }
  return best;
}

std::vector<Plane> planes_across_axes(const WorkSet& set, const std::vector<std::uint32_t>& items,
                                      std::span<const std::size_t> eighths) {
  std::vector<Plane> planes;
  std::vector<double> ends;
  for (int axis = 0; axis < 3; ++axis) {
    ends.clear();
    for (const std::uint32_t i : items) {
      ends.push_back(set.items[i].low[static_cast<std::size_t>(axis)]);
      ends.push_back(set.items[i].high[static_cast<std::size_t>(axis)]);
    }
    for (const std::size_t share : eighths) {
      const auto at = ends.begin() + static_cast<std::ptrdiff_t>(ends.size() * share / 8);
      std::nth_element(ends.begin(), at, ends.end());
      planes.push_back(axis_plane(axis, *at));
    }
  }
  return planes;
}

}  // namespace cigsim
