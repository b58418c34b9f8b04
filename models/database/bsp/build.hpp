// SPDX-License-Identifier: MIT
// Building a BSP tree (Fuchs, Kedem, Naylor 1980: Make_tree), without recursion.
#pragma once

#include <functional>

#include "models/database/bsp/polygons.hpp"
#include "models/database/bsp/root_choice.hpp"
#include "models/database/bsp/tree.hpp"

namespace cigsim {

struct BspOptions {
  RootOptions root;
  /// Called now and then with a share of the work in 0..1.
  std::function<void(double)> progress;
};

/// The tree of all polygons of the set. Side tests and cuts are exact. The same polygons and
/// options give the same tree everywhere.
///
/// A list of faces of one convex body needs no choice: each face has all others behind it, so they
/// become a chain without any test. That is also why the tree of a convex body is as deep as it has
/// faces.
BspTree build_bsp(BspPolygons polygons, const BspOptions& options = {});

}  // namespace cigsim
