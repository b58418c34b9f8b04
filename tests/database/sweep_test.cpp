// SPDX-License-Identifier: MIT
// Where a plane across an axis may part items, and where a flat polygon forbids it.
#include "models/database/sweep.hpp"

#include <gtest/gtest.h>

namespace cigsim {
namespace {

// A working set of triangles, each with the extent along x that is asked for. The other axes offer
// no gap.
struct Extents {
  WorkSet set;
  std::vector<std::uint32_t> items;

  void add(double low, double high) {
    const std::uint32_t a = set.add_vertex({low, 0, 0}), b = set.add_vertex({high, 1, 0}),
                        c = set.add_vertex({low, 0, 1});
    set.add_polygon({a, b, c}, 0, {});
    items.push_back(set.add_item(1));
  }
  std::size_t runs() const { return best_sweep(set, items).starts.size(); }
};

TEST(Sweep, PartsBodiesThatTouch) {
  Extents e;
  e.add(0, 1);
  e.add(1, 2);
  e.add(3, 4);
  EXPECT_EQ(e.runs(), 3u);
}

TEST(Sweep, PartsAnOverlapWithinTheContactToleranceOnly) {
  Extents e;
  e.add(0, 1 + 0x1p-40);
  e.add(1, 2);
  EXPECT_EQ(e.runs(), 1u);
  e.set.contact_tolerance = 0x1p-28;
  EXPECT_EQ(e.runs(), 2u);
}

TEST(Sweep, LeavesAFlatPolygonWithFacesInItsPlane) {
  for (const double tolerance : {0.0, 0x1p-28})
    for (const double ulp : {0.0, 0x1p-53}) {  // rounded vertices reach an ulp further
      SCOPED_TRACE(testing::Message() << "tolerance " << tolerance << " ulp " << ulp);
      Extents below, above, both;
      below.add(0, 1 + ulp);
      below.add(1, 1);
      above.add(1 - ulp, 1 + ulp);
      above.add(1, 1);
      above.add(1, 2);
      both.add(0, 1 + ulp);
      both.add(1, 1);
      both.add(1 - ulp, 2);
      for (Extents* e : {&below, &above, &both}) {
        e->set.contact_tolerance = tolerance;
        EXPECT_EQ(e->runs(), 1u);
      }
    }
}

}  // namespace
}  // namespace cigsim
