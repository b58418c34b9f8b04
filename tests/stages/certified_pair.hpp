// SPDX-License-Identifier: MIT
// Pictures in certified numbers beside those in exact ones.
#pragma once

#include <gtest/gtest.h>

#include <iostream>

#include "sim/functional_machine.hpp"

namespace cigsim::test {

/// A database drawn in exact and in certified numbers.
class Pair {
 public:
  Pair(const Database& database, const Raster& raster, ResolverMethod resolver,
       PriorityMethod priority = PriorityMethod::kCounters, double detail = 1)
      : exact_(database, options(NumberType::kExact, raster, ResolverMethod::kCoverage,
                                 PriorityMethod::kCounters, detail)),
        certified_(database, options(NumberType::kCertified, raster, resolver, priority, detail)) {}

  void check(const Viewpoint& viewpoint, double frame = 0) {
    const Picture& want = exact_.compute(viewpoint, frame);
    const Picture& got = certified_.compute(viewpoint, frame);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < want.numbers.size(); ++i)
      wrong += got.numbers[i] != want.numbers[i] || got.colours[i] != want.colours[i];
    EXPECT_EQ(wrong, 0u) << "elements differ; eye " << viewpoint.eye.position.x << ","
                         << viewpoint.eye.position.y << "," << viewpoint.eye.position.z
                         << " heading " << viewpoint.eye.heading << " fov " << viewpoint.fov;
    const FrameStats& stats = certified_.stats();
    EXPECT_TRUE(stats.certified);
    ASSERT_TRUE(stats.redone.has_value());
    EXPECT_EQ(stats.redone->crossings, stats.crossings);
    EXPECT_EQ(stats.redone->edges, stats.edges);
    EXPECT_EQ(stats.edges, exact_.stats().edges);
    EXPECT_EQ(stats.crossings, exact_.stats().crossings);
    EXPECT_EQ(stats.faults, exact_.stats().faults);
    EXPECT_FALSE(exact_.stats().redone.has_value());
    ++pictures_;
    redone_.vertices += stats.redone->vertices;
    redone_.vertices_redone += stats.redone->vertices_redone;
    redone_.faces += stats.redone->faces;
    redone_.faces_redone += stats.redone->faces_redone;
    redone_.crossings += stats.redone->crossings;
    redone_.crossings_redone += stats.redone->crossings_redone;
  }

  const Redone& redone() const { return redone_; }
  void tell() const {
    std::cout << pictures_ << " pictures; redone: " << redone_.vertices_redone << " of "
              << redone_.vertices << " vertices, " << redone_.faces_redone << " of "
              << redone_.faces << " faces, " << redone_.crossings_redone << " of "
              << redone_.crossings << " crossings\n";
  }

 private:
  static MachineOptions options(NumberType number, const Raster& raster, ResolverMethod resolver,
                                PriorityMethod priority, double detail) {
    MachineOptions o;
    o.number = number;
    o.raster = raster;
    o.resolver = resolver;
    o.priority = priority;
    o.detail = detail;
    return o;
  }

  FunctionalMachine exact_, certified_;
  int pictures_ = 0;
  Redone redone_;
};

}  // namespace cigsim::test
