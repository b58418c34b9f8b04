// SPDX-License-Identifier: MIT
#include "sim/bsp/tree_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
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
  double height = 0;  ///< of all, pixels

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
  const double scale = extent > 0 && std::isfinite(extent) ? kSceneSize / extent : 1;
  const double height = std::clamp((y1 - y0) * scale, 0.0, kSceneSize);
  return {x0, y1, scale, corner, height};
}

using Corners = std::vector<Vec2>;

Corners projected(const BspTree& tree, const WorkPolygon& polygon, const Projection& project) {
  Corners corners;
  for (std::uint32_t c = 0; c < polygon.corner_count; ++c)
    corners.push_back(project(tree.set.vertex(tree.set.corners(polygon)[c])));
  return corners;
}

Vec3 centre_of(const BspTree& tree, const WorkPolygon& polygon) {
  Vec3 centre{};
  for (std::uint32_t c = 0; c < polygon.corner_count; ++c)
    centre = centre + tree.set.vertex(tree.set.corners(polygon)[c]) * (1.0 / polygon.corner_count);
  return centre;
}

// A convex polygon, in either sense.
bool contains(const Corners& corners, const Vec2& at) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double side = (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
    left = left || side > 0;
    right = right || side < 0;
  }
  return !(left && right);
}

// Where the middle of a name lies best: on its polygon and off those drawn later, as near the
// centre as possible; the centre where there is no such place.
Vec2 place_of_name(const Corners& own, const Vec2& centre, std::span<const Corners> later) {
  constexpr double kHalfWidth = 9, kHalfHeight = 6;
  constexpr int kSteps = 16;
  const auto covered = [&](const Vec2& at) {
    for (const double dx : {-kHalfWidth, 0.0, kHalfWidth})
      for (const double dy : {-kHalfHeight, kHalfHeight})
        for (const Corners& corners : later)
          if (contains(corners, {at.x + dx, at.y + dy})) return true;
    return false;
  };
  for (int step = 0; step < kSteps; ++step)
    for (const Vec2& corner : own) {
      const double t = static_cast<double>(step) / kSteps;
      const Vec2 at{centre.x + t * (corner.x - centre.x), centre.y + t * (corner.y - centre.y)};
      if (!covered(at)) return at;
    }
  return centre;
}

// An arrow from the centre, where the positive side is seen.
void draw_normal(SvgDrawing& drawing, const Vec3& normal, const Vec3& centre,
                 const Projection& project) {
  const double length = std::hypot(normal.x, normal.y, normal.z);
  if (!(length > 0) || dot(normal, Projection::kTowardsEye) <= 0) return;
  const Vec3 tip = centre + normal * (14 / (length * project.scale));
  drawing.line(project(centre), project(tip), {.stroke = "#a33a2c", .width = 1.2});
  drawing.circle(project(tip), 1.8, {.stroke = "#a33a2c", .fill = "#a33a2c"});
}

void draw_scene(SvgDrawing& drawing, const BspTree& tree, const std::vector<std::string>& names,
                const Projection& project) {
  // Far enough away for all lines of sight to be almost parallel.
  double reach = 1;
  for (std::uint32_t v = 0; v < tree.set.vertex_count(); ++v) {
    const Vec3& p = tree.set.vertex(v);
    reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  std::vector<std::string> name_of(tree.set.items.size());
  for (std::size_t m = 0; m < names.size(); ++m) name_of[tree.members[m]] = names[m];
  const std::vector<std::uint32_t> order =
      back_to_front(tree, Projection::kTowardsEye * (1e6 * reach));
  std::vector<Corners> parts;
  for (const std::uint32_t item : order)
    parts.push_back(projected(tree, tree.polygon(item), project));
  for (std::size_t i = 0; i < order.size(); ++i) {
    const WorkPolygon& polygon = tree.polygon(order[i]);
    const Vec3 centre = centre_of(tree, polygon);
    drawing.polygon(parts[i], {.fill = "#ffffff"});
    draw_normal(drawing, tree.set.planes[polygon.plane].normal, centre, project);
    const Vec2 beside{project(centre).x + 10, project(centre).y + 7};  // of the arrow
    const Vec2 at = place_of_name(parts[i], beside, std::span(parts).subspan(i + 1));
    drawing.text({at.x, at.y + 3}, name_of[order[i]], 9, SvgAnchor::kMiddle);
  }
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
  constexpr double kHeading = 30;
  Projection project;
  if (scene) {
    project = fit(tree, {right, kMargin + kHeading});
    low = std::max(low, project.height + 2 * kMargin + kHeading);
  }
  SvgDrawing drawing(scene ? right + kSceneSize + kMargin : right, low, "BSP tree");
  drawing.text({kMargin, 24}, "Left branches are positive", 12);
  draw_tree(drawing, tree, places, names);
  if (scene) {
    drawing.text({right, 24}, "Arrows on the positive sides that are seen", 12);
    draw_scene(drawing, tree, names, project);
  }
  return drawing.svg();
}

}  // namespace cigsim
