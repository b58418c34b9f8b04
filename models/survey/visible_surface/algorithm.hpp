// SPDX-License-Identifier: MIT
// The hidden-surface algorithms that Sandor 1979 (sec. 5.2) reviews, as alternatives behind one
// interface: the same list of faces goes in, the same picture comes out, and the work is counted.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "models/survey/visible_surface/face_list.hpp"

namespace cigsim::survey {

/// Work of a picture, in the terms of Sutherland, Sproull and Schumacker 1974.
struct Work {
  std::uint64_t faces = 0;         ///< taken up
  std::uint64_t edges = 0;         ///< taken up
  std::uint64_t sorts = 0;         ///< lists put in order
  std::uint64_t comparisons = 0;   ///< of keys, extents and windows
  std::uint64_t segments = 0;      ///< pieces of lines, or windows, that were told apart
  std::uint64_t depths = 0;        ///< depths of two faces compared at a place
  std::uint64_t subdivisions = 0;  ///< windows, sample spans or polygons divided
  std::uint64_t writes = 0;        ///< elements written to the picture
  std::uint64_t exact_tests = 0;   ///< depth comparisons that needed rational arithmetic
};

/// Face numbers, row by row from the top; kNone: background.
struct FacePicture {
  Raster raster;
  std::vector<std::uint32_t> faces;

  void clear(const Raster& size) {
    raster = size;
    faces.assign(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height),
                 kNone);
  }
  std::uint32_t* line(int r) {
    return faces.data() + static_cast<std::size_t>(r) * static_cast<std::size_t>(raster.width);
  }
  void fill(int r, int first, int end, std::uint32_t face, Work& work) {
    for (std::uint32_t *e = line(r) + first, *last = line(r) + end; e < last; ++e) *e = face;
    work.writes += static_cast<std::uint64_t>(end - first);
  }
};

struct Algorithm {
  std::string_view name, year, kind;
  void (*compute)(const FaceList& list, FacePicture& out, Work& work);
  /// Relative cost for 100, 2,500 and 60,000 faces as Sutherland, Sproull and Schumacker 1974
  /// estimate it; none: the figures used here do not name it.
  std::optional<std::array<double, 3>> published_cost;
  std::string_view limit;  ///< what it leaves wrong as published; empty: nothing
};

/// Those of the survey, and a z-buffer as its plain reference, which is the last.
std::span<const Algorithm> algorithms();

/// Depth of each element compared: no sort.
void z_buffer(const FaceList& list, FacePicture& out, Work& work);
/// Windows divided into four until one face or none fills them.
void warnock(const FaceList& list, FacePicture& out, Work& work);
/// Faces sorted by depth, divided where they have no order, and written from the far end.
void newell(const FaceList& list, FacePicture& out, Work& work);
/// Priority from clusters and separating planes, resolved line by line.
void schumacker(const FaceList& list, FacePicture& out, Work& work);
/// Sample spans of a line, from the line before, divided until they are simple.
void watkins(const FaceList& list, FacePicture& out, Work& work);
/// Spans between crossings; depths compared at both ends.
void bouknight(const FaceList& list, FacePicture& out, Work& work);
/// Spans between crossings; depths compared at one end, and not again while the crossings keep
/// their order.
void wylie(const FaceList& list, FacePicture& out, Work& work);

/// Elements in which a picture of faces differs from one of colours and object numbers.
std::uint64_t differences(const FaceList& list, const FacePicture& faces, const Colour& background,
                          const Picture& picture);

}  // namespace cigsim::survey
