// SPDX-License-Identifier: MIT
// All combinations of sides among planes, by their smallest flats and the rays at them
// (arrangement.hpp says why these are all).
#pragma once

#include <functional>
#include <unordered_set>
#include <vector>

#include "models/database/listability/arrangement.hpp"

namespace cigsim::listability {

class CellWalk {
 public:
  using Visit = std::function<bool(std::uint64_t, const CellPath&)>;

  /// At most kMostCellPlanes planes.
  CellWalk(const std::vector<WholePlane>& planes, const Visit& visit);

  void run();

 private:
  bool flats_of_three();
  bool flats_of_two();
  bool flats_of_one();
  bool at_flat(const WholeVec& v, const mpz_class& w);
  bool simple_vertex(std::uint64_t open, std::uint64_t eye_true);
  bool central(std::uint64_t open, std::uint64_t eye_true);
  bool along(const WholeVec& direction, std::uint64_t open, std::uint64_t eye_true);
  std::vector<WholeVec> rays(const std::vector<std::uint32_t>& open) const;

  const std::vector<WholePlane>& planes_;
  std::vector<std::array<double, 4>> near_;  // n and -d, scaled
  const Visit& visit_;
  CellPath path_;
  std::unordered_set<std::uint64_t> seen_;   // cells
  std::unordered_set<std::uint64_t> flats_;  // by the planes through them
};

}  // namespace cigsim::listability
