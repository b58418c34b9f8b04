// SPDX-License-Identifier: MIT
// The separating-plane matrix SEPL and, for an eyepoint, rows of the separating-object matrix SO
// (Levine 1975, ch. VI.E), for any number of objects and planes. Entries are decided exactly.
//
// Two things the source leaves open. An object that lies in a plane (a figure) counts to the side
// that the other of a pair is not on; a plane with such objects and others on both sides takes two
// columns. And a pair that no plane parts is *unresolved*: the source's formula would read it as
// "cannot hide". Here either may hide the other, and the hidden lines ask for its depth.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/hidden_line/part.hpp"

namespace cigsim::hidden_line {

struct SeplLimits {
  std::size_t columns = 2048;    ///< planes at most
  std::size_t searches = 20000;  ///< pairs for which a plane is looked for
};

class Sepl {
 public:
  Sepl() = default;
  /// Takes those of `candidates` that part a pair which is not parted yet, then looks for planes
  /// (faces of the two first, as the source says) for the pairs that are left.
  Sepl(std::span<const Part> parts, std::span<const Plane> candidates,
       const SeplLimits& limits = {});

  std::size_t objects() const { return objects_; }
  std::size_t planes() const { return planes_.size(); }
  const Plane& plane(std::size_t column) const { return planes_[column]; }
  /// +1, -1, or 0 where the plane cuts the object.
  int entry(std::size_t object, std::size_t column) const;
  std::uint64_t unresolved_pairs() const { return unresolved_; }

  /// Marks the matrix for an eyepoint. An eye in a plane counts to its minus side: then neither
  /// object can cover the other, whatever the answer is.
  void mark(const Vec3& eye);

  enum class Answer : std::uint8_t { kCannotHide, kMayHide, kUnresolved };
  /// Whether m may hide l, as last marked.
  Answer may_hide(std::size_t m, std::size_t l) const;
  /// SO(l, m) as the source writes it: 1, -1 or 0; 2 for an unresolved pair.
  int so(std::size_t l, std::size_t m) const;

 private:
  class Builder;

  std::size_t objects_ = 0, words_ = 0;
  std::vector<Plane> planes_;
  std::vector<std::uint64_t> plus_, tells_;  ///< words_ words an object
  std::vector<std::uint64_t> eye_;
  std::uint64_t unresolved_ = 0;
};

}  // namespace cigsim::hidden_line
