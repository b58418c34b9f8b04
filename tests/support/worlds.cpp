// SPDX-License-Identifier: MIT
#include "tests/support/worlds.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/bodies.hpp"

namespace cigsim::test {
namespace {

double on_grid(double x) { return std::round(x * 4) / 4; }

Vec3 random_point(Random& random, double reach) {
  return {random.between(-reach, reach), random.between(-reach, reach),
          random.between(-reach, reach)};
}

Vec3 grid_point(Random& random, double reach) {
  const Vec3 p = random_point(random, reach);
  return {on_grid(p.x), on_grid(p.y), on_grid(p.z)};
}

struct Cell {
  double low[3], high[3];
  Vec3 corner(int i) const {
    return {i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]};
  }
};

// Fills a cell with one box, two wedges, or the six tetrahedra around its diagonal (Kuhn).
void fill(World& world, const Cell& cell, Random& random) {
  const auto keep = [&] { return random.below(5) != 0; };
  switch (random.below(3)) {
    case 0:
      if (keep()) world.add(box_between(cell.corner(0), cell.corner(7)));
      break;
    case 1: {
      const int up = 1 << random.below(3);
      const int a = up == 1 ? 2 : 1, b = 7 - up - a;
      for (const int third : {a, b}) {
        if (!keep()) continue;
        std::vector<Vec3> points;
        for (const int base : {0, third, a | b})
          for (const int h : {0, up}) points.push_back(cell.corner(base | h));
        world.add(exact_hull(points));
      }
      break;
    }
    default:
      for (const auto& [a, b] : {std::pair{1, 2}, {1, 4}, {2, 1}, {2, 4}, {4, 1}, {4, 2}})
        if (keep())
          world.add(
              exact_hull({cell.corner(0), cell.corner(a), cell.corner(a | b), cell.corner(7)}));
  }
}

}  // namespace

World::World() { environment.models.push_back({"model", 0}); }

void World::add(Object object, bool is_open) {
  environment.objects.push_back(std::move(object));
  open.push_back(is_open);
}

std::vector<OraclePolygon> polygons_of(const World& world) {
  std::vector<OraclePolygon> polygons = oracle_polygons(world.environment, false);
  for (OraclePolygon& p : polygons) p.two_sided = world.open[p.object - 1];
  return polygons;
}

World disjoint_world(Random& random, int objects) {
  struct Ball {
    Vec3 centre;
    double radius;
  };
  std::vector<Ball> balls;
  World world;
  while (static_cast<int>(balls.size()) < objects) {
    Ball ball{{}, std::pow(10.0, random.between(-3, 3))};
    if (!balls.empty()) {
      const Ball& beside = balls[random.below(balls.size())];
      ball.centre = beside.centre + random_direction(random) *
                                        ((ball.radius + beside.radius) * random.between(1.001, 2));
    }
    bool apart = true;
    for (const Ball& other : balls) {
      const Vec3 d = ball.centre - other.centre;
      apart = apart && std::sqrt(dot(d, d)) > (ball.radius + other.radius) * 1.0001;
    }
    if (!apart) continue;
    balls.push_back(ball);
    world.add(random_body(ball.centre, ball.radius, random));
  }
  return world;
}

World touching_world(Random& random) {
  World world;
  std::vector<Cell> cells{{{-8, -8, -8}, {8, 8, 8}}};
  const std::size_t wanted = 3 + random.below(6);
  while (cells.size() < wanted) {
    Cell& cell = cells[random.below(cells.size())];
    const std::uint32_t axis = random.below(3);
    const double at = on_grid(random.between(cell.low[axis], cell.high[axis]));
    if (at <= cell.low[axis] || at >= cell.high[axis]) continue;
    Cell above = cell;
    above.low[axis] = at;
    cell.high[axis] = at;
    cells.push_back(above);
  }
  for (const Cell& cell : cells) fill(world, cell, random);
  if (world.open.empty()) world.add(box_between(cells[0].corner(0), cells[0].corner(7)));
  return world;
}

World triangle_soup(Random& random, int objects) {
  World world;
  for (int i = 0; i < objects; ++i)
    world.add(
        polygon({random_point(random, 10), random_point(random, 10), random_point(random, 10)}),
        true);
  return world;
}

World body_soup(Random& random, int objects) {
  World world;
  for (int i = 0; i < objects; ++i)
    world.add(random_body(random_point(random, 8), std::pow(10.0, random.between(-1, 1)), random));
  return world;
}

World grid_boxes(Random& random, int objects) {
  World world;
  while (static_cast<int>(world.open.size()) < objects) {
    const Vec3 a = grid_point(random, 4), size = grid_point(random, 3);
    const Vec3 b = a + Vec3{std::abs(size.x), std::abs(size.y), std::abs(size.z)};
    if (a.x < b.x && a.y < b.y && a.z < b.z) world.add(box_between(a, b));
  }
  return world;
}

