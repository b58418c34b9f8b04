// SPDX-License-Identifier: MIT
// The one list of faces that the hidden-surface algorithms of the survey share (Sandor 1979, sec.
// 5; after Sutherland, Sproull and Schumacker 1974): front faces, clipped and projected, with the
// elements that they cover on each line and their depth over the raster.
//
// Everything is exact. A face covers a sample by the project's rule (design, section 7): a sample
// on an edge belongs to the face on its right, or below a level edge. Depth is 1/u, the reciprocal
// of the distance along the line of sight. It is linear over the raster, as Sandor's perspective
// depth d - d^2/z' is, and orders points alike (sec. 3.2). Samples count as moved a little to the
// right and much less down, so that an edge and the depth at it are decided alike.
#pragma once

#include <cstdint>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "models/numeric/number.hpp"

namespace cigsim::survey {

/// Elements [first, end) of a line, 0..width; first <= end.
struct Row {
  std::uint16_t first = 0, end = 0;
};

/// Depth a x + b y + c at element (x, y); larger is nearer. No two planes of a list are equal.
struct DepthPlane {
  Exact a, b, c;
};

/// The same, rounded; `slack` bounds the error of the depth at any place of the raster.
struct RoundedPlane {
  double a = 0, b = 0, c = 0, slack = 0;
};

/// A place of the raster in elements, from the first element's sample point.
struct RasterPlace {
  Exact x, y;
};

/// A convex face. Its place in the list is its place in the input: of coplanar faces the earlier
/// one is seen.
struct SurveyFace {
  std::uint32_t object = 0;
  Colour colour;
  /// 0: an object's face, ordered by depth. Ground faces have ranks of their own, since they lie
  /// behind all objects in a fixed order (Stump 1986, ch. II); a lower rank is in front.
  std::uint32_t rank = 0;
  std::uint32_t plane = 0;  ///< into planes and rounded
  std::uint32_t first_place = 0, place_count = 0;
  int first_line = 0, end_line = 0;        ///< its rows
  int first_element = 0, end_element = 0;  ///< of all its rows
  std::uint32_t first_row = 0;             ///< into rows: that of first_line

  std::size_t row(int line) const {
    return first_row + static_cast<std::size_t>(line - first_line);
  }
};

/// An edge that crosses the lines [first_line, end_line). On a line it stands at its face's row:
/// a left edge at the first element, a right one at the end.
struct SurveyEdge {
  std::uint32_t face = 0;
  int first_line = 0, end_line = 0;
  bool left = false;
};

struct FaceList {
  Raster raster;
  std::vector<SurveyFace> faces;  ///< in the order of the input: objects by number, then the ground
  std::vector<Row> rows;
  std::vector<DepthPlane> planes;
  std::vector<RoundedPlane> rounded;
  std::vector<RasterPlace> places;
  std::vector<SurveyEdge> edges;  ///< those that cross a line, face by face

  /// Schumacker's data: faces from the highest priority to the lowest, by the order of clusters
  /// (the items of the database) and the fixed order within each; separating planes that the eye
  /// was compared with.
  std::vector<std::uint32_t> priority;
  std::uint64_t clusters = 0, plane_tests = 0;

  const Row& row(const SurveyFace& face, int line) const { return rows[face.row(line)]; }
};

/// The faces of `items`, which stand in the order of their priority, highest first. `sets` by
/// SetId. Faces turned away, seen edge on, or outside the raster are left out.
FaceList make_face_list(const ViewTransform& view, const FaceSet* const (&sets)[3],
                        const std::vector<ItemRef>& items);

}  // namespace cigsim::survey
