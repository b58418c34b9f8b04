// SPDX-License-Identifier: MIT
// Warnock 1969, as Sandor 1979 (sec. 5.2) tells it: a sample window is done when no face falls
// within it, or when one face covers it and is nearer than every other there; otherwise it is
// divided into four, down to the element. A window hands on to its quarters only the faces that
// meet it, and tells them which of these cover it.
//
// A face's left boundary is convex and its right one concave, so that two rows tell whether it
// covers a window, and the window's corners whether it is nearer than another: depth is linear.
// That the first window is the smallest square of 2^k elements over the raster is a reconstruction.
#include <algorithm>
#include <bit>
#include <vector>

#include "models/survey/visible_surface/algorithm.hpp"
#include "models/survey/visible_surface/depth_order.hpp"

namespace cigsim::survey {
namespace {

class Warnock {
 public:
  Warnock(const FaceList& list, FacePicture& out, Work& work)
      : list_(list), order_(list), out_(out), work_(work) {}

  void run() {
    const auto side = static_cast<unsigned>(std::max(list_.raster.width, list_.raster.height));
    for (std::uint32_t f = 0; f < list_.faces.size(); ++f)
      if (list_.faces[f].end_element > 0) faces_.push_back({f, false});
    work_.faces += faces_.size();
    divide({0, 0, static_cast<int>(std::bit_ceil(side))}, 0, faces_.size());
    work_.exact_tests += order_.exact_tests();
  }

 private:
  struct Window {
    int x, y, size;
  };
  /// The elements of a window that the raster has.
  struct Area {
    int x0, y0, x1, y1;
  };
  struct Entry {
    std::uint32_t face;
    bool covers;
  };
  enum class Relation { kOutside, kMeets, kCovers };

  Relation relation(const SurveyFace& face, const Area& a) {
    ++work_.comparisons;
    if (face.end_element <= a.x0 || face.first_element >= a.x1 || face.end_line <= a.y0 ||
        face.first_line >= a.y1)
      return Relation::kOutside;
    const int top = std::max(face.first_line, a.y0), bottom = std::min(face.end_line, a.y1) - 1;
    const Row &first = list_.row(face, top), &last = list_.row(face, bottom);
    if (top == a.y0 && bottom == a.y1 - 1 && std::max(first.first, last.first) <= a.x0 &&
        std::min(first.end, last.end) >= a.x1)
      return Relation::kCovers;
    // Rows at the two ends to one side do not settle it; small windows are looked at row by row.
    if (bottom - top < kRowsTested) {
      bool meets = false;
      for (int r = top; r <= bottom && !meets; ++r) {
        const Row& row = list_.row(face, r);
        meets = std::max<int>(row.first, a.x0) < std::min<int>(row.end, a.x1);
      }
      if (!meets) return Relation::kOutside;
    }
    return Relation::kMeets;
  }

  // True when face `a` is nearer than `b` wherever the window has an element.
  bool nearer_throughout(std::uint32_t a, std::uint32_t b, const Area& w) {
    for (const int y : {w.y0, w.y1 - 1})
      for (const int x : {w.x0, w.x1 - 1}) {
        ++work_.depths;
        if (!order_.nearer(a, b, x, y)) return false;
      }
    return true;
  }

  // The faces [begin, end) of faces_ meet the window's parent, or are all.
  void divide(const Window& window, std::size_t begin, std::size_t end) {
    const Area area{window.x, window.y, std::min(window.x + window.size, list_.raster.width),
                    std::min(window.y + window.size, list_.raster.height)};
    if (area.x0 >= area.x1 || area.y0 >= area.y1) return;
    const std::size_t first = faces_.size();
    for (std::size_t i = begin; i < end; ++i) {
      const Entry entry = faces_[i];
      const Relation found =
          entry.covers ? Relation::kCovers : relation(list_.faces[entry.face], area);
      if (found != Relation::kOutside) faces_.push_back({entry.face, found == Relation::kCovers});
    }
    if (!settle(area, first)) {
      ++work_.subdivisions;
      const std::size_t last = faces_.size();
      const int half = window.size / 2;
      for (const int dy : {0, half})
        for (const int dx : {0, half}) divide({window.x + dx, window.y + dy, half}, first, last);
    }
    faces_.resize(first);
  }

  // Shows the window if it is homogeneous or a single element. Faces from `first` on meet it.
  bool settle(const Area& w, std::size_t first) {
    if (faces_.size() == first) {
      ++work_.segments;
      return true;
    }
    const bool element = w.x1 - w.x0 == 1 && w.y1 - w.y0 == 1;
    std::uint32_t best = kNone;
    for (std::size_t i = first; i < faces_.size(); ++i) {
      if (!faces_[i].covers) continue;
      if (best == kNone || nearer_first(faces_[i].face, best, w)) best = faces_[i].face;
    }
    if (best == kNone) return element;  // of an element, no face covers the sample
    if (!element)
      for (std::size_t i = first; i < faces_.size(); ++i)
        if (faces_[i].face != best && !nearer_throughout(best, faces_[i].face, w)) return false;
    ++work_.segments;
    for (int r = w.y0; r < w.y1; ++r) out_.fill(r, w.x0, w.x1, best, work_);
    return true;
  }

  bool nearer_first(std::uint32_t a, std::uint32_t b, const Area& w) {
    ++work_.depths;
    return order_.nearer(a, b, w.x0, w.y0);
  }

  static constexpr int kRowsTested = 8;

  const FaceList& list_;
  const DepthOrder order_;
  FacePicture& out_;
  Work& work_;
  std::vector<Entry> faces_;  // of all windows on the way down, one after the other
};

}  // namespace

void warnock(const FaceList& list, FacePicture& out, Work& work) {
  out.clear(list.raster);
  Warnock(list, out, work).run();
}

}  // namespace cigsim::survey
