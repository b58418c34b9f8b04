// SPDX-License-Identifier: MIT
// The fast hull: a quickhull (Barber, Dobkin, Huhdanpaa 1996).
//
// Levine's extreme points make a first polyhedron of up to 14 corners, against which all points are
// tested once, in blocks; the many that lie inside are done with. Each point outside waits at one
// face that it sees. A face's farthest point is added with Levine's convex cap, and the points that
// waited at the faces it removed are handed to the new ones. Last in, first out, so that the
// work stays in one region until that is finished.
#include <algorithm>
#include <cmath>

#include "models/database/hull/finish.hpp"
#include "models/database/hull/hull.hpp"
#include "models/database/hull/polyhedron.hpp"
#include "models/database/hull/start.hpp"
#include "models/numeric/dispatch.hpp"

namespace cigsim {
namespace {

constexpr std::uint32_t kNone = Polyhedron::kNone;

// Points taken through the first test together.
constexpr std::size_t kBlock = 512;
struct Block {
  double x[kBlock], y[kBlock], z[kBlock];
  double most[kBlock];  // largest distance from a face's plane, over the normal's length
  double face[kBlock];  // that face's place in the list
};

struct UnitPlane {
  Vec3 base, normal;  // of about unit length
};

CIGSIM_DISPATCH void test_block(Block& b, const UnitPlane* planes, std::size_t count) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    b.most[i] = -8;
    b.face[i] = 0;
  }
  for (std::size_t f = 0; f < count; ++f) {
    const UnitPlane p = planes[f];
    const double place = static_cast<double>(f);
    for (std::size_t i = 0; i < kBlock; ++i) {
      const double d = p.normal.x * (b.x[i] - p.base.x) + p.normal.y * (b.y[i] - p.base.y) +
                       p.normal.z * (b.z[i] - p.base.z);
      const bool more = d > b.most[i];
      b.most[i] = more ? d : b.most[i];
      b.face[i] = more ? place : b.face[i];
    }
  }
}

class Quickhull {
 public:
  Quickhull(const ExactPoints& points, const HullStart& start,
            const std::vector<std::uint32_t>& extreme)
      : polyhedron_(points), points_(points) {
    counters_.added = 4;
    counters_.tests = start.tests;
    const auto& t = start.corner;
    polyhedron_.start(t[0], t[1], t[2], t[3]);
    for (const std::uint32_t point : extreme)
      if (std::find(t.begin(), t.end(), point) == t.end()) add_extreme(point);
    next_.assign(points.size(), kNone);
  }

  void run() {
    first_pass();
    while (!open_.empty()) {
      const std::uint32_t face = open_.back();
      open_.pop_back();
      if (polyhedron_.face(face).alive && waiting(face).first != kNone) add_farthest(face);
    }
  }

  const Polyhedron& polyhedron() const { return polyhedron_; }
  HullCounters counters() const {
    HullCounters all = counters_;
    all.exact = polyhedron_.exact();
    return all;
  }

 private:
  // The points that wait at a face: a list through next_, and the farthest of them, which is first.
  struct Waiting {
    std::uint32_t first = kNone;
    double distance = 0;
  };

  Waiting& waiting(std::uint32_t face) {
    if (waiting_.size() <= face)
      waiting_.resize(std::max<std::size_t>(face + 1, 2 * waiting_.size()));
    return waiting_[face];
  }

  bool sees(std::uint32_t face, std::uint32_t point) {
    ++counters_.tests;
    return polyhedron_.sees(face, point);
  }

  void add_cap(std::uint32_t point, std::uint32_t face) {
    polyhedron_.add_cap(point, face, [&](std::uint32_t other) { return sees(other, point); });
    ++counters_.added;
  }

  void add_extreme(std::uint32_t point) {
    for (std::uint32_t face = 0; face < polyhedron_.face_places(); ++face)
      if (polyhedron_.face(face).alive && sees(face, point)) return add_cap(point, face);
  }

