// SPDX-License-Identifier: MIT
// Steps 1, 5 and 6 of the algorithm (Levine 1975, ch. VI.F): the SO matrix, the invisibility of a
// vertex, and the edges.
#include "models/hidden_line/hidden_lines.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace cigsim::hidden_line {

HiddenLines::HiddenLines(PartSet set, std::span<const Plane> candidates, const SeplLimits& limits)
    : set_(std::move(set)) {
  if (set_.parts.size() > kMostParts)
    throw std::invalid_argument("there are " + std::to_string(set_.parts.size()) +
                                " solids and figures, more than " + std::to_string(kMostParts));
  for (const Part& part : set_.parts) {
    if (part.vertices.empty() || part.edges.empty())
      throw std::invalid_argument("a part has no vertices or no edges");
    SeenPart seen;
    seen.front.resize(part.faces.size());
    seen.kind.resize(part.edges.size());
    seen.display.resize(part.edges.size());
    seen.invisibility.assign(part.vertices.size(), kUnknown);
    seen.points.reserve(part.vertices.size());
    seen.cells.resize(std::max<std::size_t>(part.cells.size(), 1));
    seen_.push_back(std::move(seen));
    auto& at = edges_at_.emplace_back(part.vertices.size());
    for (std::uint32_t e = 0; e < part.edges.size(); ++e) {
      at[part.edges[e].a].push_back(e);
      at[part.edges[e].b].push_back(e);
    }
  }
  seam_closed_.resize(set_.seams.size());
  sepl_ = Sepl(set_.parts, candidates, limits);
}

void HiddenLines::compute(const ViewTransform& view, bool with_hidden) {
  const std::uint64_t exact_before = exact_turns();
  eye_ = Eye(view);
  with_hidden_ = with_hidden;
  counters_ = {};
  pieces_.clear();
  disagreements_ = 0;
  sepl_.mark(view.eye);
  for (std::size_t i = 0; i < seen_.size(); ++i) see(i);
  resolve_seams();
  for (std::size_t i = 0; i < seen_.size(); ++i)
    if (seen_[i].active && set_.parts[i].kind == PartKind::kFigure) classify_figure(i);
  for (std::size_t i = 0; i < seen_.size(); ++i) make_cells(i);
  for (std::size_t i = 0; i < seen_.size(); ++i) make_windows(i);
  for (std::size_t i = 0; i < seen_.size(); ++i)
    if (seen_[i].active) process(i);
  counters_.exact = exact_turns() - exact_before;
}

void HiddenLines::find_hiders(std::size_t index) {
  hiders_.clear();
  hider_count_ = 0;
  const std::uint32_t object = set_.parts[index].object;
  for (std::size_t m = 0; m < seen_.size(); ++m) {
    const SeenPart& other = seen_[m];
    if (m == index || !other.active || other.cells.front().outline.empty()) continue;
    const Sepl::Answer answer = sepl_.may_hide(m, index);
    if (answer == Sepl::Answer::kCannotHide) continue;
    ++hider_count_;
    if (!other.window.meets(seen_[index].window)) continue;
    // Figures of one body meet along edges, which only their depth tells from being covered.
    const bool by_depth = answer == Sepl::Answer::kUnresolved || set_.parts[m].object == object;
    hiders_.push_back({&other, by_depth});
  }
}

void HiddenLines::process(std::size_t index) {
  const Part& part = set_.parts[index];
  SeenPart& seen = seen_[index];
  if (std::none_of(seen.display.begin(), seen.display.end(), [](char d) { return d != 0; }) &&
      !with_hidden_)
    return;
  find_hiders(index);
  done_.assign(part.edges.size(), 0);
  for (std::uint32_t first = 0; first < part.edges.size(); ++first) {
    if (!seen.display[first] || done_[first]) continue;
    const std::uint32_t start = part.edges[first].a;
    if (seen.invisibility[start] == kUnknown)
      seen.invisibility[start] = invisibility_of(seen.points[start]);
    stack_.assign(1, start);
    while (!stack_.empty()) {
      const std::uint32_t vertex = stack_.back();
      stack_.pop_back();
      for (const std::uint32_t e : edges_at_[index][vertex]) {
        if (!seen.display[e] || done_[e]) continue;
        done_[e] = 1;
        process_edge(index, e, vertex);
        stack_.push_back(part.edges[e].a == vertex ? part.edges[e].b : part.edges[e].a);
      }
    }
  }
  // A solid with the eye in it is not seen at all.
  if (!with_hidden_ || part.kind != PartKind::kSolid || seen.cells.front().fronts.empty()) return;
  for (std::uint32_t e = 0; e < part.edges.size(); ++e)
    if (seen.kind[e] == EdgeKind::kBack && part.edges[e].drawn == Drawn::kAlways)
      pieces_.push_back({static_cast<std::uint32_t>(index), e, 0, 1, false});
}

int HiddenLines::invisibility_of(const SeenPoint& vertex) {
  counters_.objects_considered_inv += hider_count_;
  const Window at = window_of(vertex, vertex);
  int count = 0;
  for (const Hider& hider : hiders_) {
    if (!hider.part->window.meets(at)) continue;
    ++counters_.objects_in_window_inv;
    counters_.edges_considered_inv += hider.part->outline().size();
    count += covered_by(hider, vertex);
  }
  return count;
}

