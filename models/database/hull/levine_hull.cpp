// SPDX-License-Identifier: MIT
// Levine's convex hull (1975, ch. IV), with his count of tests.
//
// Where the text leaves a choice this is how it is read here: the simple distances of step 1 are
// not counted as tests, those of step 3 are; the search of step 4a runs through the list of faces
// in its order, new faces at the end, and the neighbours of step 4b count even where 4a tested
// them; faces found final in step 5 are not tested again by any later step.
#include <algorithm>

#include "models/database/hull/finish.hpp"
#include "models/database/hull/hull.hpp"
#include "models/database/hull/polyhedron.hpp"
#include "models/database/hull/start.hpp"

namespace cigsim {
namespace {

class LevineSearch {
 public:
  LevineSearch(const ExactPoints& points, const HullStart& start,
               const std::vector<std::uint32_t>& extreme)
      : polyhedron_(points) {
    counters_.tests = start.tests;
    counters_.added = 4;
    const auto& t = start.corner;
    polyhedron_.start(t[0], t[1], t[2], t[3]);
    const auto added = polyhedron_.added();
    faces_.assign(added.begin(), added.end());
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (std::find(t.begin(), t.end(), i) == t.end()) {
        if (std::find(extreme.begin(), extreme.end(), i) == extreme.end()) left_.push_back(i);
      }
    for (const std::uint32_t i : extreme)
      if (std::find(t.begin(), t.end(), i) == t.end()) outside_.push_back(i);
  }

  void run() {
    for (;;) {
      for (const std::uint32_t point : outside_) add(point);
      test_all();
      if (outside_.empty()) return;
    }
  }

  const Polyhedron& polyhedron() const { return polyhedron_; }
  HullCounters counters() const {
    HullCounters all = counters_;
    all.exact = polyhedron_.exact();
    return all;
  }

 private:
  bool sees(std::uint32_t face, std::uint32_t point) {
    ++counters_.tests;
    return polyhedron_.sees(face, point);
  }

  // Step 4: a face that the point sees, then its neighbours, then the cap. A point that sees none
  // lies on the polyhedron already.
  void add(std::uint32_t point) {
    const auto first = std::find_if(faces_.begin(), faces_.end(),
                                    [&](std::uint32_t face) { return sees(face, point); });
    if (first == faces_.end()) return;
    polyhedron_.add_cap(point, *first,
                        [&](std::uint32_t face) { return !final(face) && sees(face, point); });
    std::erase_if(faces_, [&](std::uint32_t face) { return !polyhedron_.face(face).alive; });
    const auto cap = polyhedron_.added();
    for (const std::uint32_t face : cap) set_final(face, false);
    faces_.insert(faces_.end(), cap.begin(), cap.end());
    ++counters_.added;
  }

  // Step 5: every point left against every face that may still be seen.
  void test_all() {
    ++counters_.rounds;
    std::vector<double> most(faces_.size(), 0);
    std::vector<std::uint32_t> farthest(faces_.size(), Polyhedron::kNone);
    std::erase_if(left_, [&](std::uint32_t point) {
      bool inside = true;
      for (std::size_t i = 0; i < faces_.size(); ++i) {
        if (!sees(faces_[i], point)) continue;
        inside = false;
        const double distance =
            polyhedron_.face(faces_[i]).plane.value(polyhedron_.points().scaled(point));
        if (farthest[i] != Polyhedron::kNone && distance <= most[i]) continue;
        most[i] = distance;
        farthest[i] = point;
      }
      return inside;
    });
    take_farthest(farthest);
  }

  // Faces that no point sees are final; the others' farthest points are to be added, each once.
  void take_farthest(const std::vector<std::uint32_t>& farthest) {
    std::vector<std::uint32_t> open;
    outside_.clear();
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (farthest[i] == Polyhedron::kNone) {
        set_final(faces_[i], true);
        continue;
      }
      open.push_back(faces_[i]);
      if (std::find(outside_.begin(), outside_.end(), farthest[i]) == outside_.end())
        outside_.push_back(farthest[i]);
    }
    faces_ = std::move(open);
    std::vector<std::uint32_t> taken = outside_;
    std::sort(taken.begin(), taken.end());
    std::erase_if(left_, [&](std::uint32_t point) {
      return std::binary_search(taken.begin(), taken.end(), point);
    });
  }

  void set_final(std::uint32_t face, bool final) {
    if (final_.size() <= face) final_.resize(face + 1, 0);
    final_[face] = final;
  }
  bool final(std::uint32_t face) const { return face < final_.size() && final_[face] != 0; }

  Polyhedron polyhedron_;
  HullCounters counters_;
  std::vector<std::uint32_t> faces_;    // FL, without the final ones
  std::vector<std::uint32_t> outside_;  // TL
  std::vector<std::uint32_t> left_;     // points not yet placed
  std::vector<std::uint8_t> final_;     // by face: no point left sees it
};

}  // namespace

Hull levine_hull(std::span<const Vec3> points) { return find_hull<LevineSearch>(points); }

std::uint64_t equivalent_tests(std::size_t points, std::size_t faces) {
  return 3 * static_cast<std::uint64_t>(points) * faces;
}

}  // namespace cigsim
