// SPDX-License-Identifier: MIT
#include "models/hidden_line/sepl.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "models/database/separation.hpp"

namespace cigsim::hidden_line {
namespace {

constexpr std::size_t kBits = 64;

// Where a part lies: +1, -1, 0 in the plane, 2 across it.
int classify(const Plane& plane, const Part& part) {
  bool positive = false, negative = false;
  for (const Vec3& v : part.vertices) {
    const int s = side(plane, v);
    positive = positive || s > 0;
    negative = negative || s < 0;
    if (positive && negative) return 2;
  }
  return positive ? 1 : negative ? -1 : 0;
}

struct Box {
  Vec3 centre, half;
};

Box box_of(const Part& part) {
  Vec3 low = part.vertices.front(), high = low;
  for (const Vec3& v : part.vertices) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  return {low * 0.5 + high * 0.5, high * 0.5 - low * 0.5};
}

// The side of a whole box when it is clearly on one, else 0.
int clear_side(const Plane& plane, const Box& box) {
  const Vec3 &n = plane.normal, &h = box.half, d = box.centre - plane.exact.p;
  const double value = dot(n, d);
  const double reach = std::abs(n.x) * h.x + std::abs(n.y) * h.y + std::abs(n.z) * h.z;
  const double wide = std::abs(n.x * d.x) + std::abs(n.y * d.y) + std::abs(n.z * d.z);
  const double rounding = (std::abs(d.x) + h.x) * plane.error.x +
                          (std::abs(d.y) + h.y) * plane.error.y +
                          (std::abs(d.z) + h.z) * plane.error.z + 0x1p-40 * (reach + wide);
  if (value > reach + 2 * rounding + 0x1p-900) return 1;
  if (value < -(reach + 2 * rounding + 0x1p-900)) return -1;
  return 0;
}

}  // namespace

// Columns one by one, with the pairs that are not parted yet as a matrix of bits.
class Sepl::Builder {
 public:
  Builder(Sepl& out, std::span<const Part> parts, const SeplLimits& limits)
      : out_(out), parts_(parts), limits_(limits), row_words_((parts.size() + kBits - 1) / kBits) {
    out_.objects_ = parts.size();
    for (const Part& part : parts) boxes_.push_back(box_of(part));
    open_.assign(parts.size() * row_words_, 0);
    for (std::size_t l = 0; l < parts.size(); ++l)
      for (std::size_t m = 0; m < parts.size(); ++m)
        if (l != m) open_[l * row_words_ + m / kBits] |= std::uint64_t{1} << m % kBits;
    left_ = parts.size() * (parts.size() - 1) / 2;
  }

  void take(const Plane& plane) {
    if (left_ == 0 || columns_.size() >= limits_.columns) return;
    std::vector<std::int8_t> where(parts_.size());
    bool plus = false, minus = false, flat = false;
    for (std::size_t l = 0; l < parts_.size(); ++l) {
      int s = clear_side(plane, boxes_[l]);
      if (s == 0) s = classify(plane, parts_[l]);
      where[l] = static_cast<std::int8_t>(s);
      plus = plus || s == 1;
      minus = minus || s == -1;
      flat = flat || s == 0;
    }
    if (flat && minus) column(plane, where, 1);
    if (flat && plus) column(plane, where, -1);
    if (!flat) column(plane, where, 0);
  }

  void search() {
    WorkSet work;
    for (const Part& part : parts_) add(work, part);
    std::size_t searches = 0;
    for (std::size_t l = 0; l < parts_.size(); ++l)
      for (std::size_t m = l + 1; m < parts_.size(); ++m) {
        if (!(open_[l * row_words_ + m / kBits] >> m % kBits & 1)) continue;
        if (searches++ >= limits_.searches || columns_.size() >= limits_.columns) return;
        if (const auto plane = separating_plane(work, work.items[l], work.items[m])) take(*plane);
      }
  }

  void finish() {
    out_.words_ = (columns_.size() + kBits - 1) / kBits;
    out_.plus_.assign(parts_.size() * out_.words_, 0);
    out_.tells_.assign(parts_.size() * out_.words_, 0);
    for (std::size_t c = 0; c < columns_.size(); ++c)
      for (std::size_t l = 0; l < parts_.size(); ++l) {
        const int s = columns_[c][l];
        if (s == 0) continue;
        const std::uint64_t bit = std::uint64_t{1} << c % kBits;
        out_.tells_[l * out_.words_ + c / kBits] |= bit;
        if (s > 0) out_.plus_[l * out_.words_ + c / kBits] |= bit;
      }
    out_.eye_.assign(out_.words_, 0);
    out_.unresolved_ = left_;
  }

