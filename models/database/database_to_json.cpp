// SPDX-License-Identifier: MIT
#include <bit>
#include <map>

#include "models/database/database_json.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

void append(Json& list, const Vec3& v) {
  list.push_back(v.x);
  list.push_back(v.y);
  list.push_back(v.z);
}

void append(Json& list, const Sphere& sphere) {
  append(list, sphere.centre);
  list.push_back(sphere.radius);
}

Json sphere_json(const Sphere& sphere) {
  Json list = Json::array();
  append(list, sphere);
  return list;
}

Json placement_json(const Placement& p) {
  return Json::array({p.position.x, p.position.y, p.position.z, p.heading, p.pitch, p.roll});
}

std::uint32_t packed(const Colour& c) { return std::uint32_t{c.r} << 16 | c.g << 8 | c.b; }

// The points of planes, each once. Equal means the same bits, so that -0 stays -0.
class PointList {
 public:
  std::size_t index(const Vec3& p) {
    const auto [place, added] =
        places_.try_emplace({std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
                             std::bit_cast<std::uint64_t>(p.z)},
                            places_.size());
    if (added) append(points_, p);
    return place->second;
  }
  Json take() { return std::move(points_); }

 private:
  std::map<std::array<std::uint64_t, 3>, std::size_t> places_;
  Json points_ = Json::array();
};

void put_planes(Json& out, const std::vector<Plane>& planes) {
  PointList points;
  Json list = Json::array();
  for (const Plane& plane : planes) {
    const PlaneDefinition& d = plane.exact;
    for (const Vec3* p : {&d.p, &d.u0, &d.u1, &d.v0, &d.v1}) list.push_back(points.index(*p));
  }
  out["points"] = points.take();
  out["planes"] = std::move(list);
}

Json set_json(const FaceSet& set) {
  Json out;
  Json vertices = Json::array();
  for (const Vec3& v : set.vertices) append(vertices, v);
  Json cut = Json::array();
  for (const CutVertex& c : set.cut_vertices)
    cut.push_back(Json::array(
        {c.vertex, c.position.x.get_str(), c.position.y.get_str(), c.position.z.get_str()}));
  out["vertices"] = std::move(vertices);
  out["cut_vertices"] = std::move(cut);
  out["corners"] = set.corners;
  put_planes(out, set.planes);
  Json faces = Json::array();
  for (const PreparedFace& f : set.faces)
    for (const std::uint32_t field : {f.first_corner, f.corner_count, f.plane, f.object,
                                      packed(f.colour), std::uint32_t{f.two_sided}})
      faces.push_back(field);
  Json items = Json::array();
  Json spheres = Json::array();
  for (const Item& item : set.items) {
    for (const std::uint32_t field :
         {item.first_face, item.face_count, item.first_vertex, item.vertex_count})
      items.push_back(field);
    append(spheres, item.sphere);
  }
  out["faces"] = std::move(faces);
  out["items"] = std::move(items);
  out["spheres"] = std::move(spheres);
  return out;
}

void put_choices(Json& out, const PriorityHierarchy& hierarchy) {
  Json choices = Json::array(), groups = Json::array();
  for (const PreparedChoice& choice : hierarchy.choices) {
    Json row = sphere_json(choice.sphere);
    for (const double threshold : choice.thresholds) row.push_back(threshold);
    choices.push_back(std::move(row));
  }
  for (std::size_t g = 0; g < hierarchy.groups.size(); ++g) {
    if (hierarchy.groups[g].choice == kNone) continue;
    groups.push_back(g);
    groups.push_back(hierarchy.groups[g].choice);
  }
  out["choices"] = std::move(choices);
  out["choice_groups"] = std::move(groups);
}

Json hierarchy_json(const PriorityHierarchy& hierarchy) {
  Json out;
  put_planes(out, hierarchy.planes);
  Json nodes = Json::array();
  for (const SeparationNode& node : hierarchy.nodes) {
    nodes.push_back(node.plane);
    nodes.push_back(node.true_child);
    nodes.push_back(node.false_child);
    nodes.push_back(node.true_members);
    nodes.push_back(node.false_members);
  }
  Json pairs = Json::array();
  for (std::size_t n = 0; n < hierarchy.nodes.size(); ++n) {
    const SeparationNode& node = hierarchy.nodes[n];
    for (std::uint32_t p = node.first_pair; p < node.first_pair + node.pair_count; ++p) {
      pairs.push_back(n);
      pairs.push_back(std::uint32_t{hierarchy.pairs[p].true_member});
      pairs.push_back(std::uint32_t{hierarchy.pairs[p].false_member});
    }
  }
  Json members = Json::array();
  Json spheres = Json::array();
  for (const Member& member : hierarchy.members) {
    members.push_back(std::uint32_t{member.placeholder ? 2u : member.is_group});
    members.push_back(member.index);
    append(spheres, member.sphere);
  }
  Json groups = Json::array();
  for (const Group& group : hierarchy.groups)
    for (const std::uint32_t field :
         {group.first_member, group.member_count, group.first_node, group.node_count})
      groups.push_back(field);
  out["nodes"] = std::move(nodes);
  out["members"] = std::move(members);
  out["spheres"] = std::move(spheres);
  out["groups"] = std::move(groups);
  if (!pairs.empty()) out["pairs"] = std::move(pairs);
  if (!hierarchy.choices.empty()) put_choices(out, hierarchy);
  return out;
}

Json system_json(const PreparedSystem& system) {
  Json out;
  out["name"] = system.name;
  out["placement"] = placement_json(system.placement);
  Json motion = Json::array();
  for (const MotionKey& key : system.motion) {
    Json row = placement_json(key.placement);
    row.insert(row.begin(), key.frame);
    motion.push_back(std::move(row));
  }
  out["motion"] = std::move(motion);
  out["sphere"] = sphere_json(system.sphere);
  out["set"] = set_json(system.set);
  out["hierarchy"] = hierarchy_json(system.hierarchy);
  return out;
}

}  // namespace

Json report_to_json(const PreparationReport& report) {
  Json out;
  out["objects"] = report.objects;
  out["faces"] = report.faces;
  out["vertices"] = report.vertices;
  out["convex_objects"] = report.convex_objects;
  out["unclosed_objects"] = report.unclosed_objects;
  out["items"] = report.items;
  out["pieces"] = report.pieces;
  out["cuts"] = report.cuts;
  out["planes"] = report.planes;
  out["groups"] = report.groups;
  out["depth"] = report.depth;
  out["pairs"] = report.pairs;
  if (report.choices > 0) out["choices"] = report.choices;
  out["seconds"] = report.seconds;
  Json notices = Json::array();
  for (const Notice& notice : report.notices)
    notices.push_back(Json::array({notice.what, notice.count}));
  out["notices"] = std::move(notices);
  return out;
}

Json database_to_json(const Database& database) {
  Json out;
  out[kDatabaseTag] = kDatabaseVersion;
  out["name"] = database.name;
  out["object_names"] = database.object_names;
  out["background"] = packed(database.background);
  out["view"] = {{"eye", numbers(database.view.eye.position)},
                 {"attitude", Json::array({database.view.eye.heading, database.view.eye.pitch,
                                           database.view.eye.roll})},
                 {"fov", database.view.fov}};
  Json systems = Json::array();
  for (const PreparedSystem& system : database.systems) systems.push_back(system_json(system));
  out["systems"] = std::move(systems);
  out["ground"] = set_json(database.ground);
  out["report"] = report_to_json(database.report);
  return out;
}

}  // namespace cigsim
