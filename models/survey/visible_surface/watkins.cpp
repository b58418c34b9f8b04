// SPDX-License-Identifier: MIT
// Watkins 1970, as Sandor 1979 (sec. 5.2) tells it: edges sorted by line, and on each line the
// segments of faces in order of their left ends, carried from the line before. A line is taken in
// sample spans whose ends are first guessed from what was seen on the line before. A span is
// simple when nothing falls within it, or when a segment covers it and is nearer than all others at
// both its ends. One that is not is divided: at the end of a lone segment, otherwise in the middle.
// What the published machine did with the divided span in its registers is not told; the halves are
// taken one after the other here.
#include <algorithm>

#include "models/survey/visible_surface/depth_order.hpp"
#include "models/survey/visible_surface/scan_line.hpp"

namespace cigsim::survey {
namespace {

struct Segment {
  int first, end;
  std::uint32_t face;
};

class Watkins {
 public:
  Watkins(const FaceList& list, FacePicture& out, Work& work)
      : list_(list), order_(list), out_(out), work_(work) {}

  void run() {
    ScanLines lines(list_, XSort::kBubble, work_);
    std::vector<int> ends{list_.raster.width};
    for (line_ = 0; line_ < list_.raster.height; ++line_) {
      lines.next();
      collect(lines.edges());
      seen_.clear();
      std::size_t next = 0;
      waiting_.clear();
      int first = 0;
      for (const int end : ends) {
        enter(first, end, next);
        divide(first, end, 0);
        drop(end);
        first = end;
      }
      ends.swap(seen_);
    }
    work_.exact_tests += order_.exact_tests();
  }

 private:
  // Segments by their first elements.
  void collect(const std::vector<LineEdge>& edges) {
    segments_.clear();
    for (const LineEdge& edge : edges)
      if (edge.left)
        segments_.push_back(
            {edge.element, list_.row(list_.faces[edge.face], line_).end, edge.face});
  }

  // Segments that begin before `end` are taken up; waiting_ holds those that meet the span.
  void enter(int first, int end, std::size_t& next) {
    for (; next < segments_.size() && segments_[next].first < end; ++next) {
      ++work_.comparisons;
      if (segments_[next].end > first) waiting_.push_back(segments_[next]);
    }
  }
  void drop(int end) {
    work_.comparisons += waiting_.size();
    std::erase_if(waiting_, [end](const Segment& s) { return s.end <= end; });
  }

  void show(int first, int end, std::uint32_t face) {
    ++work_.segments;
    if (face != kNone) out_.fill(line_, first, end, face, work_);
    if (!seen_.empty() && shown_ == face)
      seen_.back() = end;
    else
      seen_.push_back(end);
    shown_ = face;
  }

  bool nearer(std::uint32_t a, std::uint32_t b, int x) {
    ++work_.depths;
    return order_.nearer(a, b, x, line_);
  }

  // The segments of waiting_ from `from` on are those that may meet the span.
  void divide(int first, int end, std::size_t from) {
    const std::size_t begin = waiting_.size();
    for (std::size_t i = from; i < begin; ++i) {
      ++work_.comparisons;
      if (waiting_[i].first < end && waiting_[i].end > first) waiting_.push_back(waiting_[i]);
    }
    if (!settle(first, end, begin)) {
      ++work_.subdivisions;
      const int middle = place_to_divide(first, end, begin);
      divide(first, middle, begin);
      divide(middle, end, begin);
    }
    waiting_.resize(begin);
  }

  bool settle(int first, int end, std::size_t begin) {
    std::uint32_t best = kNone;
    for (std::size_t i = begin; i < waiting_.size(); ++i) {
      const Segment& s = waiting_[i];
      if (s.first <= first && s.end >= end && (best == kNone || nearer(s.face, best, first)))
        best = s.face;
    }
    if (best == kNone && waiting_.size() > begin) return false;
    for (std::size_t i = begin; i < waiting_.size(); ++i) {
      const std::uint32_t face = waiting_[i].face;
      if (face == best) continue;
      if (!nearer(best, face, first) || (end - first > 1 && !nearer(best, face, end - 1)))
        return false;
    }
    show(first, end, best);
    return true;
  }

  int place_to_divide(int first, int end, std::size_t begin) const {
    if (waiting_.size() == begin + 1) {
      const Segment& lone = waiting_[begin];
      return lone.first > first ? lone.first : lone.end;
    }
    return first + (end - first) / 2;
  }

  const FaceList& list_;
  const DepthOrder order_;
  FacePicture& out_;
  Work& work_;
  int line_ = 0;
  std::vector<Segment> segments_;
  std::vector<Segment> waiting_;  // then those of the spans on the way down
  std::vector<int> seen_;         // ends of what was seen on this line
  std::uint32_t shown_ = kNone;
};

}  // namespace

void watkins(const FaceList& list, FacePicture& out, Work& work) {
  out.clear(list.raster);
  Watkins(list, out, work).run();
}

}  // namespace cigsim::survey
