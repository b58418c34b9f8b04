// SPDX-License-Identifier: MIT
// The geometry processor on machine words (Sandor 1979, sec. 4.3 and 5.1; back faces also Stump
// 1986, ch. II): vertices into the viewpoint system, back faces out, faces clipped by Sutherland
// and Hodgman's method and projected, edges set up for the raster.
// docs/machine/geometry_processor.md gives the rules (GP…) that are cited here. The words and their
// formats are reconstruction.
//
// The walk is the functional and the timed level's: what goes in and out, and what a step costs, is
// the business of a `Pace`.
#pragma once

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "models/geometry_processor/figures.hpp"
#include "models/geometry_processor/memory.hpp"

namespace cigsim::geometry_processor {

/// Steps of the walk, which the timed level knows the costs of.
enum class Step : std::uint8_t {
  kItem,
  kLateItem,
  kDropItem,
  kVertexOut,
  kVertexIn,
  kVertices,
  kItemOut,
  kLateFace,
  kDropFace,
  kBack,
  kShown,
  kCorner,
  kOutside,
  kWhole,
  kWholeOver,
  kClip,
  kPlanePassed,
  kPlane,
  kBothIn,
  kLeaving,
  kBothOut,
  kEntering,
  kPlaneDone,
  kClippedAway,
  kProject,
  kProjectOver,
  kProjectCorner,
  kProjected,
  kPoints,
  kLevel,
  kLong,
  kEdgeOut,
  kShort,
  kShortOut,
  kMade,
  kFaceOut,
  kNoFace,
  kCount
};

/// num / den toward zero, in 1.30 of which `fraction` bits are the machine's; |num| <= den, den > 0
/// (GP7). |num| and den below 2^34.
inline Word quotient(std::int64_t num, std::int64_t den, int fraction) {
  const auto size = static_cast<std::uint64_t>(num < 0 ? -num : num);
  const auto divisor = static_cast<std::uint64_t>(den);
  const std::uint64_t bits =
      size >= divisor ? std::uint64_t{1} << fraction : (size << fraction) / divisor;
  const auto value = static_cast<std::int64_t>(bits << (kQuotientFraction - fraction));
  return static_cast<Word>(num < 0 ? -value : value);
}

/// dx / dy in 13.18 of which `fraction` fraction bits are the machine's, to nearest, halves away
/// from zero; dy > 1 line (GP13).
inline Word slope_of(std::int64_t dx, std::int64_t dy, int fraction) {
  const auto size = static_cast<std::uint64_t>(dx < 0 ? -dx : dx);
  const std::uint64_t bits = (size << (fraction + 1)) / static_cast<std::uint64_t>(dy);
  const auto value = static_cast<std::int64_t>((bits + 1) / 2 << (kRasterFraction - fraction));
  return static_cast<Word>(dx < 0 ? -value : value);
}

inline constexpr std::int64_t kOne = std::int64_t{1} << kQuotientFraction;
inline constexpr Word kHalfElement = 1 << (kRasterFraction - 1);

/// `Pace` has: spend(Step, times), take() -> ItemWord, late() -> bool, edge(EdgeWord),
/// face(FaceWord). All but what they give back happens at the cycle that the steps have led to.
template <class Pace>
class FaceWalk {
 public:
  /// Throws std::invalid_argument for a raster that 13.18 does not hold.
  FaceWalk(const MachineDescription& machine, Pace& pace)
      : pace_(pace),
        formats_(machine.formats),
        hither_(machine.hither),
        edge_capacity_(machine.edge_capacity),
        face_capacity_(machine.face_capacity) {
    check_raster(machine.raster);
  }

  static void check_raster(const Raster& raster) {
    if (raster.width > kMostElements || raster.height > kMostElements)
      throw std::invalid_argument(
          "the geometry processor's raster words (13.18) hold 8191 lines of 8191 elements at most; "
          "take a smaller raster");
  }

