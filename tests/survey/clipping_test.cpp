// SPDX-License-Identifier: MIT
// Observer's transform, perspective and clipping of Sandor 1979 (sec. 3 and 4), against other ways
// to the same results.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/random.hpp"
#include "models/survey/clipping/cluster_clip.hpp"
#include "models/survey/clipping/edge_clip.hpp"
#include "models/survey/clipping/observer.hpp"
#include "models/survey/clipping/polygon_clip.hpp"
#include "models/survey/clipping/scene_clip.hpp"

namespace cigsim::survey {
namespace {

Vec3 random_point(Random& random, double reach) {
  return {random.between(-reach, reach), random.between(-reach, reach),
          random.between(-reach, reach)};
}
ExactVec exact(const Vec3& v) { return convert<Exact>(v); }

// A whole number in -reach .. reach, so that points often meet the box's sides.
double whole(Random& random, int reach) {
  return static_cast<double>(random.below(static_cast<std::uint64_t>(2 * reach + 1))) - reach;
}
ExactVec whole_point(Random& random, int reach) {
  return exact({whole(random, reach), whole(random, reach), whole(random, reach)});
}

TEST(Sandor, ObserverMatrixEquation312IsTheProductOfTheTurns) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const ObserverAngles angles{random.between(-180, 180), random.between(-180, 180),
                                random.between(-180, 180)};
    const Vec3 observer = random_point(random, 100), p = random_point(random, 100);
    const Mat3 turned = observer_rotation(angles);
    const auto t = observer_matrix(observer, angles);
    const Vec3 want = turned * (p - observer);
    const double got[3] = {t[0][0] * p.x + t[0][1] * p.y + t[0][2] * p.z + t[0][3],
                           t[1][0] * p.x + t[1][1] * p.y + t[1][2] * p.z + t[1][3],
                           t[2][0] * p.x + t[2][1] * p.y + t[2][2] * p.z + t[2][3]};
    EXPECT_NEAR(got[0], want.x, 1e-11);
    EXPECT_NEAR(got[1], want.y, 1e-11);
    EXPECT_NEAR(got[2], want.z, 1e-11);  // not with cos(theta3) for cos(theta2), as scanned
    // A turn keeps lengths and handedness.
    EXPECT_NEAR(dot(want, want), dot(p - observer, p - observer), 1e-8);
    EXPECT_NEAR(dot(cross(turned.row[0], turned.row[1]), turned.row[2]), 1, 1e-12);
  }
}

TEST(Sandor, TurnsGoAboutYThenXThenZ) {
  const auto near = [](const Vec3& a, const Vec3& b) {
    EXPECT_NEAR(a.x, b.x, 1e-15);
    EXPECT_NEAR(a.y, b.y, 1e-15);
    EXPECT_NEAR(a.z, b.z, 1e-15);
  };
  near(observer_rotation({90, 0, 0}) * Vec3{1, 0, 0}, {0, 0, 1});   // looks along X
  near(observer_rotation({0, 90, 0}) * Vec3{0, -1, 0}, {0, 0, 1});  // looks down
  near(observer_rotation({0, 0, 90}) * Vec3{0, 1, 0}, {1, 0, 0});
  // Looking along X and then down is looking down, X ahead being the top of the picture.
  near(observer_rotation({90, 90, 0}) * Vec3{0, -1, 0}, {0, 0, 1});
  near(observer_rotation({90, 90, 0}) * Vec3{1, 0, 0}, {0, 1, 0});
}

