// SPDX-License-Identifier: MIT
#include "models/database/winding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cigsim {
namespace {

// One passage of an edge by a face; `forward` when from the lesser to the greater vertex.
struct Passage {
  std::uint32_t low, high, face;
  bool forward;
};

std::vector<Passage> passages(const std::vector<Loop>& loops) {
  std::vector<Passage> list;
  for (std::uint32_t f = 0; f < loops.size(); ++f)
    for (std::size_t i = 0; i < loops[f].size(); ++i) {
      const std::uint32_t a = loops[f][i], b = loops[f][(i + 1) % loops[f].size()];
      list.push_back({std::min(a, b), std::max(a, b), f, a < b});
    }
  std::sort(list.begin(), list.end(), [](const Passage& p, const Passage& q) {
    return p.low != q.low ? p.low < q.low : p.high != q.high ? p.high < q.high : p.face < q.face;
  });
  return list;
}

// Calls f(first, last) for each run of passages of one edge.
template <class F>
void for_each_edge(const std::vector<Passage>& list, F f) {
  for (std::size_t i = 0; i < list.size();) {
    std::size_t j = i;
    while (j < list.size() && list[j].low == list[i].low && list[j].high == list[i].high) ++j;
    f(i, j);
    i = j;
  }
}

bool balanced(const std::vector<Passage>& list) {
  bool all = true;
  for_each_edge(list, [&](std::size_t i, std::size_t j) {
    std::ptrdiff_t sum = 0;
    for (std::size_t k = i; k < j; ++k) sum += list[k].forward ? 1 : -1;
    all = all && sum == 0;
  });
  return all;
}

bool all_even(const std::vector<Passage>& list) {
  bool all = true;
  for_each_edge(list, [&](std::size_t i, std::size_t j) { all = all && (j - i) % 2 == 0; });
  return all;
}

// True when p lies strictly between a and b on their line, exactly.
bool strictly_between(const Vec3& a, const Vec3& b, const Vec3& p) {
  const double pc[3] = {p.x, p.y, p.z}, ac[3] = {a.x, a.y, a.z}, bc[3] = {b.x, b.y, b.z};
  for (int i = 0; i < 3; ++i)
    if (pc[i] < std::min(ac[i], bc[i]) || pc[i] > std::max(ac[i], bc[i])) return false;
  return !(p == a) && !(p == b) && collinear(a, b, p);
}

// Beyond this many open edges the object is a surface rather than a body with T-junctions.
constexpr std::size_t kMostOpenEdges = 4096;

std::uint64_t insert_junctions(std::span<const Vec3> vertices, std::vector<Loop>& loops) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open;
  std::vector<std::uint32_t> ends;
  const std::vector<Passage> list = passages(loops);
  for_each_edge(list, [&](std::size_t i, std::size_t j) {
    if (j - i != 1) return;
    open.emplace_back(list[i].low, list[i].high);
    ends.push_back(list[i].low);
    ends.push_back(list[i].high);
  });
  if (open.empty() || open.size() > kMostOpenEdges) return 0;
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::uint64_t inserted = 0;
  for (Loop& loop : loops) {
    Loop longer;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      longer.push_back(a);
      if (!std::binary_search(open.begin(), open.end(), std::pair{std::min(a, b), std::max(a, b)}))
        continue;
      Loop within;
      for (const std::uint32_t p : ends)
        if (p != a && p != b && strictly_between(vertices[a], vertices[b], vertices[p]))
          within.push_back(p);
      const Vec3 along = vertices[b] - vertices[a];
      std::sort(within.begin(), within.end(), [&](std::uint32_t p, std::uint32_t q) {
        return dot(vertices[p] - vertices[a], along) < dot(vertices[q] - vertices[a], along);
      });
      longer.insert(longer.end(), within.begin(), within.end());
      inserted += within.size();
    }
    loop = std::move(longer);
  }
  return inserted;
}