 private:
  // `flat_side` is where objects in the plane count.
  void column(const Plane& plane, const std::vector<std::int8_t>& where, int flat_side) {
    if (columns_.size() >= limits_.columns) return;
    std::vector<std::int8_t> entries(where.size());
    std::vector<std::uint64_t> plus(row_words_), minus(row_words_);
    for (std::size_t l = 0; l < where.size(); ++l) {
      const int s = where[l] == 2 ? 0 : where[l] == 0 ? flat_side : where[l];
      entries[l] = static_cast<std::int8_t>(s);
      if (s != 0) (s > 0 ? plus : minus)[l / kBits] |= std::uint64_t{1} << l % kBits;
    }
    const std::size_t before = left_;
    for (std::size_t l = 0; l < where.size(); ++l) {
      if (entries[l] == 0) continue;
      const std::vector<std::uint64_t>& others = entries[l] > 0 ? minus : plus;
      for (std::size_t w = 0; w < row_words_; ++w) {
        std::uint64_t& open = open_[l * row_words_ + w];
        if (entries[l] > 0) left_ -= static_cast<std::size_t>(std::popcount(open & others[w]));
        open &= ~others[w];
      }
    }
    if (left_ == before) return;
    columns_.push_back(std::move(entries));
    out_.planes_.push_back(plane);
  }

  static void add(WorkSet& work, const Part& part) {
    const auto base = static_cast<std::uint32_t>(work.vertex_count());
    for (const Vec3& v : part.vertices) work.add_vertex(v);
    std::uint32_t count = 0;
    const auto polygon = [&](Loop corners, const Plane& plane) {
      for (std::uint32_t& c : corners) c += base;
      work.add_polygon(corners, work.add_plane(plane), {part.object, 0, {}, part.two_sided});
      ++count;
    };
    for (const PartFace& face : part.faces) polygon(face.loop, face.plane);
    // The edges of a wire frame have no planes of their own; any plane may be tried.
    if (part.faces.empty())
      for (const PartEdge& edge : part.edges) polygon({edge.a, edge.b}, axis_plane(2, 0));
    work.add_item(count);
  }

  Sepl& out_;
  std::span<const Part> parts_;
  SeplLimits limits_;
  std::size_t row_words_;
  std::vector<Box> boxes_;
  std::vector<std::vector<std::int8_t>> columns_;
  std::vector<std::uint64_t> open_;
  std::size_t left_ = 0;
};

Sepl::Sepl(std::span<const Part> parts, std::span<const Plane> candidates,
           const SeplLimits& limits) {
  if (parts.empty()) return;
  Builder builder(*this, parts, limits);
  for (const Plane& plane : candidates) builder.take(plane);
  builder.search();
  builder.finish();
}

int Sepl::entry(std::size_t object, std::size_t column) const {
  const std::size_t word = object * words_ + column / kBits;
  if (!(tells_[word] >> column % kBits & 1)) return 0;
  return plus_[word] >> column % kBits & 1 ? 1 : -1;
}

void Sepl::mark(const Vec3& eye) {
  std::fill(eye_.begin(), eye_.end(), 0);
  for (std::size_t c = 0; c < planes_.size(); ++c)
    if (side(planes_[c], eye) > 0) eye_[c / kBits] |= std::uint64_t{1} << c % kBits;
}

int Sepl::so(std::size_t l, std::size_t m) const {
  bool l_nearer = false, m_nearer = false;
  for (std::size_t w = 0; w < words_; ++w) {
    const std::uint64_t pl = plus_[l * words_ + w], pm = plus_[m * words_ + w];
    const std::uint64_t differ = (pl ^ pm) & tells_[l * words_ + w] & tells_[m * words_ + w];
    const std::uint64_t l_near = ~(pl ^ eye_[w]) & differ;
    l_nearer = l_nearer || l_near != 0;
    m_nearer = m_nearer || (differ & ~l_near) != 0;
    if (l_nearer && m_nearer) return 0;
  }
  return l_nearer ? 1 : m_nearer ? -1 : 2;
}

Sepl::Answer Sepl::may_hide(std::size_t m, std::size_t l) const {
  switch (so(l, m)) {
    case 2:
      return Answer::kUnresolved;
    case -1:
      return Answer::kMayHide;
    default:
      return Answer::kCannotHide;
  }
}

}  // namespace cigsim::hidden_line