TEST(Sandor, PerspectiveDepthEquation321KeepsLinesStraightPlanesFlatAndDepthInOrder) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto ahead = [&] {
      ExactVec p = whole_point(random, 20);
      p.z = abs(p.z) + 3;
      return p;
    };
    const Exact d(1 + random.below(3));
    const ExactVec a = ahead(), b = ahead(), c = ahead();
    const Exact s(Exact(random.below(9)) / 8), t(Exact(random.below(9)) / 8);
    const ExactVec on_line = a + (b - a) * Exact(s);
    const ExactVec on_plane = on_line + (c - a) * Exact(t);
    const ExactVec pa = perspective(a, d), pb = perspective(b, d), pc = perspective(c, d);
    EXPECT_TRUE(cross(pb - pa, perspective(on_line, d) - pa) == ExactVec{});
    if (on_plane.z > 0) {
      EXPECT_EQ(sgn(dot(cross(pb - pa, pc - pa), perspective(on_plane, d) - pa)), 0);
    }
    EXPECT_EQ(sgn(Exact(pa.z - pb.z)), sgn(Exact(a.z - b.z)));
    ExactVec nearest = a;
    nearest.z = d;
    EXPECT_EQ(sgn(perspective(nearest, d).z), 0);
  }
}

ViewBox<double> random_box(Random& random) {
  return {random.between(0.1, 3), random.between(0.1, 4), random.between(0.1, 4)};
}

bool holds(const ViewBox<double>& box, const Vec3& p) { return region(p, box) == 0; }

TEST(Sandor, ClusterClipSec41KeepsEveryVisibleSphere) {
  int rejected = 0, kept = 0, inside = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const ViewBox<double> box = random_box(random);
    const Vec3 centre = random_point(random, 10);
    const double radius = std::exp(random.between(-4, 2.5));
    const ClusterView found = clip_cluster(centre, radius, box, 0);
    const bool published = published_rule_rejects(centre, radius, box.d, box.half_width);
    bool visible = false, all = true;
    for (int k = 0; k < 200; ++k) {
      Vec3 v = random_point(random, 1);
      v = v * (radius * (k % 2 ? random.unit() : 1) / std::sqrt(dot(v, v)));
      const bool seen = holds(box, centre + v);
      visible |= seen;
      all &= seen;
    }
    EXPECT_FALSE(visible && found == ClusterView::kOutside);
    EXPECT_FALSE(!all && found == ClusterView::kInside);
    EXPECT_FALSE(visible && published && box.half_height <= box.half_width);
    rejected += found == ClusterView::kOutside;
    inside += found == ClusterView::kInside;
    kept += found == ClusterView::kCut;
  }
  EXPECT_GT(rejected, 500);
  EXPECT_GT(kept, 500);
  EXPECT_GT(inside, 20);
}

TEST(Sandor, ClusterRuleSec41IsOursForSpheresWhoseCentreIsAhead) {
  int compared = 0, behind_kept = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    ViewBox<double> box = random_box(random);
    box.half_height = box.half_width;  // his screen is square
    const Vec3 centre = random_point(random, 10);
    const double radius = std::exp(random.between(-4, 2));
    const bool ours = clip_cluster(centre, radius, box, 0) == ClusterView::kOutside;
    const bool published = published_rule_rejects(centre, radius, box.d, box.half_width);
    if (centre.z > 0) {
      EXPECT_EQ(ours, published);
      ++compared;
    } else {
      EXPECT_TRUE(ours || !published);
      behind_kept += ours && !published;
    }
  }
  EXPECT_GT(compared, 1000);
  // Spheres about the plane of the eye have no angle, or that of their mirror image, and stay.
  EXPECT_GT(behind_kept, 0);
}