  /// All items up to the end word; that is left to the caller's pace. Adds to `figures`.
  void run(const GeometryBank& bank, Figures& figures) {
    bank_ = &bank;
    figures_ = &figures;
    width_ = bank.view.raster.width;
    height_ = bank.view.raster.height;
    edges_ = faces_ = 0;
    bool dropping = false;
    for (;;) {
      const ItemWord word = pace_.take();
      if (word.end) return;
      const FaceMemory& memory = *bank.sets[static_cast<std::size_t>(word.set)];
      const Word* item = &memory.items[word.item * kItemWords];
      if (!dropping && pace_.late()) {  // GP16
        pace_.spend(Step::kLateItem);
        dropping = true;
      }
      if (dropping) {
        pace_.spend(Step::kDropItem);
        figures.dropped += static_cast<std::uint32_t>(item[kFaceCount]);
      } else {
        dropping = !process_item(memory, item);
      }
    }
  }

 private:
  static constexpr int kMostElements = 8191;
  static constexpr int kPlanes = 5;  // hither, then the sides (GP3)

  struct Point {
    Word u, v, w;
    friend bool operator==(const Point&, const Point&) = default;
  };
  struct RasterPoint {
    Word x, y;
  };
  struct Vertex {
    Word d[3];
    Point p;
    RasterPoint raster;
    std::uint8_t code;
  };
  enum class Outcome : std::uint8_t { kDone, kOver };

  /// False when the frame's list ends here.
  bool process_item(const FaceMemory& memory, const Word* item) {
    pace_.spend(Step::kItem);
    const std::uint8_t all =
        transform(&memory.vertices[static_cast<std::size_t>(item[kFirstVertex])],
                  static_cast<std::size_t>(item[kVertexCount]));
    pace_.spend(all == 0 ? Step::kVertices : Step::kItemOut);
    if (all != 0) return true;
    const Word* face = &memory.faces[static_cast<std::size_t>(item[kFirstFace])];
    for (Word left = item[kFaceCount]; left > 0; --left, face += kFaceWords) {
      if (begin_face(memory, face) == Outcome::kOver) {
        pace_.spend(Step::kDropFace);
        figures_->dropped += static_cast<std::uint32_t>(left);
        return false;
      }
    }
    return true;
  }

  // The planes outside of which all vertices lie.
  std::uint8_t transform(const Word* from, std::size_t count) {
    if (vertices_.size() < count) vertices_.resize(count);
    const ViewWords& view = bank_->view;
    std::uint8_t all = 0x1f;
    for (std::size_t i = 0; i < count; ++i, from += kVertexWords) {
      Vertex& vertex = vertices_[i];
      for (int axis = 0; axis < 3; ++axis)  // GP1: both have coordinate_bits, so that this fits
        vertex.d[axis] = static_cast<Word>(Accumulator{from[axis]} - view.eye[axis]);
      vertex.p = {rotated(view.matrix[0], vertex.d), rotated(view.matrix[1], vertex.d),
                  rotated(view.matrix[2], vertex.d)};
      vertex.code = outcode(vertex.p);
      all &= vertex.code;
      if (vertex.code == 0) {
        vertex.raster = project(vertex.p);
        pace_.spend(Step::kVertexIn);
      } else {
        pace_.spend(Step::kVertexOut);
      }
    }
    return all;
  }

  Word rotated(const Word* row, const Word* d) {  // GP2
    const Accumulator sum =
        Accumulator{row[0]} * d[0] + Accumulator{row[1]} * d[1] + Accumulator{row[2]} * d[2];
    return static_cast<Word>(saturate(round_shift(sum, kDirectionFraction),
                                      formats_.coordinate_bits + 1, figures_->overflows));
  }

  std::int64_t distance(int plane, const Point& p) const {  // GP3
    const std::int64_t u = p.u;
    switch (plane) {
      case 0:
        return u - hither_;
      case 1:
        return u + p.v;
      case 2:
        return u - p.v;
      case 3:
        return u - p.w;
      default:
        return u + p.w;
    }
  }

  std::uint8_t outcode(const Point& p) const {
    const std::int64_t u = p.u;
    return static_cast<std::uint8_t>((u < hither_) | (u + p.v < 0) << 1 | (u - p.v < 0) << 2 |
                                     (u - p.w < 0) << 3 | (u + p.w < 0) << 4);
  }

