// SPDX-License-Identifier: MIT
#include "models/database/separation_planes/published.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "models/environment/input_error.hpp"

namespace cigsim::separation_planes {
namespace {

constexpr double kTolerance = 0.001;
constexpr int kNoDifference = 999999;

// The vertices of a face as on its card: the reader has turned them round.
std::vector<Vec3> on_card(const Object& object, const Face& face) {
  std::vector<Vec3> nodes;
  for (auto v = face.vertices.rbegin(); v != face.vertices.rend(); ++v)
    nodes.push_back(object.vertices[*v]);
  return nodes;
}

// Nothing when the nodes lie on one line.
std::optional<UnitPlane> plane_of(const Vec3& node1, const Vec3& node2, const Vec3& node3) {
  const Vec3 normal = cross(node1 - node2, node3 - node2);
  const double length = std::sqrt(dot(normal, normal));
  if (length == 0 || !std::isfinite(length)) return std::nullopt;
  const Vec3 unit{normal.x / length, normal.y / length, normal.z / length};
  return UnitPlane{unit, dot(unit, node1)};
}

// The side tests of one candidate, object after object.
class SideTest {
 public:
  explicit SideTest(int kept) : last_(kept) {}

  int of(const UnitPlane& plane, const Object& object) {
    bool cut = false;
    for (const Face& face : object.faces) {
      bool first = true;
      const std::vector<Vec3> nodes = on_card(object, face);
      for (std::size_t v = 0; v < nodes.size() && !cut; ++v) {
        const double distance = dot(plane.normal, nodes[v]) - plane.distance;
        if (std::abs(distance) < kTolerance) continue;
        const int side = distance < 0 ? -1 : 1;
        cut = !first && side != last_;
        if (first) last_ = side;
        first = false;
      }
    }
    return cut ? 0 : last_;
  }
  int kept() const { return last_; }

 private:
  int last_;  // keeps its value from face to face, object to object and plane to plane
};

// The sets that are still to be divided, from left to right.
class Division {
 public:
  Division(const PublishedProgram& program, std::size_t objects)
      : program_(program), objects_(objects) {}

  PublishedTable run() {
    std::vector<std::vector<std::uint32_t>> sets(1);
    for (std::uint32_t o = 0; o < objects_; ++o) sets[0].push_back(o);
    table_.candidates = static_cast<std::uint32_t>(program_.candidates().size());
    for (std::size_t at = 0; at < sets.size();) {
      if (sets[at].size() <= 1) {
        ++at;
        continue;
      }
      const auto chosen = select(sets[at]);
      if (!chosen) return std::move(table_);
      std::vector<std::uint32_t> on_false = divide(*chosen, sets[at]);
      sets.insert(sets.begin() + static_cast<std::ptrdiff_t>(at) + 1, std::move(on_false));
    }
    table_.found = true;
    return std::move(table_);
  }

 private:
  // |N+ - N-| over a set, or nothing when the candidate cuts a member or leaves a side empty.
  std::optional<int> difference(std::uint32_t candidate, const std::vector<std::uint32_t>& set) {
    int plus = 0, minus = 0;
    for (const std::uint32_t o : set) {
      const int state = program_.state(candidate, o);
      if (state == 0) return std::nullopt;
      ++(state > 0 ? plus : minus);
    }
    if (plus == 0 || minus == 0) return std::nullopt;
    return std::abs(plus - minus);
  }

  int difference_over_all(std::uint32_t candidate) const {
    int sum = 0;
    for (std::uint32_t o = 0; o < objects_; ++o) sum += program_.state(candidate, o);
    return std::abs(sum);
  }

  std::optional<std::uint32_t> select(const std::vector<std::uint32_t>& set) {
    std::optional<std::uint32_t> chosen;
    int least = kNoDifference, least_over_all = 0;
    for (std::uint32_t c = 0; c < program_.candidates().size(); ++c) {
      const std::optional<int> here = difference(c, set);
      if (!here || *here > least) continue;
      const int over_all = difference_over_all(c);
      if (*here == least && over_all >= least_over_all) continue;
      chosen = c;
      least = *here;
      least_over_all = over_all;
    }
    return chosen;
  }

  // Lists the pairs, keeps the TRUE objects in `set` and returns the others.
  std::vector<std::uint32_t> divide(std::uint32_t candidate, std::vector<std::uint32_t>& set) {
    std::vector<std::uint32_t> on_true, on_false;
    for (const std::uint32_t o : set)
      (program_.state(candidate, o) > 0 ? on_true : on_false).push_back(o);
    auto plane = std::find_if(table_.planes.begin(), table_.planes.end(),
                              [&](const ChosenPlane& p) { return p.candidate == candidate; });
    if (plane == table_.planes.end())
      plane = table_.planes.insert(plane, {program_.candidates()[candidate], candidate, {}});
    for (const std::uint32_t t : on_true)
      for (const std::uint32_t f : on_false) plane->pairs.push_back({t + 1, f + 1});
    set = std::move(on_true);
    return on_false;
  }

  const PublishedProgram& program_;
  std::size_t objects_;
  PublishedTable table_;
};

}  // namespace

PublishedProgram::PublishedProgram(const StumpDeck& deck, const std::string& name)
    : objects_(deck.objects.size()) {
  for (std::size_t o = 0; o < deck.objects.size(); ++o)
    for (std::size_t f = 0; f < deck.objects[o].faces.size(); ++f) {
      const std::vector<Vec3> nodes = on_card(deck.objects[o], deck.objects[o].faces[f]);
      const std::optional<UnitPlane> plane = plane_of(nodes[0], nodes[1], nodes[2]);
      if (!plane)
        throw InputError(name, 0,
                         "the first three vertices of face " + std::to_string(f + 1) +
                             " of object " + std::to_string(o + 1) +
                             " lie on one line, where the published program divides by zero; "
                             "begin the face at another vertex or leave --as-published away");
      candidates_.push_back(*plane);
    }
  for (const auto& points : deck.planes) {
    const std::optional<UnitPlane> plane = plane_of(points[0], points[1], points[2]);
    if (!plane)
      throw InputError(name, 0,
                       "the points of an S card lie on one line, where the published program "
                       "divides by zero; move one of them or leave --as-published away");
    candidates_.push_back(*plane);
  }
  SideTest test(0);
  for (const UnitPlane& plane : candidates_)
    for (const Object& object : deck.objects) states_.push_back(test.of(plane, object));
}

PublishedTable PublishedProgram::run() const { return Division(*this, objects_).run(); }

void check_published_limits(const StumpDeck& deck, const std::string& name) {
  std::size_t vertices = 3 * deck.planes.size(), entries = 0;
  for (const Object& object : deck.objects) {
    vertices += object.vertices.size();
    for (const Face& face : object.faces) entries += face.vertices.size();
  }
  if (vertices > kPublishedVertices)
    throw InputError(name, 0,
                     std::to_string(vertices) +
                         " vertices (three an S card) are more than the 100 of the published "
                         "program; leave --as-published away");
  if (entries > kPublishedFaceEntries)
    throw InputError(name, 0,
                     std::to_string(entries) +
                         " vertex numbers on F cards are more than the 200 of the published "
                         "program; leave --as-published away");
}

}  // namespace cigsim::separation_planes