TEST(Sandor, ClusterImageSec41BoundsTheImage) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Vec3 centre = random_point(random, 10);
    const double radius = random.between(0.1, 3), d = random.between(0.1, 2);
    centre.z = radius * 1.05 + random.between(0, 10);
    const auto image = cluster_image(centre, radius, d);
    ASSERT_TRUE(image);
    ClusterImage seen{1e300, -1e300, 1e300, -1e300};
    for (int k = 0; k < 4000; ++k) {
      Vec3 v = random_point(random, 1);
      const Vec3 p = perspective(centre + v * (radius / std::sqrt(dot(v, v))), d);
      seen = {std::min(seen.left, p.x), std::max(seen.right, p.x), std::min(seen.bottom, p.y),
              std::max(seen.top, p.y)};
    }
    const double wide = image->right - image->left, high = image->top - image->bottom;
    EXPECT_GE(seen.left, image->left - 1e-9 * wide);
    EXPECT_LE(seen.right, image->right + 1e-9 * wide);
    EXPECT_GE(seen.bottom, image->bottom - 1e-9 * high);
    EXPECT_LE(seen.top, image->top + 1e-9 * high);
    EXPECT_GT(seen.right - seen.left, 0.8 * wide);
    EXPECT_GT(seen.top - seen.bottom, 0.8 * high);
  }
  EXPECT_FALSE(cluster_image({0, 0, 1}, 1, 1));
}

TEST(ClusterClip, DropsWhatTheDisplayCannotShow) {
  const ViewBox<double> box{1, 1, 1};
  EXPECT_EQ(clip_cluster({0, 0, 100}, 0.1, box, 0.01), ClusterView::kTooSmall);
  EXPECT_EQ(clip_cluster({0, 0, 10}, 0.1, box, 0.01), ClusterView::kInside);
  EXPECT_EQ(clip_cluster({0, 0, 100}, 0.1, box, 0), ClusterView::kInside);
  EXPECT_EQ(clip_cluster({0, 0, 0}, 5, box, 100), ClusterView::kCut);  // about the eye
  EXPECT_EQ(clip_cluster({500, 0, 100}, 0.1, box, 1), ClusterView::kOutside);
  EXPECT_EQ(clip_cluster({0, 0, 5}, 0, box, 0), ClusterView::kInside);
}

// The visible interval of an edge by parameters alone (Cyrus and Beck 1978): another method.
std::optional<std::pair<Exact, Exact>> interval(const ExactVec& a, const ExactVec& b,
                                                const ViewBox<Exact>& box) {
  const auto distances = [&box](const ExactVec& p) {
    return std::vector<Exact>{Exact(p.z - box.d), Exact(box.half_width * p.z - box.d * p.x),
                              Exact(box.half_width * p.z + box.d * p.x),
                              Exact(box.half_height * p.z - box.d * p.y),
                              Exact(box.half_height * p.z + box.d * p.y)};
  };
  const std::vector<Exact> da = distances(a), db = distances(b);
  Exact low(0), high(1);
  for (std::size_t i = 0; i < da.size(); ++i) {
    if (sgn(da[i]) < 0 && sgn(db[i]) < 0) return std::nullopt;
    if (sgn(da[i]) >= 0 && sgn(db[i]) >= 0) continue;
    const Exact t(da[i] / (da[i] - db[i]));
    if (sgn(da[i]) < 0)
      low = std::max(low, t);
    else
      high = std::min(high, t);
  }
  if (low > high) return std::nullopt;
  return std::pair(low, high);
}

TEST(Sandor, EdgeClipSec42) {
  int seen = 0, none = 0;
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const ViewBox<Exact> box{Exact(1 + random.below(2)), Exact(1 + random.below(3)),
                             Exact(1 + random.below(3))};
    const ExactVec a = whole_point(random, 5), b = seed % 50 ? whole_point(random, 5) : a;
    const auto want = interval(a, b, box);
    const auto got = clip_edge(a, b, box);
    ASSERT_EQ(got.has_value(), want.has_value());
    (got ? seen : none)++;
    if (!got) continue;
    const auto at = [&](const Exact& t) {
      const ExactVec p = perspective(ExactVec(a + (b - a) * t), box.d);
      return ScreenPoint<Exact>{p.x, p.y};
    };
    EXPECT_TRUE(got->a == at(want->first));
    EXPECT_TRUE(got->b == at(want->second));
    // In doubles the same but for rounding.
    const auto rounded = [](const ExactVec& v) {
      return Vec3{v.x.get_d(), v.y.get_d(), v.z.get_d()};
    };
    const ViewBox<double> small{box.d.get_d(), box.half_width.get_d(), box.half_height.get_d()};
    const auto near = clip_edge(rounded(a), rounded(b), small);
    if (want->first == want->second || !near) continue;  // a touch may be lost
    EXPECT_NEAR(near->a.x, got->a.x.get_d(), 1e-12);
    EXPECT_NEAR(near->b.y, got->b.y.get_d(), 1e-12);
  }
  EXPECT_GT(seen, 200);
  EXPECT_GT(none, 200);
}

