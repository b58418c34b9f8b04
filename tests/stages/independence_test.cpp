// SPDX-License-Identifier: MIT
// What a picture must not depend on: the order of the objects in the input.
#include <gtest/gtest.h>

#include <numeric>

#include "models/database/prepare.hpp"
#include "sim/functional_machine.hpp"
#include "tests/support/picture_check.hpp"
#include "tests/support/viewpoints.hpp"

namespace cigsim::test {
namespace {

std::vector<std::uint32_t> shuffled(std::size_t count, Random& random) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

template <class Make>
void check_permutations(std::uint64_t first_seed, int worlds, Make make) {
  for (std::uint64_t seed = first_seed; seed < first_seed + worlds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const World world = make(random);
    const std::vector<std::uint32_t> order = shuffled(world.environment.objects.size(), random);
    Environment other = world.environment;
    for (std::size_t i = 0; i < order.size(); ++i)
      other.objects[i] = world.environment.objects[order[i]];
    const Database database = prepare(world.environment), other_database = prepare(other);
    MachineOptions options;
    options.number = NumberType::kExact;
    options.raster = {32, 32};
    FunctionalMachine machine(database, options), other_machine(other_database, options);
    for (int v = 0; v < 6; ++v) {
      const Viewpoint viewpoint = random_viewpoint(world.environment, random);
      const std::vector<std::uint16_t> want = machine.compute(viewpoint, 0).numbers;
      std::vector<std::uint16_t> got = other_machine.compute(viewpoint, 0).numbers;
      for (std::uint16_t& n : got)
        if (n != 0) n = static_cast<std::uint16_t>(order[n - 1] + 1);
      ASSERT_EQ(got, want) << "view " << v;
    }
  }
}

TEST(Independence, OfTheOrderOfDisjointBodies) {
  check_permutations(1, 15, [](Random& r) { return disjoint_world(r, 40); });
}

TEST(Independence, OfTheOrderOfTouchingBodies) {
  check_permutations(100, 15, [](Random& r) { return touching_world(r); });
}

TEST(Independence, OfTheOrderOfBodiesThatPassThroughEachOther) {
  check_permutations(200, 10, [](Random& r) { return body_soup(r, 8); });
}

TEST(Independence, OfTheOrderOfTriangles) {
  check_permutations(300, 10, [](Random& r) { return triangle_soup(r, 10); });
}

}  // namespace
}  // namespace cigsim::test
