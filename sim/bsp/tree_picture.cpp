// SPDX-License-Identifier: MIT
#include "sim/bsp/tree_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "models/database/bsp/traversal.hpp"
#include "sim/bsp/part_names.hpp"
#include "sim/drawing/svg.hpp"

namespace cigsim {
namespace {

constexpr double kStepX = 30, kStepY = 46, kMargin = 40, kRadius = 12, kSceneSize = 420;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Nodes of each subtree; children follow their parents.
std::vector<std::uint32_t> subtree_sizes(const BspTree& tree) {
  std::vector<std::uint32_t> sizes(tree.nodes.size(), 1);
  for (std::size_t n = tree.nodes.size(); n-- > 0;)
    for (const std::uint32_t son : {tree.nodes[n].positive, tree.nodes[n].negative})
      if (son != BspNode::kLeaf) sizes[n] += sizes[son];
  return sizes;
}

// The nodes to draw, level by level, at most kMostNodesDrawn.
std::vector<char> drawn_nodes(const BspTree& tree) {
  std::vector<char> drawn(tree.nodes.size(), 0);
  std::vector<std::uint32_t> queue;
  if (!tree.nodes.empty()) queue.push_back(0);
  for (std::size_t q = 0; q < queue.size() && q < kMostNodesDrawn; ++q) {
    drawn[queue[q]] = 1;
    for (const std::uint32_t son : {tree.nodes[queue[q]].positive, tree.nodes[queue[q]].negative})
      if (son != BspNode::kLeaf) queue.push_back(son);
  }
  return drawn;
}

struct Place {
  std::uint32_t node;
  std::uint32_t depth;
  std::uint32_t parent;
  Vec2 at;
  bool cut_off;  // a subtree that is not drawn
};

// Places in symmetric order, positive subtrees to the left.
std::vector<Place> lay_out(const BspTree& tree) {
  const std::vector<char> drawn = drawn_nodes(tree);
  struct Step {
    Place place;
    bool entered;
  };
  std::vector<Step> stack;
  std::vector<Place> places;
  if (!tree.nodes.empty()) stack.push_back({{0, 0, BspNode::kLeaf, {}, false}, false});
  while (!stack.empty()) {
    Step step = stack.back();
    stack.pop_back();
    const std::uint32_t n = step.place.node;
    if (step.entered || step.place.cut_off) {
      step.place.at = {kMargin + kStepX * static_cast<double>(places.size()),
                       kMargin + 30 + kStepY * step.place.depth};
      places.push_back(step.place);
      continue;
    }
    const auto push = [&](std::uint32_t son) {
      if (son != BspNode::kLeaf)
        stack.push_back({{son, step.place.depth + 1, n, {}, !drawn[son]}, false});
    };
    push(tree.nodes[n].negative);
    stack.push_back({step.place, true});
    push(tree.nodes[n].positive);
  }
  return places;
}

std::string node_label(const BspNode& node, const std::vector<std::string>& names) {
  if (node.count == 0) return "–";
  std::string label = names[node.first];
  if (node.count > 1) label += fmt::format("+{}", node.count - 1);
  return label;
}

void draw_tree(SvgDrawing& drawing, const BspTree& tree, const std::vector<Place>& places,
               const std::vector<std::string>& names) {
  std::vector<Vec2> at(tree.nodes.size());
  for (const Place& place : places) at[place.node] = place.at;
  for (const Place& place : places)
    if (place.parent != BspNode::kLeaf) drawing.line(at[place.parent], place.at);
  const std::vector<std::uint32_t> sizes = subtree_sizes(tree);
  for (const Place& place : places) {
    const Vec2 words{place.at.x, place.at.y + 4};
    if (place.cut_off) {
      const double x = place.at.x, y = place.at.y;
      drawing.polygon(std::vector<Vec2>{{x, y - 12}, {x + 14, y + 8}, {x - 14, y + 8}},
                      {.fill = "#eeeeee"});
      drawing.text(words, fmt::format("+{}", sizes[place.node]), 9, SvgAnchor::kMiddle);
      continue;
    }
    const BspNode& node = tree.nodes[place.node];
    drawing.circle(place.at, kRadius, {.fill = node.count == 0 ? "#eeeeee" : "#ffffff"});
    drawing.text(words, node_label(node, names), 9, SvgAnchor::kMiddle);
  }
}

// Parallel projection from the south-west and above.
struct Projection {
  static constexpr Vec3 kRight{0.8, -0.6, 0}, kUp{0.3, 0.4, 0.866}, kTowardsEye{-0.52, -0.69, 0.5};
  double x0 = 0, y1 = 0, scale = 1;
  Vec2 corner;