World coplanar_polygons(Random& random, int objects) {
  World world;
  for (int i = 0; i < objects; ++i) {
    const double level = random.below(2);
    const std::uint32_t axis = random.below(2);
    const auto place = [&](double u, double v) {
      return axis == 0 ? Vec3{level, u, v} : Vec3{u, v, level};
    };
    const Vec3 p = grid_point(random, 4), q = grid_point(random, 4);
    const double u0 = std::min(p.x, q.x), u1 = std::max(p.x, q.x) + 1, v0 = std::min(p.y, q.y),
                 v1 = std::max(p.y, q.y) + 1;
    switch (random.below(4)) {
      case 0:
        world.add(polygon({place(u0, v0), place(u1, v0), place(u1, v1)}), true);
        break;
      case 1:
        world.add(polygon({place(u0, v0), place(u0, v1), place(u1, v1), place(u1, v0)}), true);
        break;
      case 2: {
        const double middle = on_grid((u0 + u1) / 2);
        world.add(polygon({place(u0, v0), place(u1, v0), place(u1 + 1, v1), place(middle, v1 + 1)}),
                  true);
        break;
      }
      default: {
        const Vec3 low = place(u0, v0), high = place(u1, v1);
        world.add(axis == 0 ? box_between({low.x - 1, low.y, low.z}, high)
                            : box_between(low, {high.x, high.y, high.z + 1}));
      }
    }
  }
  return world;
}

World lattice_world(Random& random, int objects) {
  const auto corner = [&] {
    const double x = random.below(3), y = random.below(3), z = random.below(3);
    return Vec3{x, y, z};
  };
  World world;
  while (static_cast<int>(world.open.size()) < objects) {
    std::vector<Vec3> points;
    for (const std::size_t count = random.below(2) ? 3 : 6; points.size() < count;) {
      const Vec3 p = corner();
      if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
    }
    if (points.size() == 3) {
      const bool flat = cross(points[1] - points[0], points[2] - points[0]) == Vec3{};
      if (!flat) world.add(polygon(points), true);
      continue;
    }
    Object body = exact_hull(points);
    if (body.faces.size() >= 4) world.add(std::move(body));
  }
  return world;
}

World cell_bodies(Random& random, int objects) {
  World world;
  while (static_cast<int>(world.open.size()) < objects) {
    constexpr int kSide = 3;
    bool filled[kSide + 2][kSide + 2][kSide + 2] = {};
    const std::uint32_t share = 3 + random.below(6);
    for (int i = 1; i <= kSide; ++i)
      for (int j = 1; j <= kSide; ++j)
        for (int k = 1; k <= kSide; ++k) filled[i][j][k] = random.below(10) < share;
    const Vec3 at = grid_point(random, 4);
    const double size = 0.5 * (1 + random.below(3));
    Object body;
    for (int i = 0; i <= kSide; ++i)
      for (int j = 0; j <= kSide; ++j)
        for (int k = 0; k <= kSide; ++k)
          for (int axis = 0; axis < 3; ++axis) {
            const bool here = filled[i][j][k];
            const bool next = filled[i + (axis == 0)][j + (axis == 1)][k + (axis == 2)];
            if (here == next) continue;
            // The square between the two cells, anticlockwise from the axis' far end.
            const Vec3 far{i + 1.0, j + 1.0, k + 1.0};
            const Vec3 a = axis == 0 ? Vec3{0, 1, 0} : axis == 1 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
            const Vec3 b = axis == 0 ? Vec3{0, 0, 1} : axis == 1 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
            Face face;
            for (const Vec3& p : {far - a - b, far - b, far, far - a}) {
              face.vertices.push_back(static_cast<std::uint32_t>(body.vertices.size()));
              body.vertices.push_back(at + p * size);
            }
            if (next) std::reverse(face.vertices.begin(), face.vertices.end());
            body.faces.push_back(face);
          }
    if (body.faces.empty()) continue;
    const bool is_open = random.below(4) == 0;
    if (is_open) body.faces.pop_back();
    world.add(std::move(body), is_open);
  }
  return world;
}

World mixed_world(Random& random) {
  World world;
  for (std::uint32_t parts = 2 + random.below(3); parts > 0; --parts) {
    World part;
    switch (random.below(5)) {
      case 0:
        part = touching_world(random);
        break;
      case 1:
        part = triangle_soup(random, 3);
        break;
      case 2:
        part = body_soup(random, 2);
        break;
      case 3:
        part = grid_boxes(random, 4);
        break;
      default:
        part = coplanar_polygons(random, 4);
    }
    for (std::size_t i = 0; i < part.open.size(); ++i)
      world.add(std::move(part.environment.objects[i]), part.open[i]);
  }
  return world;
}

World nested_world(Random& random) {
  World world;
  double r = 10;
  for (int i = 0; i < 5; ++i) {
    // A tetrahedron holds a sphere of a third of its radius at worst when it is regular: shells are
    // boxes and the innermost body is any.
    const double half = r / 2;
    world.add(random.below(2) ? box_between({-half, -half, -half}, {half, half, half})
                              : box_between({-half, -half / 2, -half}, {half / 2, half, half}));
    r *= random.below(3) == 0 ? 1 : 0.375;
  }
  world.add(random_body({}, r / 4, random));
  if (random.below(2)) world.add(random_body({random.between(-3, 3), 0, 0}, 1, random));
  return world;
}

}  // namespace cigsim::test