using Screen = std::vector<ScreenPoint<Exact>>;

Exact area(const Screen& ring) {
  Exact twice(0);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return Exact(twice / 2);
}

Screen project(const std::vector<ExactVec>& ring, const Exact& d) {
  Screen out;
  for (const ExactVec& v : ring) {
    const ExactVec p = perspective(v, d);
    out.push_back({p.x, p.y});
  }
  return out;
}

// Area of a triangle within the screen, without a polygon clipper: between two neighbours of all
// x at which an edge ends or meets top or bottom, the height within is linear.
Exact area_by_strips(const Screen& triangle, const ViewBox<Exact>& box) {
  const Exact &w = box.half_width, &h = box.half_height;
  std::vector<Exact> xs{Exact(-w), w};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &a = triangle[i], &b = triangle[(i + 1) % 3];
    xs.push_back(a.x);
    for (const Exact& y : {Exact(h), Exact(-h)})
      if (a.y != b.y) xs.push_back(Exact(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y)));
  }
  std::sort(xs.begin(), xs.end());
  const auto height = [&](const Exact& x) {
    bool any = false;
    Exact low(0), high(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = triangle[i], &b = triangle[(i + 1) % 3];
      if (a.x == b.x || x < std::min(a.x, b.x) || x > std::max(a.x, b.x)) continue;
      const Exact y(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
      low = any ? std::min(low, y) : y;
      high = any ? std::max(high, y) : y;
      any = true;
    }
    const Exact bottom(std::max(low, Exact(-h))), top(std::min(high, h));
    return any && top > bottom ? Exact(top - bottom) : Exact(0);
  };
  Exact sum(0);
  for (std::size_t i = 0; i + 1 < xs.size(); ++i)
    if (xs[i] >= -w && xs[i + 1] <= w)
      sum += (xs[i + 1] - xs[i]) * height(Exact((xs[i] + xs[i + 1]) / 2));
  return sum;
}

// What the clipper leaves of a ring that lies beyond the view plane throughout, as the signed sum
// of the triangles that fan out from its first vertex.
Exact area_by_fan(const std::vector<ExactVec>& ring, const ViewBox<Exact>& box) {
  const Screen screen = project(ring, box.d);
  Exact sum(0);
  for (std::size_t i = 1; i + 1 < screen.size(); ++i) {
    const Screen triangle{screen[0], screen[i], screen[i + 1]};
    sum += sgn(area(triangle)) * area_by_strips(triangle, box);
  }
  return sum;
}

TEST(Sandor, PolygonClipSec43AgainstExactAreas) {
  int cut = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const ViewBox<Exact> box{Exact(1), Exact(1 + random.below(3)), Exact(1 + random.below(3))};
    // In a plane z = k + m x of small slope; vertices in any order, so concave and crossed too.
    const Exact k(40 + random.below(40)), m(static_cast<long>(random.below(3)) - 1);
    std::vector<ExactVec> ring;
    const std::size_t corners = 3 + random.below(5);
    for (std::size_t i = 0; i < corners; ++i) {
      const Exact x(whole(random, 30) * 5), y(whole(random, 30) * 5);
      ring.push_back({Exact(x / 5), y, Exact(k + m * x / 5)});
    }
    PolygonWork work;
    const std::vector<ExactVec> got = clip_polygon(ring, box, work);
    EXPECT_EQ(area(project(got, box.d)), area_by_fan(ring, box));
    for (const ExactVec& p : got) EXPECT_EQ(region(p, box), 0);
    cut += work.meetings > 0 && !got.empty();
  }
  EXPECT_GT(cut, 100);
}