struct Volume {
  int sign = 0;       // exact
  double amount = 0;  // rounded; six times the volume
};

// The volume that the loops enclose.
Volume volume_of(std::span<const Vec3> vertices, const std::vector<Loop>& loops,
                 const std::vector<std::uint32_t>& faces) {
  const Vec3 origin = vertices[loops[faces[0]][0]];
  double sum = 0, magnitude = 0;
  for (const std::uint32_t f : faces)
    for (std::size_t i = 1; i + 1 < loops[f].size(); ++i) {
      const Vec3 a = vertices[loops[f][0]] - origin, b = vertices[loops[f][i]] - origin,
                 c = vertices[loops[f][i + 1]] - origin;
      const double term = dot(a, cross(b, c));
      sum += term;
      magnitude += std::abs(a.x) * (std::abs(b.y * c.z) + std::abs(b.z * c.y)) +
                   std::abs(a.y) * (std::abs(b.z * c.x) + std::abs(b.x * c.z)) +
                   std::abs(a.z) * (std::abs(b.x * c.y) + std::abs(b.y * c.x));
    }
  // Each term is within 10 eps of its magnitude, and each of the additions adds one eps of the sum.
  const double bound = (12 + 2 * static_cast<double>(loops.size())) * 0x1p-53 * magnitude;
  if (std::abs(sum) > bound && std::abs(sum) > 0x1p-900 && std::isfinite(magnitude))
    return {sum > 0 ? 1 : -1, sum};
  Exact exact = 0;
  const ExactVec o = convert<Exact>(origin);
  for (const std::uint32_t f : faces)
    for (std::size_t i = 1; i + 1 < loops[f].size(); ++i)
      exact += dot(convert<Exact>(vertices[loops[f][0]]) - o,
                   cross(convert<Exact>(vertices[loops[f][i]]) - o,
                         convert<Exact>(vertices[loops[f][i + 1]]) - o));
  return {sgn(exact), exact.get_d()};
}

struct Part {
  std::vector<std::uint32_t> faces;
  bool orientable = true;
  std::uint64_t turned = 0;
  Volume volume;
  Vec3 low, high;
};

// Walks each part over edges with exactly two passages and turns faces so that neighbours agree.
std::vector<Part> agree(std::vector<Loop>& loops, const std::vector<Passage>& list) {
  struct Neighbour {
    std::uint32_t face, other;
    bool same;  // both pass the edge in the same direction: the windings disagree
  };
  std::vector<Neighbour> neighbours;
  for_each_edge(list, [&](std::size_t i, std::size_t j) {
    if (j - i != 2 || list[i].face == list[i + 1].face) return;
    const bool same = list[i].forward == list[i + 1].forward;
    neighbours.push_back({list[i].face, list[i + 1].face, same});
    neighbours.push_back({list[i + 1].face, list[i].face, same});
  });
  std::sort(neighbours.begin(), neighbours.end(),
            [](const Neighbour& a, const Neighbour& b) { return a.face < b.face; });
  std::vector<std::size_t> start(loops.size() + 1, 0);
  for (const Neighbour& n : neighbours) ++start[n.face + 1];
  for (std::size_t f = 0; f < loops.size(); ++f) start[f + 1] += start[f];

  std::vector<Part> parts;
  std::vector<signed char> turned(loops.size(), -1);  // -1: not reached
  for (std::uint32_t seed = 0; seed < loops.size(); ++seed) {
    if (turned[seed] >= 0) continue;
    Part part;
    turned[seed] = 0;
    part.faces.push_back(seed);
    for (std::size_t at = 0; at < part.faces.size(); ++at) {
      const std::uint32_t f = part.faces[at];
      for (std::size_t k = start[f]; k < start[f + 1]; ++k) {
        const signed char wanted = neighbours[k].same ? 1 - turned[f] : turned[f];
        signed char& other = turned[neighbours[k].other];
        if (other < 0) {
          other = wanted;
          part.faces.push_back(neighbours[k].other);
        } else if (other != wanted) {
          part.orientable = false;
        }
      }
    }
    // Of the two ways to agree, keep the one that turns fewer faces.
    std::uint64_t count = 0;
    for (const std::uint32_t f : part.faces) count += turned[f] == 1;
    const bool other_way = 2 * count > part.faces.size();
    part.turned = other_way ? part.faces.size() - count : count;
    if (!part.orientable) part.turned = 0;
    for (const std::uint32_t f : part.faces)
      if (part.orientable && (turned[f] == 1) != other_way)
        std::reverse(loops[f].begin(), loops[f].end());
    parts.push_back(std::move(part));
  }
  return parts;
}

