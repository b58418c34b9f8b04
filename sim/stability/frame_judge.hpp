// SPDX-License-Identifier: MIT
// One frame in exact numbers, and what is wrong with the same frame in another number format.
//
// Wrong is: an object number on an element further than kEdgeMargin from every projected edge of
// the two objects in question; an item that stands elsewhere in the priority list; a face that is
// taken for a back face, or the reverse. The format's answers come from the machine's own stages.
#pragma once

#include <cstdint>

#include "sim/functional_machine.hpp"
#include "sim/stability/decision.hpp"
#include "sim/stability/measures.hpp"

namespace cigsim::stability {

/// Elements: nearer than that to an edge a picture in rounded numbers may differ.
inline constexpr double kEdgeMargin = 0.5;

struct FrameFaults {
  std::uint64_t elements = 0;  ///< that differ, near an edge or not
  bool away_from_edges = false;
  double distance = 0;  ///< of the first one away from edges, else the largest; elements
  std::uint64_t priorities = 0, facings = 0;
  bool any() const { return away_from_edges || priorities > 0 || facings > 0; }
};

/// Options that run the functional level on a format, with memories without limits: formats and
/// hither distance are all that counts of a machine. The format must not be kExact's alone.
MachineOptions options_for(const Format& format, const Raster& raster, double eye_reach);

class ExactFrame {
 public:
  /// The database must outlive it. `position` places the moving models.
  ExactFrame(const Database& database, const Viewpoint& viewpoint, const Raster& raster,
             double position = 0);

  /// Compares all elements until one away from edges is found.
  FrameFaults judge(const Format& format) const;

  /// What is in view, by priority.
  const std::vector<ItemRef>& items() const { return list_.items; }
  const Picture& picture() const { return picture_; }
  Measures measures() const { return measures_of(database_, active_, moving_, list_.items); }

 private:
  std::array<const FaceSet*, 3> sets() const;
  double eye_reach() const;
  void compare_pictures(const Format& format, FrameFaults& faults) const;
  template <class N>
  void compare_decisions(FrameFaults& faults) const;
  void compare_words(const Format& format, FrameFaults& faults) const;
  void judge_sides();
  std::uint64_t misplaced(const std::vector<ItemRef>& items) const;

  const Database& database_;
  Viewpoint viewpoint_;
  Raster raster_;
  double position_;
  ActiveEnvironment active_;
  FaceSet moving_;
  PriorityList list_;
  Picture picture_;
  std::vector<int> facings_;       // of the items' faces, by rationals: 1, -1, 0 edge on
  std::uint64_t wrong_sides_ = 0;  // of separation planes, that the exact list was made from
};

}  // namespace cigsim::stability
