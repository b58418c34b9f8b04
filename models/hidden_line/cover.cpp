// SPDX-License-Identifier: MIT
#include "models/hidden_line/cover.hpp"

#include <algorithm>

namespace cigsim::hidden_line {
namespace {

void raise_low(Interval& piece, const Crossing& to, bool has, const Eye& eye) {
  const int order = to.compare(piece.low, eye);
  if (order > 0) {
    piece.low = to;
    piece.has_low = has;
  } else if (order == 0) {
    piece.has_low = piece.has_low && has;
  }
}

void lower_high(Interval& piece, const Crossing& to, bool has, const Eye& eye) {
  const int order = to.compare(piece.high, eye);
  if (order < 0) {
    piece.high = to;
    piece.has_high = has;
  } else if (order == 0) {
    piece.has_high = piece.has_high && has;
  }
}

// Restricts the piece to where a quantity that is linear along the edge is positive (or zero, when
// `closed`), given its signs at the ends. False when nothing is left for certain.
template <class PlaneOfSight>
bool restrict(Interval& piece, int at_a, int at_b, bool closed, const PlaneOfSight& plane,
              const SeenPoint& a, const SeenPoint& b, const Eye& eye) {
  if (at_a > 0 && at_b > 0) return true;
  if (at_a < 0 && at_b < 0) return false;
  if (!closed && at_a <= 0 && at_b <= 0) return false;
  if (at_a < 0 && at_b > 0) {
    raise_low(piece, Crossing::of(plane, a, b), closed, eye);
  } else if (at_a > 0 && at_b < 0) {
    lower_high(piece, Crossing::of(plane, a, b), closed, eye);
  } else if (at_a == 0 && at_b > 0) {
    raise_low(piece, Crossing::start(), closed, eye);
  } else if (at_a > 0 && at_b == 0) {
    lower_high(piece, Crossing::end(), closed, eye);
  } else if (at_a == 0 && at_b < 0) {
    lower_high(piece, Crossing::start(), true, eye);
  } else if (at_a < 0 && at_b == 0) {
    raise_low(piece, Crossing::end(), true, eye);
  }
  return true;
}

}  // namespace

bool covers(const Shadow& shadow, bool by_depth, const SeenPoint& point, const Eye& eye) {
  for (const OutlinePlane& o : shadow.outline) {
    const int s = o.plane.side(eye, point);
    if (s < 0 || (s == 0 && !o.closed)) return false;
  }
  if (by_depth)
    for (const Shadow::Front& f : shadow.fronts)
      if (side(*f.plane, point.position) * f.eye_side >= 0) return false;
  return !shadow.outline.empty();
}

bool covered_piece(const Shadow& shadow, bool by_depth, const SeenPoint& a, const SeenPoint& b,
                   const Eye& eye, Interval& out) {
  if (shadow.outline.empty()) return false;
  out = Interval();
  for (const OutlinePlane& o : shadow.outline)
    if (!restrict(out, o.plane.side(eye, a), o.plane.side(eye, b), o.closed, o.plane, a, b, eye))
      return false;
  if (by_depth)
    for (const Shadow::Front& f : shadow.fronts)
      if (!restrict(out, -side(*f.plane, a.position) * f.eye_side,
                    -side(*f.plane, b.position) * f.eye_side, false, *f.plane, a, b, eye))
        return false;
  const int order = out.low.compare(out.high, eye);
  return order < 0 || (order == 0 && out.has_low && out.has_high);
}

void join(std::vector<Interval>& pieces, const Eye& eye) {
  std::sort(pieces.begin(), pieces.end(), [&](const Interval& p, const Interval& q) {
    const int order = p.low.compare(q.low, eye);
    return order != 0 ? order < 0 : p.has_low && !q.has_low;
  });
  std::size_t kept = 0;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    Interval& last = pieces[kept];
    const Interval& next = pieces[i];
    const int gap = next.low.compare(last.high, eye);
    if (gap > 0 || (gap == 0 && !next.has_low && !last.has_high)) {
      pieces[++kept] = next;
      continue;
    }
    const int order = next.high.compare(last.high, eye);
    if (order > 0) {
      last.high = next.high;
      last.has_high = next.has_high;
    } else if (order == 0) {
      last.has_high = last.has_high || next.has_high;
    }
  }
  if (!pieces.empty()) pieces.resize(kept + 1);
}

}  // namespace cigsim::hidden_line
