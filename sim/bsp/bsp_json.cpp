// SPDX-License-Identifier: MIT
#include "sim/bsp/bsp_json.hpp"

#include "sim/bsp/part_names.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Vec3& v) { return {v.x, v.y, v.z}; }

Json polygon_json(const BspTree& tree, std::uint32_t item) {
  const WorkPolygon& polygon = tree.polygon(item);
  Json vertices = Json::array();
  for (std::uint32_t c = 0; c < polygon.corner_count; ++c)
    vertices.push_back(vector_json(tree.set.vertex(tree.set.corners(polygon)[c])));
  return {{"object", polygon.origin.object},
          {"polygon", polygon.origin.order + 1},
          {"vertices", std::move(vertices)}};
}

Json node_json(const BspTree& tree, const BspNode& node) {
  const auto son = [](std::uint32_t index) {
    return index == BspNode::kLeaf ? Json(nullptr) : Json(index);
  };
  Json members = Json::array();
  for (std::uint32_t m = node.first; m < node.first + node.count; ++m) members.push_back(m);
  const Plane& plane = tree.set.planes[node.plane];
  return {{"point", vector_json(plane.exact.p)},
          {"normal", vector_json(plane.normal)},
          {"polygons", std::move(members)},
          {"positive", son(node.positive)},
          {"negative", son(node.negative)}};
}

}  // namespace

Json bsp_tree_json(const BspTree& tree,
                   const std::optional<std::vector<std::uint32_t>>& priorities) {
  const std::vector<std::string> names = part_names(tree);
  Json polygons = Json::array(), nodes = Json::array();
  for (std::size_t m = 0; m < tree.members.size(); ++m) {
    Json polygon{{"name", names[m]}};
    if (priorities) polygon["priority"] = (*priorities)[m];
    polygon.update(polygon_json(tree, tree.members[m]));
    polygons.push_back(std::move(polygon));
  }
  for (const BspNode& node : tree.nodes) nodes.push_back(node_json(tree, node));
  return {{"polygons", std::move(polygons)}, {"nodes", std::move(nodes)}};
}

}  // namespace cigsim
