// SPDX-License-Identifier: MIT
#include "sim/budget/database_digest.hpp"

#include <string>
#include <type_traits>

#include "sim/measure/digest.hpp"

namespace cigsim {
namespace {

// Field by field, since structures have gaps whose contents are not defined.
class DatabaseDigest {
 public:
  void add(const Database& d) {
    add_all(d.object_count, d.background, d.view.eye, d.view.fov, d.ground, d.systems);
  }
  std::uint64_t value() const { return digest_.value(); }

 private:
  template <class... T>
  void add_all(const T&... fields) {
    (add(fields), ...);
  }
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(T value) { digest_.add({reinterpret_cast<const char*>(&value), sizeof value}); }
  template <class T>
  void add(const std::vector<T>& list) {
    add(list.size());
    for (const T& one : list) add(one);
  }
  void add(const std::string& text) {
    add(text.size());
    digest_.add(text);
  }
  void add(const Vec3& v) { add_all(v.x, v.y, v.z); }
  void add(const Colour& c) { add_all(c.r, c.g, c.b); }
  void add(const Sphere& s) { add_all(s.centre, s.radius); }
  void add(const Placement& p) { add_all(p.position, p.heading, p.pitch, p.roll); }
  void add(const MotionKey& k) { add_all(k.frame, k.placement); }
  // What is rounded follows from the exact definition.
  void add(const Plane& p) { add_all(p.exact.p, p.exact.u0, p.exact.u1, p.exact.v0, p.exact.v1); }
  void add(const CutVertex& c) {
    add_all(c.vertex, c.position.x.get_str(), c.position.y.get_str(), c.position.z.get_str());
  }
  void add(const PreparedFace& f) {
    add_all(f.first_corner, f.corner_count, f.plane, f.object, f.colour, f.two_sided);
  }
  void add(const Item& i) {
    add_all(i.first_face, i.face_count, i.first_vertex, i.vertex_count, i.sphere);
  }
  void add(const FaceSet& s) {
    add_all(s.vertices, s.cut_vertices, s.corners, s.planes, s.faces, s.items);
  }
  void add(const SeparationNode& n) {
    add_all(n.plane, n.true_child, n.false_child, n.true_members, n.false_members, n.first_pair,
            n.pair_count);
  }
  void add(const MemberPair& p) { add_all(p.true_member, p.false_member); }
  void add(const Member& m) { add_all(m.is_group, m.index, m.sphere, m.placeholder); }
  void add(const Group& g) {
    add_all(g.first_member, g.member_count, g.first_node, g.node_count, g.choice);
  }
  void add(const PreparedChoice& c) { add_all(c.sphere, c.thresholds); }
  void add(const PriorityHierarchy& h) {
    add_all(h.planes, h.nodes, h.pairs, h.members, h.groups, h.choices);
  }
  void add(const PreparedSystem& s) {
    add_all(s.placement, s.motion, s.set, s.hierarchy, s.sphere);
  }

  Digest digest_;
};

}  // namespace

std::uint64_t database_digest(const Database& database) {
  DatabaseDigest digest;
  digest.add(database);
  return digest.value();
}

}  // namespace cigsim
