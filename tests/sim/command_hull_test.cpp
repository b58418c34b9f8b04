// SPDX-License-Identifier: MIT
// cigsim hull and cigsim sphere as a person starts them.
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

// A cube of side 2 with a point inside, one in the middle of a face and a corner twice.
constexpr const char* kCube =
    "-1 -1 -1\n1 -1 -1\n-1 1 -1\n1 1 -1\n-1 -1 1\n1 -1 1\n-1 1 1\n1 1 1\n0 0 0\n0 0 1\n1 1 1\n";

TEST_F(CommandTest, HullOfAListOfPointsIsASceneThatRuns) {
  put("cube.xyz", kCube);
  for (const char* file : {"hull.obj", "hull.off", "hull.json", "hull.cbor"})
    for (const bool merge : {false, true})
      for (const bool levine : {false, true}) {
        SCOPED_TRACE(file);
        std::vector<std::string> arguments{"hull", "cube.xyz", "-o", file, "--json"};
        if (merge) arguments.push_back("--merge");
        if (levine) arguments.push_back("--levine");
        const Outcome made = cigsim(arguments);
        ASSERT_EQ(made.exit_code, 0) << made.err;
        const Json hull = Json::parse(made.out)["hulls"][0];
        EXPECT_EQ(hull["points"], 11);
        EXPECT_EQ(hull["dimension"], 3);
        EXPECT_EQ(hull["hull_points"], 8);
        EXPECT_EQ(hull["triangles"], 12);
        EXPECT_EQ(hull["facets"], 6);
        EXPECT_EQ(hull["equivalent_tests"], 3 * 11 * 12);
        EXPECT_EQ(hull.contains("rounds"), levine);
        const Outcome asked = cigsim({"requirements", file, "--json"});
        ASSERT_EQ(asked.exit_code, 0) << asked.err;
        // Preparation merges coplanar triangles itself.
        EXPECT_EQ(Json::parse(asked.out)["database"]["faces"], 6);
        EXPECT_EQ(cigsim({"run", file, "--raster", "32x32"}).exit_code, 0);
      }
}

TEST_F(CommandTest, HullTakesTheObjectsOfAScene) {
  ASSERT_EQ(cigsim({"generate", "cubes", "--objects", "5", "-o", "s.json"}).exit_code, 0);
  const Json all = Json::parse(cigsim({"hull", "s.json", "--json"}).out)["hulls"];
  EXPECT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0]["points"], 40);
  const Outcome each = cigsim({"hull", "s.json", "--per-object", "--json", "-o", "h.json"});
  ASSERT_EQ(each.exit_code, 0) << each.err;
  const Json hulls = Json::parse(each.out)["hulls"];
  ASSERT_EQ(hulls.size(), 5u);
  for (const Json& hull : hulls) EXPECT_EQ(hull["hull_points"], 8);
  EXPECT_EQ(Json::parse(cigsim({"requirements", "h.json", "--json"}).out)["database"]["objects"],
            5);
}

TEST_F(CommandTest, HullPrintsLevinesCounts) {
  put("cube.xyz", kCube);
  const Outcome shown = cigsim({"hull", "cube.xyz", "--levine"});
  ASSERT_EQ(shown.exit_code, 0) << shown.err;
  for (const char* part : {"the hull is a solid", "NPTH", "NT, ", "NEQ", "rounds"})
    EXPECT_NE(shown.out.find(part), std::string::npos) << part;
}