bool HiddenLines::covered_by(const Hider& hider, const SeenPoint& vertex) {
  const std::vector<OutlinePlane>& outline = hider.part->outline();
  bool regular = vertex.ahead && hider.part->ahead && !hider.by_depth, inside = false;
  for (std::size_t i = 0; regular && i < outline.size(); ++i) {
    const SightPlane& line = outline[i].plane;
    const int p = eye_.above(vertex, *line.p), q = eye_.above(vertex, *line.q);
    if (p == 0 || q == 0) regular = false;
    // The source computes an intersection when an end lies on or below the ray.
    if (p > 0 && q > 0) continue;
    ++counters_.intersections_computed_inv;
    if (p == q) continue;
    const int turn = line.side(eye_, vertex);
    if (turn == 0) regular = false;
    if (turn == q) inside = !inside;
  }
  if (regular) return inside;
  ++counters_.decided_by_shadow;
  return std::any_of(hider.part->cells.begin(), hider.part->cells.end(), [&](const Shadow& cell) {
    return covers(cell, hider.by_depth, vertex, eye_);
  });
}

void HiddenLines::process_edge(std::size_t index, std::uint32_t edge, std::uint32_t from) {
  const Part& part = set_.parts[index];
  SeenPart& seen = seen_[index];
  const bool reversed = part.edges[edge].a != from;
  const std::uint32_t to = reversed ? part.edges[edge].a : part.edges[edge].b;
  const SeenPoint &a = seen.points[from], &b = seen.points[to];
  ++counters_.edges_displayed;
  counters_.objects_considered += hider_count_;
  events_.clear();
  const Window rectangle = window_of(a, b);
  for (const Hider& hider : hiders_) {
    if (!hider.part->window.meets(rectangle)) continue;
    ++counters_.objects_in_window;
    counters_.edges_considered += hider.part->outline().size();
    meet(hider, a, b, rectangle);
  }
  const int count = walk(index, edge, reversed, seen.invisibility[from]);
  int& known = seen.invisibility[to];
  disagreements_ += known != kUnknown && known != count;
  if (known == kUnknown) known = count;
}

void HiddenLines::meet(const Hider& hider, const SeenPoint& a, const SeenPoint& b,
                       const Window& rectangle) {
  const bool regular = a.ahead && b.ahead && hider.part->ahead && !hider.by_depth;
  const std::size_t before = events_.size();
  if (regular) {
    if (meet_regularly(hider, a, b, rectangle)) {
      counters_.actual_intersections += events_.size() - before;
      return;
    }
    events_.resize(before, {Crossing::start(), 0});
  } else {
    counters_.intersections_computed += hider.part->outline().size();
  }
  ++counters_.decided_by_shadow;
  meet_shadow(hider, a, b);
  counters_.actual_intersections += events_.size() - before;
}

// False when a vertex of one lies in line with the other.
bool HiddenLines::meet_regularly(const Hider& hider, const SeenPoint& a, const SeenPoint& b,
                                 const Window& rectangle) {
  const std::vector<OutlinePlane>& outline = hider.part->outline();
  const SightPlane edge(a, b);
  bool regular = true;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (!hider.part->rectangles[i].meets(rectangle)) continue;
    ++counters_.intersections_computed;
    if (!regular) continue;
    const SightPlane& line = outline[i].plane;
    const int at_a = line.side(eye_, a), at_b = line.side(eye_, b);
    if (at_a == at_b && at_a != 0) continue;
    const int at_p = edge.side(eye_, *line.p), at_q = edge.side(eye_, *line.q);
    if (at_p == at_q && at_p != 0) continue;
    if (at_a * at_b * at_p * at_q == 0) {
      regular = false;
      continue;
    }
    events_.push_back({Crossing::of(line, a, b), at_b});
  }
  return regular;
}

void HiddenLines::meet_shadow(const Hider& hider, const SeenPoint& a, const SeenPoint& b) {
  intervals_.clear();
  Interval piece;
  for (const Shadow& cell : hider.part->cells)
    if (covered_piece(cell, hider.by_depth, a, b, eye_, piece)) intervals_.push_back(piece);
  if (intervals_.size() > 1) join(intervals_, eye_);
  for (const Interval& i : intervals_) {
    if (!(i.low.kind() == Crossing::Kind::kStart && i.has_low)) events_.push_back({i.low, 1});
    if (!(i.high.kind() == Crossing::Kind::kEnd && i.has_high)) events_.push_back({i.high, -1});
  }
}

// Goes along the edge through the sorted events; returns the invisibility of the other end.
int HiddenLines::walk(std::size_t index, std::uint32_t edge, bool reversed, int count) {
  std::sort(events_.begin(), events_.end(),
            [&](const Event& p, const Event& q) { return p.at.compare(q.at, eye_) < 0; });
  double from = 0;
  bool visible = count == 0;
  const auto close = [&](double to) {
    const double low = reversed ? 1 - to : from, high = reversed ? 1 - from : to;
    if (high > low && (visible || with_hidden_))
      pieces_.push_back({static_cast<std::uint32_t>(index), edge, low, high, visible});
  };
  for (std::size_t i = 0; i < events_.size();) {
    const Crossing& at = events_[i].at;
    const double t = at.t(eye_);
    std::size_t next = i;
    for (; next < events_.size() && events_[next].at.compare(at, eye_) == 0; ++next)
      count += events_[next].change;
    const bool now = count == 0;
    if (at.kind() == Crossing::Kind::kStart) {
      visible = now;
    } else if (at.kind() == Crossing::Kind::kInside && now != visible) {
      close(t);
      from = t;
      visible = now;
    }
    i = next;
  }
  close(1);
  return count;
}

}  // namespace cigsim::hidden_line