  void wait(std::uint32_t face, std::uint32_t point, double distance) {
    Waiting& w = waiting(face);
    if (w.first == kNone) {
      w = {point, distance};
      next_[point] = kNone;
    } else if (distance > w.distance) {
      next_[point] = w.first;
      w = {point, distance};
    } else {
      next_[point] = next_[w.first];
      next_[w.first] = point;
    }
  }

  void first_pass();

  void add_farthest(std::uint32_t face) {
    const std::uint32_t point = waiting(face).first;
    add_cap(point, face);
    const auto cap = polyhedron_.added();
    for (const std::uint32_t added : cap) waiting(added);
    chain_.clear();
    for (const std::uint32_t gone : polyhedron_.removed()) {
      const std::uint32_t first = waiting(gone).first;
      waiting_[gone].first = kNone;
      if (first != kNone) chain_.push_back(first);
    }
    for (const std::uint32_t added : cap) waiting_[added] = {};
    for (const std::uint32_t first : chain_)
      for (std::uint32_t p = first; p != kNone;) {
        const std::uint32_t following = next_[p];
        if (p != point) hand_over(p, cap);
        p = following;
      }
    for (const std::uint32_t added : cap)
      if (waiting_[added].first != kNone) open_.push_back(added);
  }

  // To the first face of the cap that the point sees; it lies inside if it sees none.
  void hand_over(std::uint32_t point, std::span<const std::uint32_t> cap) {
    const Vec3 p = points_.scaled(point);
    for (const std::uint32_t face : cap) {
      ++counters_.tests;
      const FilterPlane& plane = polyhedron_.face(face).plane;
      const double value = plane.value(p);
      if (value < -plane.bound) continue;
      if (value > plane.bound || polyhedron_.sees_in_doubt(face, point))
        return wait(face, point, value);
    }
  }

  Polyhedron polyhedron_;
  const ExactPoints& points_;
  HullCounters counters_;
  std::vector<std::uint32_t> next_, open_, chain_;
  std::vector<Waiting> waiting_;  // by face
};

void Quickhull::first_pass() {
  std::vector<std::uint32_t> faces;
  std::vector<UnitPlane> planes;
  double bound = 0;
  for (std::uint32_t i = 0; i < polyhedron_.face_places(); ++i) {
    const Polyhedron::Face& face = polyhedron_.face(i);
    if (!face.alive) continue;
    const double length = std::sqrt(dot(face.plane.normal, face.plane.normal));
    faces.push_back(i);
    planes.push_back({face.plane.base, face.plane.normal * (1 / length)});
    // Scaling rounds each component twice more.
    bound = std::max(bound, face.plane.bound / length * 1.01 + 0x1p-48);
  }
  Block block;
  const auto n = static_cast<std::uint32_t>(points_.size());
  for (std::uint32_t begin = 0; begin < n; begin += kBlock) {
    const std::uint32_t count = std::min<std::uint32_t>(kBlock, n - begin);
    for (std::uint32_t i = 0; i < kBlock; ++i) {
      const Vec3& p = points_.scaled(begin + std::min(i, count - 1));
      block.x[i] = p.x;
      block.y[i] = p.y;
      block.z[i] = p.z;
    }
    test_block(block, planes.data(), planes.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      if (block.most[i] < -bound) continue;
      const std::uint32_t face = faces[static_cast<std::size_t>(block.face[i])];
      if (block.most[i] > bound)
        wait(face, begin + i, polyhedron_.face(face).plane.value(points_.scaled(begin + i)));
      else
        hand_over(begin + i, faces);
    }
  }
  counters_.tests += std::uint64_t{n} * faces.size();
  for (const std::uint32_t face : faces)
    if (waiting(face).first != kNone) open_.push_back(face);
}

}  // namespace

Hull convex_hull(std::span<const Vec3> points) { return find_hull<Quickhull>(points); }

}  // namespace cigsim