TEST_F(CommandTest, HullOfLowerDimensionIsTold) {
  put("line.xyz", "0 0 0\n1 1 1\n3 3 3\n");
  put("point.csv", "x,y,z\n1,2,3\n1,2,3\n");
  put("flat.csv", "0,0,5\n2,0,5\n2,2,5\n0,2,5\n1,1,5\n");
  EXPECT_NE(cigsim({"hull", "line.xyz"}).out.find("the hull is a line"), std::string::npos);
  EXPECT_NE(cigsim({"hull", "point.csv"}).out.find("the hull is a point"), std::string::npos);
  EXPECT_NE(cigsim({"hull", "flat.csv"}).out.find("the hull is a polygon"), std::string::npos);
  EXPECT_EQ(cigsim({"hull", "flat.csv", "-o", "flat.obj"}).exit_code, 0);
  EXPECT_EQ(cigsim({"run", "flat.obj", "--raster", "16x16"}).exit_code, 0);
  expect_unusable({"hull", "line.xyz", "-o", "line.obj"}, "no face to write");
}

TEST_F(CommandTest, SphereByBothMethodsIsTheSame) {
  put("cube.xyz", kCube);
  const Json fast = Json::parse(cigsim({"sphere", "cube.xyz", "--json"}).out)["spheres"][0];
  const Json slow =
      Json::parse(cigsim({"sphere", "cube.xyz", "--method", "levine", "--json"}).out)["spheres"][0];
  EXPECT_EQ(fast["centre"], (Json{0.0, 0.0, 0.0}));
  EXPECT_EQ(slow["centre"], fast["centre"]);
  EXPECT_EQ(slow["radius"], fast["radius"]);
  EXPECT_GE(fast["radius"].get<double>() * fast["radius"].get<double>(), 3);
  EXPECT_EQ(slow["levine"]["hull_points"], 8);
  EXPECT_EQ(slow["levine"]["spheres_created"], 1);
  EXPECT_FALSE(fast.contains("levine"));
  const Outcome text = cigsim({"sphere", "cube.xyz", "--method", "levine"});
  for (const char* part : {"centre", "radius", "rests on", "NSC", "NST", "ESC", "SP, ", "TSC"})
    EXPECT_NE(text.out.find(part), std::string::npos) << part;
}

TEST_F(CommandTest, SphereSearchOfLevinesMayGiveUp) {
  // Three points make the sphere, and the sharpest order puts one of them last.
  put("low.csv", "0,1,0\n0,-1,0\n8,0,0\n4,0,3.5\n");
  const Outcome published =
      cigsim({"sphere", "low.csv", "--method", "levine", "--published-loops"});
  EXPECT_EQ(published.exit_code, 1);
  EXPECT_NE(published.out.find("NO sphere"), std::string::npos);
  EXPECT_EQ(cigsim({"sphere", "low.csv", "--method", "levine"}).exit_code, 0);
  EXPECT_EQ(cigsim({"sphere", "low.csv", "--method", "levine", "--last-point", "3"}).exit_code, 1);
  EXPECT_EQ(cigsim({"sphere", "low.csv", "--method", "levine", "--last-point", "all"}).exit_code,
            0);
}

TEST_F(CommandTest, HullAndSphereRefuseWhatTheyCannotUse) {
  put("bad.xyz", "1 2 3\n1 2\n");
  put("huge.xyz", "1.7e308 1.7e308 1.7e308\n-1.7e308 -1.7e308 -1.7e308\n");
  put("points.xyz", kCube);
  for (const char* command : {"hull", "sphere"}) {
    expect_unusable({command, "bad.xyz"}, "bad.xyz:2: has 2 numbers");
    expect_unusable({command, "none.xyz"}, "none.xyz: no such file");
    expect_unusable({command, "points.txt"}, "points.txt");
    expect_unusable({command}, "FILE");
  }
  expect_unusable({"sphere", "huge.xyz"}, "beyond the largest double");
  expect_unusable({"sphere", "points.xyz", "--method", "gauss"}, "--method");
  expect_unusable({"sphere", "points.xyz", "--last-point", "1"}, "--last-point");
  expect_unusable({"hull", "points.xyz", "-o", "a.stl"}, "must end in .off or .obj");
  expect_unusable({"hull", "points.xyz", "-o", "absent/a.obj"}, "absent/a.obj");
}

}  // namespace
}  // namespace cigsim
