// SPDX-License-Identifier: MIT
#include "sim/drawing/name_places.hpp"

#include <algorithm>
#include <cmath>

namespace cigsim {
namespace {

// Directions in which a name may lie, the best first: a mark's upper right.
constexpr Vec2 kDirections[] = {{0.8, -0.6}, {1, 0}, {0.8, 0.6}, {-0.8, -0.6}, {-0.8, 0.6},
                                {-1, 0},     {0, 1}, {0, -1},    {0.5, -0.9},  {-0.5, 0.9}};
constexpr double kDistances[] = {7, 12, 20, 32, 46, 64, 86, 112, 142, 176, 214};
constexpr double kBeside = 8;       // up to here a name needs no line to its mark
constexpr double kMark = 4;         // half the size of a mark
constexpr double kGap = 2;          // between names
constexpr double kCoversMark = 25;  // as bad as so many pixels further away
constexpr double kLineOverName = 200;
constexpr double kLaterDirection = 0.4;

bool overlap(const PixelBox& a, const PixelBox& b, double gap) {
  return a.left < b.right + gap && b.left < a.right + gap && a.top < b.bottom + gap &&
         b.top < a.bottom + gap;
}

bool inside(const PixelBox& box, const PixelBox& frame) {
  return box.left >= frame.left && box.right <= frame.right && box.top >= frame.top &&
         box.bottom <= frame.bottom;
}

Vec2 nearest(const PixelBox& box, const Vec2& to) {
  return {std::clamp(to.x, box.left, box.right), std::clamp(to.y, box.top, box.bottom)};
}

// From `at` along one coordinate: begins, ends or is centred there.
double begin_of(double at, double direction, double size) {
  constexpr double kStraight = 0.3;
  if (direction > kStraight) return at;
  return direction < -kStraight ? at - size : at - size / 2;
}

PixelBox box_of(const NamedMark& name, const Vec2& direction, double distance) {
  const double left = begin_of(name.at.x + distance * direction.x, direction.x, name.width);
  const double top = begin_of(name.at.y + distance * direction.y, direction.y, name.height);
  return {left, top, left + name.width, top + name.height};
}

bool line_meets(const Vec2& from, const Vec2& to, const PixelBox& box) {
  constexpr int kSteps = 32;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    const Vec2 at{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
    if (overlap({at.x, at.y, at.x, at.y}, box, 1)) return true;
  }
  return false;
}

class Places {
 public:
  Places(std::span<const Vec2> marks, const PixelBox& frame) : marks_(marks), frame_(frame) {}

  std::optional<NamePlace> place(const NamedMark& name) {
    std::optional<NamePlace> best;
    double least = 0;
    for (const double distance : kDistances) {
      double penalty = 0;
      for (const Vec2& direction : kDirections) {
        const PixelBox box = box_of(name, direction, distance);
        const bool in_line = name.beside && direction.y == 0;
        const double later =
            in_line ? -direction.x * kLaterDirection / 2 - kLaterDirection : penalty;
        const double cost = distance + later + cost_of(name, box, distance);
        penalty += kLaterDirection;
        if (!free(box) || (best && cost >= least)) continue;
        best = NamePlace{box, {}};
        if (distance > kBeside) best->leader = nearest(box, name.at);
        least = cost;
      }
    }
    if (best) placed_.push_back(*best);
    return best;
  }

 private:
  bool free(const PixelBox& box) const {
    return inside(box, frame_) &&
           std::none_of(placed_.begin(), placed_.end(),
                        [&](const NamePlace& other) { return overlap(other.box, box, kGap); });
  }
  double cost_of(const NamedMark& name, const PixelBox& box, double distance) const {
    double cost = 0;
    for (const Vec2& mark : marks_)
      if (overlap({mark.x, mark.y, mark.x, mark.y}, box, kMark)) cost += kCoversMark;
    if (distance <= kBeside) return cost;
    for (const NamePlace& other : placed_)
      if (line_meets(name.at, nearest(box, name.at), other.box)) cost += kLineOverName;
    return cost;
  }

  std::span<const Vec2> marks_;
  const PixelBox& frame_;
  std::vector<NamePlace> placed_;
};

}  // namespace

std::vector<std::optional<NamePlace>> place_names(std::span<const NamedMark> names,
                                                  std::span<const Vec2> marks,
                                                  const PixelBox& frame) {
  Places places(marks, frame);
  std::vector<std::optional<NamePlace>> out;
  for (const NamedMark& name : names) out.push_back(places.place(name));
  return out;
}

}  // namespace cigsim