  RasterPoint project(const Point& p) const {  // GP8
    const std::int64_t across = kOne + quotient(p.v, p.u, formats_.quotient_fraction);
    const std::int64_t down = kOne - quotient(p.w, p.u, formats_.quotient_fraction);
    return {raster_word(width_ * across, kQuotientFraction + 1),
            raster_word(height_ * down, kQuotientFraction + 1)};
  }

  Word raster_word(Accumulator value, int fraction) const {
    const int kept = formats_.raster_fraction;
    return static_cast<Word>(round_shift(value, fraction - kept) << (kRasterFraction - kept));
  }

  Outcome begin_face(const FaceMemory& memory, const Word* face) {
    if (!pace_.late()) return process_face(memory, face);
    pace_.spend(Step::kLateFace);  // GP16
    return Outcome::kOver;
  }

  Outcome process_face(const FaceMemory& memory, const Word* face) {
    const Word* corners = &memory.corners[static_cast<std::size_t>(face[kFirstCorner])];
    const auto count = static_cast<std::size_t>(face[kCornerCount]);
    const Word* d = vertices_[static_cast<std::size_t>(corners[0])].d;
    const Word* n = face + kNormal;
    const Accumulator facing =  // GP4
        Accumulator{n[0]} * d[0] + Accumulator{n[1]} * d[1] + Accumulator{n[2]} * d[2];
    ++figures_->faces;
    if (facing == 0 || (facing > 0 && face[kTwoSided] == 0)) {
      pace_.spend(Step::kBack);
      return Outcome::kDone;
    }
    pace_.spend(Step::kShown);
    std::uint8_t all = 0x1f, any = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint8_t code = vertices_[static_cast<std::size_t>(corners[i])].code;
      all &= code;
      any |= code;
    }
    pace_.spend(Step::kCorner, count);
    if (all != 0) {  // GP5
      pace_.spend(Step::kOutside);
      return Outcome::kDone;
    }
    if (any == 0) {
      const bool room = has_room(count);
      pace_.spend(room ? Step::kWhole : Step::kWholeOver);
      if (!room) return Outcome::kOver;
      loop_.clear();
      for (std::size_t i = 0; i < count; ++i)
        loop_.push_back(vertices_[static_cast<std::size_t>(corners[i])].raster);
    } else {
      points_.clear();
      for (std::size_t i = 0; i < count; ++i)
        points_.push_back(vertices_[static_cast<std::size_t>(corners[i])].p);
      ++figures_->clipped_faces;
      pace_.spend(Step::kClip);
      if (!clip(any)) return Outcome::kDone;
      const bool room = has_room(points_.size());
      pace_.spend(room ? Step::kProject : Step::kProjectOver);
      if (!room) return Outcome::kOver;
      loop_.clear();
      for (const Point& p : points_) loop_.push_back(project(p));
      pace_.spend(Step::kProjectCorner, points_.size());
      pace_.spend(Step::kProjected);
    }
    set_up(face, facing < 0);
    return Outcome::kDone;
  }

  bool has_room(std::size_t corners) const {  // GP15
    return (edge_capacity_ == 0 || edges_ + corners <= edge_capacity_) &&
           (face_capacity_ == 0 || faces_ < face_capacity_);
  }

  /// Clips points_ against the planes of `codes`; false when nothing is left.
  bool clip(std::uint8_t codes) {  // GP6
    for (int plane = 0; plane < kPlanes; ++plane) {
      if (!(codes >> plane & 1)) {
        pace_.spend(Step::kPlanePassed);
        continue;
      }
      pace_.spend(Step::kPlane);
      clipped_.clear();
      std::int64_t da = distance(plane, points_[0]);
      for (std::size_t i = 0; i < points_.size(); ++i) {
        const Point& a = points_[i];
        const Point& b = points_[i + 1 < points_.size() ? i + 1 : 0];
        const std::int64_t db = distance(plane, b);
        if (da >= 0) clipped_.push_back(a);
        if (da >= 0 && db < 0) clipped_.push_back(cut(a, b, da, db));
        if (da < 0 && db >= 0) clipped_.push_back(cut(b, a, db, da));
        pace_.spend(da >= 0 ? (db >= 0 ? Step::kBothIn : Step::kLeaving)
                            : (db >= 0 ? Step::kEntering : Step::kBothOut));
        da = db;
      }
      if (clipped_.size() < 3) {
        pace_.spend(Step::kClippedAway);
        return false;
      }
      points_.swap(clipped_);
      pace_.spend(Step::kPlaneDone);
    }
    return true;
  }