void measure(Part& part, std::span<const Vec3> vertices, const std::vector<Loop>& loops) {
  part.volume = volume_of(vertices, loops, part.faces);
  constexpr double inf = std::numeric_limits<double>::infinity();
  part.low = {inf, inf, inf};
  part.high = {-inf, -inf, -inf};
  for (const std::uint32_t f : part.faces)
    for (const std::uint32_t v : loops[f]) {
      const Vec3& p = vertices[v];
      part.low = {std::min(part.low.x, p.x), std::min(part.low.y, p.y), std::min(part.low.z, p.z)};
      part.high = {std::max(part.high.x, p.x), std::max(part.high.y, p.y),
                   std::max(part.high.z, p.z)};
    }
}

bool within(const Part& inner, const Part& outer) {
  return inner.low.x > outer.low.x && inner.low.y > outer.low.y && inner.low.z > outer.low.z &&
         inner.high.x < outer.high.x && inner.high.y < outer.high.y && inner.high.z < outer.high.z;
}

std::uint64_t turn_part(Part& part, std::vector<Loop>& loops) {
  for (const std::uint32_t f : part.faces) std::reverse(loops[f].begin(), loops[f].end());
  part.volume = {-part.volume.sign, -part.volume.amount};
  return part.faces.size();
}

// Makes the parts of a closed object face outwards.
std::uint64_t face_outwards(std::span<const Vec3> vertices, std::vector<Loop>& loops,
                            std::vector<Part>& parts) {
  std::uint64_t turned = 0;
  for (Part& part : parts) measure(part, vertices, loops);
  double sum = 0;
  for (const Part& part : parts) sum += part.volume.amount;
  // Cavities hold less than the bodies around them: an input wound inwards throughout (Stump's
  // decks) encloses less than nothing, and is turned as a whole.
  if (sum < 0)
    for (Part& part : parts) turned += turn_part(part, loops);
  for (Part& part : parts) {
    if (part.volume.sign >= 0) continue;
    const bool cavity = std::any_of(parts.begin(), parts.end(), [&](const Part& other) {
      return &other != &part && other.volume.sign > 0 && within(part, other);
    });
    if (!cavity || part.turned > 0) turned += turn_part(part, loops);
  }
  return turned;
}

}  // namespace

WindingResult repair_winding(std::span<const Vec3> vertices, std::vector<Loop>& loops) {
  WindingResult result;
  if (loops.empty()) return result;
  std::vector<Passage> list = passages(loops);
  if (!all_even(list)) {
    std::vector<Loop> longer = loops;
    const std::uint64_t inserted = insert_junctions(vertices, longer);
    std::vector<Passage> after = passages(longer);
    if (inserted > 0 && all_even(after)) {
      loops = std::move(longer);
      list = std::move(after);
      result.inserted = inserted;
    }
  }
  std::vector<Part> parts = agree(loops, list);
  result.parts = static_cast<std::uint32_t>(parts.size());
  for (const Part& part : parts) result.turned_faces += part.turned;
  result.closed = balanced(passages(loops));
  if (result.closed) result.turned_faces += face_outwards(vertices, loops, parts);
  return result;
}

}  // namespace cigsim