  Vec2 operator()(const Vec3& p) const {
    return {corner.x + (dot(kRight, p) - x0) * scale, corner.y + (y1 - dot(kUp, p)) * scale};
  }
};

Projection fit(const BspTree& tree, const Vec2& corner) {
  double x0 = kInfinity, x1 = -kInfinity, y0 = kInfinity, y1 = -kInfinity;
  for (std::uint32_t v = 0; v < tree.set.vertex_count(); ++v) {
    const double x = dot(Projection::kRight, tree.set.vertex(v));
    const double y = dot(Projection::kUp, tree.set.vertex(v));
    x0 = std::min(x0, x);
    x1 = std::max(x1, x);
    y0 = std::min(y0, y);
    y1 = std::max(y1, y);
  }
  const double extent = std::max(x1 - x0, y1 - y0);
  return {x0, y1, extent > 0 && std::isfinite(extent) ? kSceneSize / extent : 1, corner};
}

void draw_part(SvgDrawing& drawing, const BspTree& tree, std::uint32_t item,
               const std::string& name, const Projection& project) {
  const WorkPolygon& polygon = tree.polygon(item);
  std::vector<Vec2> corners;
  Vec3 centre{};
  for (std::uint32_t c = 0; c < polygon.corner_count; ++c) {
    const Vec3& v = tree.set.vertex(tree.set.corners(polygon)[c]);
    corners.push_back(project(v));
    centre = centre + v * (1.0 / polygon.corner_count);
  }
  drawing.polygon(corners, {.fill = "#ffffff"});
  const Vec3& normal = tree.set.planes[polygon.plane].normal;
  const double length = std::hypot(normal.x, normal.y, normal.z);
  if (!(length > 0) || dot(normal, Projection::kTowardsEye) <= 0) return;
  const Vec3 tip = centre + normal * (14 / (length * project.scale));
  drawing.line(project(centre), project(tip), {.stroke = "#a33a2c", .width = 1.2});
  drawing.circle(project(tip), 1.8, {.stroke = "#a33a2c", .fill = "#a33a2c"});
  const Vec2 at = project(centre);
  drawing.text({at.x + 4, at.y + 10}, name, 9);
}

void draw_scene(SvgDrawing& drawing, const BspTree& tree, const std::vector<std::string>& names,
                const Vec2& corner) {
  const Projection project = fit(tree, corner);
  // Far enough away for all lines of sight to be almost parallel.
  double reach = 1;
  for (std::uint32_t v = 0; v < tree.set.vertex_count(); ++v) {
    const Vec3& p = tree.set.vertex(v);
    reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  std::vector<std::string> name_of(tree.set.items.size());
  for (std::size_t m = 0; m < names.size(); ++m) name_of[tree.members[m]] = names[m];
  for (const std::uint32_t item : back_to_front(tree, Projection::kTowardsEye * (1e6 * reach)))
    draw_part(drawing, tree, item, name_of[item], project);
}

}  // namespace

std::string bsp_picture(const BspTree& tree) {
  const std::vector<Place> places = lay_out(tree);
  const std::vector<std::string> names = part_names(tree);
  const bool scene = !tree.members.empty() && names.size() <= kMostPartsDrawn;
  double right = kMargin + 200, low = kMargin + 40;
  for (const Place& place : places) {
    right = std::max(right, place.at.x + kMargin);
    low = std::max(low, place.at.y + kMargin);
  }
  SvgDrawing drawing(scene ? right + kSceneSize + kMargin : right,
                     scene ? std::max(low, kSceneSize + 2 * kMargin + 30) : low, "BSP tree");
  drawing.text({kMargin, 24}, "Left branches are positive", 12);
  draw_tree(drawing, tree, places, names);
  if (scene) {
    drawing.text({right, 24}, "Arrows on the positive sides that are seen", 12);
    draw_scene(drawing, tree, names, {right, kMargin + 30});
  }
  return drawing.svg();
}

}  // namespace cigsim