  Point cut(const Point& in, const Point& out, std::int64_t d_in, std::int64_t d_out) const {
    const std::int64_t t = quotient(d_in, d_in - d_out, formats_.quotient_fraction);
    const std::int64_t rest = kOne - t;
    const auto between = [&](Word from, Word to) {
      return static_cast<Word>(round_shift(t * to + rest * from, kQuotientFraction));
    };
    return {between(in.u, out.u), between(in.v, out.v), between(in.w, out.w)};
  }

  static int line_below(Word y) {  // GP10
    return static_cast<int>((Accumulator{y} + kHalfElement - 1) >> kRasterFraction);
  }

  void set_up(const Word* face, bool front) {  // GP9
    const std::uint32_t before = edges_;
    pace_.spend(Step::kPoints);
    for (std::size_t i = 0; i < loop_.size(); ++i)
      set_up_edge(loop_[i], loop_[i + 1 < loop_.size() ? i + 1 : 0], front);
    if (edges_ == before) {
      pace_.spend(Step::kNoFace);
      return;
    }
    pace_.spend(Step::kMade);
    pace_.face({faces_, false, static_cast<std::uint32_t>(face[kObject]),
                static_cast<std::uint32_t>(face[kColour])});
    pace_.spend(Step::kFaceOut);
    ++faces_;  // GP14
    ++figures_->front_faces;
  }

  void set_up_edge(const RasterPoint& a, const RasterPoint& b, bool front) {
    const bool down = a.y < b.y;
    const RasterPoint& top = down ? a : b;
    const RasterPoint& bottom = down ? b : a;
    const int first = line_below(top.y), end = line_below(bottom.y);
    if (first == end) {
      pace_.spend(Step::kLevel);
      return;
    }
    const std::int64_t dx = Accumulator{bottom.x} - top.x, dy = Accumulator{bottom.y} - top.y;
    const std::int64_t drop = (std::int64_t{first} << kRasterFraction) + kHalfElement - top.y;
    const std::int64_t from = Accumulator{top.x} - kHalfElement;
    EdgeWord edge;
    edge.face = faces_;
    edge.first_line = static_cast<std::uint16_t>(first);
    edge.end_line = static_cast<std::uint16_t>(end);
    edge.left = down == front;
    const bool single = end - first == 1;
    if (single) {  // GP12
      const Word t = quotient(drop, dy, formats_.quotient_fraction);
      edge.x = raster_word(from * kOne + t * dx, kQuotientFraction + kRasterFraction);
      pace_.spend(Step::kShort);
    } else {  // GP13
      edge.slope = slope_of(dx, dy, formats_.raster_fraction);
      edge.x = raster_word((from << kRasterFraction) + edge.slope * drop, 2 * kRasterFraction);
      pace_.spend(Step::kLong);
    }
    pace_.edge(edge);
    pace_.spend(single ? Step::kShortOut : Step::kEdgeOut);
    ++edges_;
    ++figures_->edges;
  }

  Pace& pace_;
  const WordFormats formats_;
  const Word hither_;
  const std::uint32_t edge_capacity_, face_capacity_;

  const GeometryBank* bank_ = nullptr;
  Figures* figures_ = nullptr;
  std::int64_t width_ = 0, height_ = 0;
  std::uint32_t edges_ = 0, faces_ = 0;  // put out in this frame

  std::vector<Vertex> vertices_;
  std::vector<Point> points_, clipped_;
  std::vector<RasterPoint> loop_;
};

}  // namespace cigsim::geometry_processor