TEST(Sandor, PolygonRoundACornerOfTheViewBoxFig45) {
  // The polygon surrounds the upper right corner: two edges meet there that no edge clip gives.
  const ViewBox<Exact> box{Exact(1), Exact(1), Exact(1)};
  const std::vector<ExactVec> ring{exact({0, 0, 1}), exact({4, 0, 1}), exact({4, 4, 1}),
                                   exact({0, 4, 1})};
  PolygonWork work;
  const std::vector<ExactVec> got = clip_polygon(ring, box, work);
  ASSERT_EQ(got.size(), 4u);
  EXPECT_TRUE(std::any_of(got.begin(), got.end(), [](const ExactVec& p) {
    return p == exact({1, 1, 1});
  }));
  EXPECT_EQ(work.meetings, 4u);
}

TEST(PolygonClip, AcrossTheViewPlaneAndBehindTheEye) {
  const ViewBox<Exact> box{Exact(1), Exact(2), Exact(2)};
  PolygonWork work;
  // A floor from far behind to far ahead: a trapezium from the view plane on.
  const std::vector<ExactVec> floor{exact({-100, -1, -50}), exact({100, -1, -50}),
                                    exact({100, -1, 50}), exact({-100, -1, 50})};
  const std::vector<ExactVec> got = clip_polygon(floor, box, work);
  ASSERT_GE(got.size(), 4u);
  EXPECT_EQ(abs(area(project(got, box.d))), Exact(98, 25));  // from y = -1 to -1/50, 4 wide
  EXPECT_TRUE(
      clip_polygon(std::vector<ExactVec>{exact({0, 0, -1}), exact({1, 0, -1}), exact({0, 1, -2})},
                   box, work)
          .empty());
  EXPECT_TRUE(clip_polygon(std::vector<ExactVec>{}, box, work).empty());
  // Touched in an edge alone: nothing of it has an area.
  EXPECT_TRUE(
      clip_polygon(std::vector<ExactVec>{exact({2, 0, 1}), exact({2, 1, 1}), exact({3, 0, 1})}, box,
                   work)
          .empty());
}

TEST(SceneClip, CountsAddUp) {
  const Database database = prepare(generate_environment("city", {200, 1}));
  Viewpoint viewpoint{database.view.eye, database.view.fov};
  std::uint64_t items = database.ground.items.size();
  for (const Item& item : database.systems[0].set.items) items += item.face_count > 0;
  for (const double plane : {1e-3, 1.0, 300.0}) {
    const ClipCounts c = clip_scene(database, viewpoint, {256, 256}, 0, plane);
    EXPECT_EQ(c.items.tested + c.items_inside_groups + c.items_dropped_with_groups, items);
    EXPECT_EQ(c.items.tested, c.items.outside + c.items.too_small + c.items.inside + c.items.cut);
    EXPECT_EQ(c.edges.tested, c.edges.outside + c.edges.inside + c.edges.cut);
    EXPECT_EQ(c.polygons.tested, c.polygons.outside + c.polygons.inside + c.polygons.cut);
    EXPECT_EQ(c.groups.tested,
              c.groups.outside + c.groups.too_small + c.groups.inside + c.groups.cut);
  }
  viewpoint.eye.pitch = 90;  // at the sky
  const ClipCounts up = clip_scene(database, viewpoint, {256, 256}, 0, 1);
  EXPECT_EQ(up.items.inside + up.items_inside_groups, 0u);
  Database empty;
  empty.systems.emplace_back();
  EXPECT_EQ(clip_scene(empty, viewpoint, {8, 8}, 0, 1).items.tested, 0u);
}

}  // namespace
}  // namespace cigsim::survey
