// SPDX-License-Identifier: MIT
// Stump's separation program as he published it (Stump 1986, ch. III and IV, and the listing of the
// appendix), with its weak points.
//
// Candidates are the faces in the order of the cards, then the operator's planes. A plane's normal
// is (node 1 - node 2) x (node 3 - node 2), divided by its length; its directed distance is taken
// at node 1. A vertex within 0.001 of a plane is on neither side of it. For a set of objects the
// program takes a candidate that cuts none of them and has some on both sides; of several the one
// with the least difference between the two sides, then the one with the least difference over all
// objects (those it cuts count on neither side), then the first. The two sides are sets again, the
// TRUE one first. A candidate chosen again gets the new pairs besides its old ones.
//
// Faithful in detail, as the listing has it:
//  - the test whether a plane cuts an object begins anew at every face: an object with faces whole
//    on either side of a plane and none across it (a double pyramid at its waist) is not seen to be
//    cut, and lies where its last face lies;
//  - an object with every vertex within 0.001 of a plane lies where the object before it lies.
// His numbers are single precision, ours double. Variables that keep their value from call to call
// are taken to begin at 0.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/environment/deck.hpp"

namespace cigsim::separation_planes {

/// What his arrays hold.
inline constexpr std::size_t kPublishedVertices = 100, kPublishedFaceEntries = 200;

struct UnitPlane {
  Vec3 normal;          ///< of length 1, towards the TRUE side
  double distance = 0;  ///< from the origin, along the normal
};

/// A plane that was chosen, with its pairs in the order in which they were found.
struct ChosenPlane {
  UnitPlane plane;
  std::uint32_t candidate = 0;  ///< from 0
  std::vector<ObjectPair> pairs;
};

struct PublishedTable {
  bool found = false;  ///< false: "separation planes could not be found"
  std::vector<ChosenPlane> planes;
  std::uint32_t candidates = 0;
};

class PublishedProgram {
 public:
  /// `name` stands for the deck in messages. Throws InputError where his program divides by zero:
  /// the first three vertices of a face on one line.
  PublishedProgram(const StumpDeck& deck, const std::string& name);

  const std::vector<UnitPlane>& candidates() const { return candidates_; }
  /// Where object o (from 0) lies at a candidate: +1 TRUE, -1 FALSE, 0 cut.
  int state(std::size_t candidate, std::size_t object) const {
    return states_[candidate * objects_ + object];
  }
  PublishedTable run() const;

 private:
  std::size_t objects_ = 0;
  std::vector<UnitPlane> candidates_;
  std::vector<int> states_;
};

/// Throws InputError when the deck is larger than his arrays: 100 vertices, three of them for each
/// operator's plane, and 200 vertex numbers on F cards.
void check_published_limits(const StumpDeck& deck, const std::string& name);

/// His report (Figs. 10, 13 and 17) by the FORMAT statements of the listing, without the first
/// column, which steers the printer. Numbers have one decimal; one that its field cannot hold is
/// asterisks, as in FORTRAN.
std::string published_report(const PublishedTable& table);

}  // namespace cigsim::separation_planes
