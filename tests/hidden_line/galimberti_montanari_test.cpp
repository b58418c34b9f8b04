// SPDX-License-Identifier: MIT
#include "models/hidden_line/galimberti_montanari.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "models/environment/input_error.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/hidden_line/hidden_lines.hpp"
#include "models/hidden_line/scene_parts.hpp"

namespace cigsim::hidden_line {
namespace {

std::string scene(const std::string& name) {
  return std::string(CIGSIM_SOURCE_DIR) + "/scenes/pfister-" + name + ".cards";
}

CardsStructure structure_of(const std::string& name) {
  return read_cards_deck(scene(name)).structures.back();
}

CardsView view_at(double theta, double phi) { return {12, 4, theta, phi, 0, 0, 0, 0}; }

PartSet parts(const std::string& name) {
  const Environment environment = read_environment(scene(name)).environment;
  const std::vector<Placement> placements(environment.systems.size());
  Notices notices;
  return scene_parts(environment, placements, {}, notices);
}

ViewTransform transform(const CardsView& view) {
  const DefaultView v = cards_view(view);
  return frame_calculator::view_transform({v.eye, v.fov}, {1000, 1000});
}

// A line as its two ends in space, in the environment's axes.
using Line = std::pair<std::array<double, 3>, std::array<double, 3>>;
Line line_of(const Vec3& a, const Vec3& b) {
  std::array<double, 3> p{a.x, a.y, a.z}, q{b.x, b.y, b.z};
  for (auto* end : {&p, &q})
    for (double& x : *end) x += 0.0;
  return std::minmax(p, q);
}

std::set<Line> pfister_lines(const CardsStructure& structure, const HiddenEdges& hidden,
                             const SolvedStructure& solved) {
  std::set<Line> out;
  for (const DrawnEdge& drawn : hidden.drawn) {
    const SolvedEdge& edge = solved.edges[drawn.edge];
    out.insert(line_of(from_cards_axes(structure.vertices[edge.ends[0]].position),
                       from_cards_axes(structure.vertices[edge.ends[1]].position)));
  }
  return out;
}

TEST(Pfister, AConvexBlockHasNoConcaveEdge) {
  const SolvedStructure solved = solve(structure_of("block"), "block");
  EXPECT_EQ(solved.edges.size(), 15u);
  EXPECT_FALSE(solved.concave());
}

TEST(Pfister, ANotchHasOneConcaveEdge) {
  const CardsStructure notch = structure_of("notch");
  const SolvedStructure solved = solve(notch, "notch");
  EXPECT_EQ(solved.edges.size(), 18u);
  std::vector<SolvedEdge> concave;
  std::copy_if(solved.edges.begin(), solved.edges.end(), std::back_inserter(concave),
               [](const SolvedEdge& e) { return e.concave; });
  ASSERT_EQ(concave.size(), 1u);
  for (const std::uint32_t end : concave[0].ends) {
    EXPECT_EQ(notch.vertices[end].position.x, 0);
    EXPECT_EQ(notch.vertices[end].position.y, 0);
  }
}

// Axis by axis at THETA = PHI = 0, and a turn of his formulas.
TEST(Pfister, HisTransform) {
  Vec2 p;
  ASSERT_TRUE(transpose(view_at(0, 0), {1, 2, 0}, p));
  EXPECT_NEAR(p.x, 4.0 / 12, 1e-15);
  EXPECT_NEAR(p.y, 8.0 / 12, 1e-15);
  ASSERT_TRUE(transpose(view_at(0, 0), {1, 2, 4}, p));
  EXPECT_NEAR(p.x, 4.0 / 8, 1e-15);
  ASSERT_TRUE(transpose(view_at(90, 0), {0, 0, 1}, p));
  EXPECT_NEAR(p.x, 4.0 / 12, 1e-15);
  ASSERT_TRUE(transpose(view_at(0, 90), {0, 0, -1}, p));
  EXPECT_NEAR(p.y, 4.0 / 12, 1e-15);
  ASSERT_TRUE(transpose(view_at(33, -71), {0, 0, 0}, p));
  EXPECT_EQ(p.x, 0);
  EXPECT_EQ(p.y, 0);
  // In the plane of the eye his program divides by zero, behind it it mirrors.
  EXPECT_FALSE(transpose(view_at(0, 0), {1, 2, 12}, p));
  EXPECT_FALSE(transpose(view_at(0, 0), {1, 2, 13}, p));
}

// The environment's view of the same deck gives the same places.
TEST(Pfister, TheEnvironmentSeesTheSame) {
  for (const double theta : {0.0, 25.0, 140.0, -77.0})
    for (const double phi : {0.0, 30.0, -60.0}) {
      const CardsView view = view_at(theta, phi);
      const ViewTransform t = transform(view);
      for (const CardsVertex& v : structure_of("notch").vertices) {
        Vec2 p;
        ASSERT_TRUE(transpose(view, v.position, p));
        const Vec3 q = t.rotation * (from_cards_axes(v.position) - t.eye);
        EXPECT_NEAR(500 + 500 * p.x, 500 + t.focal * q.y / q.x, 1e-9);
        EXPECT_NEAR(500 - 500 * p.y, 500 - t.focal * q.z / q.x, 1e-9);
      }
    }
}

// On one convex object his picture is Levine's, from all round.
TEST(Pfister, AConvexObjectIsRight) {
  const CardsStructure block = structure_of("block");
  const SolvedStructure solved = solve(block, "block");
  HiddenLines exact(parts("block"));
  for (int theta = 0; theta < 360; theta += 15)
    for (int phi = -75; phi <= 75; phi += 30) {
      const CardsView view = view_at(theta + 0.5, phi);
      const HiddenEdges hidden = hide(block, solved, view);
      exact.compute(transform(view));
      std::set<Line> lines;
      for (const Piece& piece : exact.pieces()) {
        const Part& part = exact.parts()[piece.part];
        const PartEdge& edge = part.edges[piece.edge];
        EXPECT_EQ(piece.to - piece.from, 1);
        lines.insert(line_of(part.vertices[edge.a], part.vertices[edge.b]));
      }
      EXPECT_EQ(pfister_lines(block, hidden, solved), lines) << theta << " " << phi;
    }
}

double length(const Vec2& a, const Vec2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

// A concave object is not solved: with the arm of the notch before the rest, lines show that the
// arm covers.
TEST(Pfister, AConcaveObjectKeepsLinesThatOtherFacesCover) {
  const CardsStructure notch = structure_of("notch");
  const SolvedStructure solved = solve(notch, "notch");
  HiddenLines exact(parts("notch"));
  double worst = 0;
  std::uint32_t dropped_concave = 0;
  for (int theta = 0; theta < 360; theta += 15) {
    const CardsView view = view_at(theta + 0.5, 25);
    const HiddenEdges hidden = hide(notch, solved, view);
    dropped_concave += hidden.dropped_concave;
    double his = 0, right = 0;
    for (const DrawnEdge& drawn : hidden.drawn) his += length(drawn.from, drawn.to);
    exact.compute(transform(view));
    for (const Piece& piece : exact.pieces()) {
      const Part& part = exact.parts()[piece.part];
      const auto at = [&](double t) {
        const PartEdge& edge = part.edges[piece.edge];
        const Vec3 p = part.vertices[edge.a] + (part.vertices[edge.b] - part.vertices[edge.a]) * t;
        Vec2 out;
        EXPECT_TRUE(transpose(view, {p.x, p.z, -p.y}, out));
        return out;
      };
      right += length(at(piece.from), at(piece.to));
    }
    // He never draws too little.
    EXPECT_GE(his, right - 1e-9) << theta;
    worst = std::max(worst, his - right);
  }
  EXPECT_GT(worst, 0.1);
  EXPECT_GT(dropped_concave, 0u);
}

// Two convex bodies in one structure: the near one does not hide the far one.
TEST(Pfister, SeveralObjectsDoNotHideEachOther) {
  CardsStructure two = structure_of("block");
  const CardsStructure one = two;
  const auto first = static_cast<std::uint32_t>(two.vertices.size());
  for (CardsVertex v : one.vertices) {
    v.position.z -= 6;
    v.position = v.position * 0.5;
    two.vertices.push_back(v);
  }
  for (CardsFace f : one.faces) {
    for (std::uint32_t& v : f.vertices) v += first;
    two.faces.push_back(f);
  }
  const CardsView view = view_at(0.5, 0.5);
  const std::size_t alone = hide(one, solve(one, "one"), view).drawn.size();
  EXPECT_GT(hide(two, solve(two, "two"), view).drawn.size(), alone);
}

TEST(Pfister, FunctionKeys) {
  CardsView view{10, 4, 30, 20, 0, 0, 0, 0};
  EXPECT_FALSE(press(0, view, true));
  EXPECT_FALSE(press(1, view, true));
  EXPECT_FALSE(press(15, view, true));
  const struct {
    int key;
    double CardsView::*increment;
    double value;
  } keys[] = {{3, &CardsView::dtheta, 2}, {4, &CardsView::dtheta, -2}, {5, &CardsView::dtheta, 0},
              {6, &CardsView::dphi, 2},   {7, &CardsView::dphi, -2},   {8, &CardsView::dphi, 0},
              {9, &CardsView::dr, 0.25},  {10, &CardsView::dr, -0.25}, {11, &CardsView::dr, 0},
              {12, &CardsView::dd, 0.2},  {13, &CardsView::dd, -0.2},  {14, &CardsView::dd, 0}};
  for (const auto& k : keys) {
    EXPECT_TRUE(press(k.key, view, true));
    EXPECT_EQ(view.*k.increment, k.value) << k.key;
  }
  for (const int key : {3, 6, 9, 12}) press(key, view, true);
  EXPECT_TRUE(press(2, view, true));
  EXPECT_EQ(view.dtheta, 0);
  EXPECT_EQ(view.dphi, 0);
  EXPECT_EQ(view.dr, 0);
  EXPECT_EQ(view.dd, 0);
}

// RMAG = R + DR: the listing adds the increment to R for the picture and forgets it.
TEST(Pfister, DistancesMoveOnceAsPublished) {
  for (const bool as_published : {true, false}) {
    CardsView view{10, 4, 0, 0, 0, 0, 0, 0};
    press(9, view, as_published);
    press(3, view, as_published);
    for (int i = 0; i < 4; ++i) step(view, as_published);
    EXPECT_EQ(view.theta, 8);
    EXPECT_EQ(view.r + view.dr, as_published ? 10.25 : 11);
    press(11, view, as_published);
    step(view, as_published);
    EXPECT_EQ(view.r + view.dr, as_published ? 10 : 11);
  }
}

TEST(Pfister, TheEyeDoesNotPassTheOrigin) {
  CardsView view{1, 0.5, 0, 0, 0, 0, 0, 0};
  press(10, view, false);
  press(13, view, false);
  for (int i = 0; i < 40; ++i) step(view, false);
  EXPECT_GT(view.r + view.dr, 0);
  EXPECT_GT(view.d + view.dd, 0);
}

TEST(Pfister, EdgesWithoutTwoFacesAreRefused) {
  const auto message = [](const CardsStructure& structure) -> std::string {
    try {
      solve(structure, "d");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CardsStructure open = structure_of("block");
  open.faces.pop_back();
  EXPECT_NE(message(open).find("has one face only"), std::string::npos);
  CardsStructure turned = structure_of("block");
  std::reverse(turned.faces[2].vertices.begin(), turned.faces[2].vertices.end());
  EXPECT_NE(message(turned).find("in the same direction"), std::string::npos);
  CardsStructure thrice = structure_of("block");
  thrice.faces.push_back(thrice.faces[0]);
  EXPECT_NE(message(thrice).find("a third face"), std::string::npos);
  CardsStructure flat = structure_of("block");
  flat.faces.insert(flat.faces.begin(), CardsFace{9, {0, 1, 0}, 3});
  EXPECT_NE(message(flat).find("d:3: face 9 has no area"), std::string::npos);
}

}  // namespace
}  // namespace cigsim::hidden_line
