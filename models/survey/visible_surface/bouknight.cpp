// SPDX-License-Identifier: MIT
// Bouknight 1970, as Sandor 1979 (sec. 5.2) tells it: edges sorted by line, crossings by element
// with exchanges from the order of the line before, and in each span between two crossings the
// depths of the faces there compared. They are compared at both ends: where another face is nearer
// at the right one, the two pass through each other, and the span is divided where they do.
#include <algorithm>

#include "models/survey/visible_surface/depth_order.hpp"
#include "models/survey/visible_surface/scan_line.hpp"

namespace cigsim::survey {
namespace {

class SpanSearch {
 public:
  SpanSearch(const DepthOrder& order, int line, Work& work)
      : order_(order), line_(line), work_(work) {}

  std::uint32_t nearest(const std::vector<std::uint32_t>& faces, int x) {
    std::uint32_t best = faces.front();
    for (std::size_t i = 1; i < faces.size(); ++i)
      if (nearer(faces[i], best, x)) best = faces[i];
    return best;
  }

  /// The first element of (first, end) at which some face is nearer than `seen`, which is the
  /// nearest at `first`; `end` if there is none.
  int first_passed(const std::vector<std::uint32_t>& faces, std::uint32_t seen, int first,
                   int end) {
    int at = end;
    for (const std::uint32_t f : faces) {
      if (f == seen || at - first < 2 || !nearer(f, seen, at - 1)) continue;
      ++work_.subdivisions;
      int not_yet = first, passed = at - 1;
      while (passed - not_yet > 1) {
        const int middle = not_yet + (passed - not_yet) / 2;
        (nearer(f, seen, middle) ? passed : not_yet) = middle;
      }
      at = passed;
    }
    return at;
  }

 private:
  bool nearer(std::uint32_t a, std::uint32_t b, int x) {
    ++work_.depths;
    return order_.nearer(a, b, x, line_);
  }

  const DepthOrder& order_;
  int line_;
  Work& work_;
};

}  // namespace

void bouknight(const FaceList& list, FacePicture& out, Work& work) {
  out.clear(list.raster);
  const DepthOrder order(list);
  ScanLines lines(list, XSort::kBubble, work);
  ActiveFaces active(list.faces.size());
  for (int r = 0; r < list.raster.height; ++r) {
    lines.next();
    SpanSearch search(order, r, work);
    for_each_span(lines.edges(), active,
                  [&](int first, int end, const std::vector<std::uint32_t>& faces) {
                    while (first < end) {
                      const std::uint32_t seen = search.nearest(faces, first);
                      const int passed = search.first_passed(faces, seen, first, end);
                      ++work.segments;
                      out.fill(r, first, passed, seen, work);
                      first = passed;
                    }
                  });
  }
  work.exact_tests += order.exact_tests();
}

}  // namespace cigsim::survey
