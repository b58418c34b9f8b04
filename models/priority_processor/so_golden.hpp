// SPDX-License-Identifier: MIT
// The separating-object matrix (Levine 1975, ch. VI.E), for up to 256 objects and planes, as the
// model that the RTL is held against. It asks another question than so_pair.sv, so that one mistake
// is not made twice: not which planes part two objects, but whom a plane parts from the object.
//   l may hide whoever is beyond a plane that has l on its near side;
//   whoever is on the near side of a plane that has l beyond it may hide l;
//   who is both, neither hides nor is hidden; who is neither is unresolved (so_matrix.hpp).
// These are unions of the columns of SEPL, and are looked up for four planes at a time (Arlazarov,
// Dinic, Kronrod, Faradzev 1970). That lookup is ours, the matrix is published.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace cigsim::priority_processor {

inline constexpr unsigned kSoMost = 256;  ///< objects, and planes

/// A bit an object or a plane, number n in word n / 64.
using SoBits = std::array<std::uint64_t, kSoMost / 64>;

/// A row of SEPL before it is marked for an eyepoint.
struct SoRow {
  SoBits tells{};  ///< the plane lies to one side of the object
  SoBits plus{};   ///< the object is on its plus side; counts only where `tells` is set
};

/// A row of the matrix. In the bits of the row's own object, and of those that are not active, and
/// everywhere in the rows of the latter, there is nothing.
struct SoAnswers {
  SoBits hides{};       ///< SO = +1: the row's object may hide this one
  SoBits hidden{};      ///< SO = -1: this one may hide the row's object
  SoBits unresolved{};  ///< no plane parts the two
  unsigned count = 0;   ///< objects that may hide the row's object
};

class SoGolden {
 public:
  /// Throws std::invalid_argument unless both are 1 to kSoMost. Planes tell of nobody yet.
  SoGolden(unsigned objects, unsigned planes);

  unsigned objects() const { return objects_; }
  unsigned planes() const { return planes_; }

  /// Bits beyond the number of planes do not count.
  void set_row(unsigned object, const SoRow& row);
  /// Marks SEPL: bits of `eye` are set where the eye is on the plus side of a plane.
  void mark(const SoBits& eye, const SoBits& active);
  /// The row as last marked. Stands until the next call.
  const SoAnswers& row(unsigned object) { return (this->*row_)(object); }

 private:
  template <unsigned Words>
  void build_unions();
  template <unsigned Words>
  const SoAnswers& row_of(unsigned object);

  unsigned objects_, planes_;
  std::vector<SoRow> rows_;
  bool columns_stand_ = false;
  std::vector<SoBits> plus_columns_, minus_columns_;  ///< a plane each: the objects on that side
  SoBits eye_{}, active_{}, plane_mask_{};
  /// For every four planes and each choice among them, Words words: the objects on their near
  /// sides, and those beyond them.
  std::vector<std::uint64_t> near_, beyond_;
  void (SoGolden::*build_)() = nullptr;
  const SoAnswers& (SoGolden::*row_)(unsigned) = nullptr;
  SoAnswers answers_;
};

}  // namespace cigsim::priority_processor
