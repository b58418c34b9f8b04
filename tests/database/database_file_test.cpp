// SPDX-License-Identifier: MIT
// The prepared database as a file: exact there and back, and nothing damaged gets in.
#include "models/database/database_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "models/environment/input_error.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

class DatabaseFile : public testing::Test {
 protected:
  std::filesystem::path put(const std::string& name, const std::string& bytes) const {
    return scratch_.write(name, bytes);
  }
  const test::Scratch scratch_;
  const std::filesystem::path& folder_ = scratch_.folder();
};

using test::bytes_of;

// A triangle as an item of its own.
void add_triangle(FaceSet& set, std::uint32_t object, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto vertex = static_cast<std::uint32_t>(set.vertices.size());
  const auto corner = static_cast<std::uint32_t>(set.corners.size());
  const auto face = static_cast<std::uint32_t>(set.faces.size());
  set.vertices.insert(set.vertices.end(), {a, b, c});
  set.corners.insert(set.corners.end(), {0, 1, 2});
  set.planes.push_back(plane_through(a, b, c));
  set.faces.push_back({corner, 3, face, object, {10, 20, 30}, object % 2 == 0});
  set.items.push_back({face, 1, vertex, 3, {a, 10}});
}

// Three triangles above one another, as a group of two below a root of two; a fourth that moves.
Database small_database() {
  Database database;
  database.name = "small";
  database.object_count = 4;
  database.object_names = {"low", "middle", "", "mover"};
  PreparedSystem world;
  world.name = "environment";
  for (std::uint32_t i = 0; i < 3; ++i) {
    const double z = i / 3.0;
    add_triangle(world.set, i + 1, {0, -0.0, z}, {0.1, 0, z}, {1e-300, 1e10, z});
  }
  const Exact third(1, 3);
  world.set.cut_vertices.push_back({3, {Exact(0), Exact(0), third}});
  world.hierarchy.planes = {axis_plane(2, 0.2), axis_plane(2, 0.5)};
  world.hierarchy.nodes = {{0, -1, -2, 1, 2}, {1, -1, -2, 1, 2}};
  world.hierarchy.members = {{true, 1, {{0, 0, 0.5}, 2}},
                             {false, 0, {{0, 0, 0}, 1}},
                             {false, 2, {{0, 0, 0.6}, 1}},
                             {false, 1, {{0, 0, 0.3}, 1}}};
  world.hierarchy.groups = {{0, 2, 0, 1}, {2, 2, 1, 1}};
  world.sphere = {{0, 0, 0.3}, 4};
  PreparedSystem mover;
  mover.name = "mover";
  mover.motion = {{0, {{1, 2, 3}, 10, 0, 0}}, {12.5, {{4, 5, 6}, 350, -5, 1}}};
  add_triangle(mover.set, 4, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  mover.hierarchy.members = {{false, 0, {{0, 0, 0}, 1}}};
  mover.hierarchy.groups = {{0, 1, 0, 0}};
  mover.sphere = {{0, 0, 0}, 1};
  database.systems = {world, mover};
  add_triangle(database.ground, 5, {-5, -5, 0}, {5, -5, 0}, {0, 5, 0});
  database.background = {1, 2, 3};
  database.view = {{{0.1, -7, 2}, 1, 2, 3}, 45};
  database.report.objects = 4;
  database.report.pairs = 0xffffffffffffull;
  database.report.seconds = 0.125;
  database.report.notices = {{"dropped faces", 2}};
  return database;
}

void expect_equal(const FaceSet& a, const FaceSet& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.corners, b.corners);
  ASSERT_EQ(a.cut_vertices.size(), b.cut_vertices.size());
  for (std::size_t i = 0; i < a.cut_vertices.size(); ++i) {
    EXPECT_EQ(a.cut_vertices[i].vertex, b.cut_vertices[i].vertex);
    EXPECT_TRUE(a.cut_vertices[i].position == b.cut_vertices[i].position);
  }
  ASSERT_EQ(a.planes.size(), b.planes.size());
  for (std::size_t i = 0; i < a.planes.size(); ++i) {
    EXPECT_EQ(a.planes[i].exact, b.planes[i].exact);
    EXPECT_EQ(a.planes[i].normal, b.planes[i].normal);
    EXPECT_EQ(a.planes[i].error, b.planes[i].error);
  }
  ASSERT_EQ(a.faces.size(), b.faces.size());
  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    EXPECT_EQ(a.faces[i].object, b.faces[i].object);
    EXPECT_EQ(a.faces[i].colour, b.faces[i].colour);
    EXPECT_EQ(a.faces[i].two_sided, b.faces[i].two_sided);
  }
  ASSERT_EQ(a.items.size(), b.items.size());
}

TEST_F(DatabaseFile, ComesBackExactlyFromJsonAndCbor) {
  const Database database = small_database();
  for (const char* name : {"a.json", "a.cbor"}) {
    SCOPED_TRACE(name);
    const std::filesystem::path file = folder_ / name,
                                again = folder_ / ("again-" + file.filename().string());
    write_database(database, file);
    EXPECT_TRUE(is_database(file));
    const Database back = read_database(file);
    write_database(back, again);
    EXPECT_EQ(bytes_of(file), bytes_of(again));
    ASSERT_EQ(back.systems.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      expect_equal(back.systems[i].set, database.systems[i].set);
      EXPECT_EQ(back.systems[i].motion, database.systems[i].motion);
    }
    expect_equal(back.ground, database.ground);
    EXPECT_TRUE(std::signbit(back.systems[0].set.vertices[0].y)) << "-0 stays -0";
    EXPECT_EQ(back.object_names, database.object_names);
    EXPECT_EQ(back.view, database.view);
    EXPECT_EQ(back.report.notices, database.report.notices);
    EXPECT_EQ(back.report.pairs, database.report.pairs);
  }
}

TEST_F(DatabaseFile, SixtyFourMembersKeepAllBitsOfTheirMasks) {
  Database database = small_database();
  PreparedSystem& world = database.systems[0];
  while (world.set.items.size() < 64) add_triangle(world.set, 1, {0, 0, 9}, {1, 0, 9}, {0, 1, 9});
  PriorityHierarchy& h = world.hierarchy;
  h = {};
  h.planes = {axis_plane(2, 0)};
  h.groups = {{0, 64, 0, 63}};
  for (std::uint32_t i = 0; i < 64; ++i) h.members.push_back({false, i, {}});
  for (std::int32_t i = 0; i < 63; ++i)
    h.nodes.push_back(
        {0, ~i, i == 62 ? ~63 : i + 1, std::uint64_t{1} << i, ~std::uint64_t{0} << (i + 1)});
  for (const char* name : {"a.json", "a.cbor"}) {
    write_database(database, folder_ / name);
    const Database back = read_database(folder_ / name);
    EXPECT_EQ(back.systems[0].hierarchy.nodes[0].false_members, ~std::uint64_t{1});
    EXPECT_EQ(back.systems[0].hierarchy.nodes[62].false_members, std::uint64_t{1} << 63);
  }
}

// Four items in one group with the pairs of two planes.
Database table_database() {
  Database database = small_database();
  database.systems.pop_back();
  PreparedSystem& world = database.systems[0];
  add_triangle(world.set, 1, {0, 0, 9}, {1, 0, 9}, {0, 1, 9});
  PriorityHierarchy& h = world.hierarchy;
  h.nodes = {{1, 0, 0, 0b0101, 0b1000, 0, 2}, {0, 0, 0, 0b0001, 0b0010, 2, 1}};
  h.pairs = {{0, 3}, {2, 3}, {0, 1}};
  h.members.clear();
  for (std::uint32_t i = 0; i < 4; ++i) h.members.push_back({false, i, {{0, 0, 0}, 1}});
  h.groups = {{0, 4, 0, 2}};
  return database;
}

TEST_F(DatabaseFile, TablesMadeByHandComeBackExactly) {
  const PriorityHierarchy want = table_database().systems[0].hierarchy;
  for (const char* name : {"a.json", "a.cbor"}) {
    write_database(table_database(), folder_ / name);
    const PriorityHierarchy h = read_database(folder_ / name).systems[0].hierarchy;
    ASSERT_EQ(h.nodes.size(), 2u);
    for (std::size_t n = 0; n < 2; ++n) {
      EXPECT_EQ(h.nodes[n].first_pair, want.nodes[n].first_pair);
      EXPECT_EQ(h.nodes[n].pair_count, want.nodes[n].pair_count);
      EXPECT_EQ(h.nodes[n].true_members, want.nodes[n].true_members);
    }
    ASSERT_EQ(h.pairs.size(), 3u);
    for (std::size_t p = 0; p < 3; ++p) {
      EXPECT_EQ(h.pairs[p].true_member, want.pairs[p].true_member);
      EXPECT_EQ(h.pairs[p].false_member, want.pairs[p].false_member);
    }
  }
}

TEST_F(DatabaseFile, EveryDamageOfATableMadeByHandIsRefused) {
  write_database(table_database(), folder_ / "good.json");
  const Json good = Json::parse(bytes_of(folder_ / "good.json"));
  const auto tree = [](Json& j) -> Json& { return j["systems"][0]["hierarchy"]; };
  const std::vector<std::pair<const char*, std::function<void(Json&)>>> damages{
      {"pairs left out", [&](Json& j) { tree(j).erase("pairs"); }},
      {"no pairs", [&](Json& j) { tree(j)["pairs"].clear(); }},
      {"pair cut short", [&](Json& j) { tree(j)["pairs"].erase(0); }},
      {"pair of no node", [&](Json& j) { tree(j)["pairs"][6] = 2; }},
      {"nodes not ascending", [&](Json& j) { tree(j)["pairs"][0] = 1; }},
      {"member out of range", [&](Json& j) { tree(j)["pairs"][1] = 4; }},
      {"member beyond 8 bits", [&](Json& j) { tree(j)["pairs"][1] = 256; }},
      {"pair of one member", [&](Json& j) { tree(j)["pairs"][1] = 3; }},
      {"pair turned round", [&](Json& j) { std::swap(tree(j)["pairs"][7], tree(j)["pairs"][8]); }},
      {"pair twice", [&](Json& j) { tree(j)["pairs"][4] = 0; }},
      {"wrong mask", [&](Json& j) { tree(j)["nodes"][3] = 1; }},
      {"wrong false mask", [&](Json& j) { tree(j)["nodes"][4] = 0b1010; }},
      {"node without a plane", [&](Json& j) { tree(j)["nodes"][0] = 2; }},
      {"a node less", [&](Json& j) { tree(j)["groups"][3] = 1; }},
      {"a member less", [&](Json& j) { tree(j)["groups"][1] = 3; }},
      {"a moving system", [](Json& j) { j["systems"].push_back(j["systems"][0]); }}};
  for (const auto& [what, damage] : damages) {
    Json bad = good;
    damage(bad);
    ASSERT_NE(bad, good) << what;
    EXPECT_THROW(read_database(put("bad.json", bad.dump())), InputError) << what;
  }
}

TEST_F(DatabaseFile, ScenesAndOtherFilesAreNoDatabases) {
  EXPECT_FALSE(is_database(folder_ / "absent.json"));
  EXPECT_FALSE(is_database(put("scene.json", R"({"cigsim": 1, "name": "cigsim-database"})")));
  EXPECT_FALSE(is_database(put("nested.json", R"({"a": {"cigsim-database": 1}})")));
  EXPECT_FALSE(is_database(put("broken.json", "{\"a\": [")));
  EXPECT_FALSE(is_database(put("box.obj", "v 0 0 0\n")));
  EXPECT_TRUE(is_database(put("late.json", R"({"a": {"b": 1}, "cigsim-database": 1})")));
}

TEST_F(DatabaseFile, DeepNestingIsRefused) {
  for (const char* name : {"deep.cbor", "deep.json"}) {
    const auto file = put(name, std::string(200000, name[5] == 'c' ? '\x81' : '['));
    EXPECT_FALSE(is_database(file));
    EXPECT_THROW(read_database(file), InputError);
  }
}

TEST_F(DatabaseFile, EndingMustBeKnown) {
  EXPECT_THROW(write_database(small_database(), folder_ / "a.obj"), InputError);
  EXPECT_THROW(read_database(put("a.txt", "{}")), InputError);
  EXPECT_THROW(read_database(folder_ / "absent.json"), InputError);
}

TEST_F(DatabaseFile, EveryDamagedFieldIsRefused) {
  write_database(small_database(), folder_ / "good.json");
  const Json good = Json::parse(bytes_of(folder_ / "good.json"));
  const auto set = [](Json& j) -> Json& { return j["systems"][0]["set"]; };
  const auto tree = [](Json& j) -> Json& { return j["systems"][0]["hierarchy"]; };
  const std::vector<std::pair<const char*, std::function<void(Json&)>>> damages{
      {"no tag", [](Json& j) { j.erase("cigsim-database"); }},
      {"another version", [](Json& j) { j["cigsim-database"] = 2; }},
      {"no systems", [](Json& j) { j["systems"].clear(); }},
      {"systems missing", [](Json& j) { j.erase("systems"); }},
      {"systems not a list", [](Json& j) { j["systems"] = 3; }},
      {"name not a string", [](Json& j) { j["name"] = 3; }},
      {"too few names", [](Json& j) { j["object_names"] = {"one"}; }},
      {"background too large", [](Json& j) { j["background"] = 0x1000000; }},
      {"fov of 180", [](Json& j) { j["view"]["fov"] = 180; }},
      {"eye of two",
       [](Json& j) {
         j["view"]["eye"] = {1, 2};
       }},
      {"eye of null", [](Json& j) { j["view"]["eye"][1] = nullptr; }},
      {"coordinate missing", [&](Json& j) { set(j)["vertices"].erase(0); }},
      {"coordinate a string", [&](Json& j) { set(j)["vertices"][0] = "1"; }},
      {"cut vertex out of range", [&](Json& j) { set(j)["cut_vertices"][0][0] = 9; }},
      {"cut vertex elsewhere", [&](Json& j) { set(j)["cut_vertices"][0][3] = "1/2"; }},
      {"fraction over zero", [&](Json& j) { set(j)["cut_vertices"][0][3] = "1/0"; }},
      {"fraction of words", [&](Json& j) { set(j)["cut_vertices"][0][3] = "one"; }},
      {"empty fraction", [&](Json& j) { set(j)["cut_vertices"][0][3] = ""; }},
      {"cut vertices not ascending",
       [&](Json& j) { set(j)["cut_vertices"].push_back(set(j)["cut_vertices"][0]); }},
      {"corner out of range", [&](Json& j) { set(j)["corners"][1] = 3; }},
      {"corner negative", [&](Json& j) { set(j)["corners"][1] = -1; }},
      {"corner a fraction", [&](Json& j) { set(j)["corners"][1] = 0.5; }},
      {"plane point out of range", [&](Json& j) { set(j)["planes"][0] = 1000; }},
      {"plane cut short", [&](Json& j) { set(j)["planes"].erase(0); }},
      {"face's first corner", [&](Json& j) { set(j)["faces"][0] = 0xffffffffu; }},
      {"face of two corners", [&](Json& j) { set(j)["faces"][1] = 2; }},
      {"face of too many corners", [&](Json& j) { set(j)["faces"][1] = 0xffffffffu; }},
      {"face without a plane", [&](Json& j) { set(j)["faces"][2] = 3; }},
      {"face of object 0", [&](Json& j) { set(j)["faces"][3] = 0; }},
      {"face of an absent object", [&](Json& j) { set(j)["faces"][3] = 5; }},
      {"colour too large", [&](Json& j) { set(j)["faces"][4] = 0x1000000; }},
      {"neither one- nor two-sided", [&](Json& j) { set(j)["faces"][5] = 2; }},
      {"item shares a face", [&](Json& j) { set(j)["items"][4] = 0; }},
      {"item's faces out of range", [&](Json& j) { set(j)["items"][1] = 99; }},
      {"item's vertices out of range", [&](Json& j) { set(j)["items"][2] = 99; }},
      {"face of no item", [&](Json& j) { set(j)["items"][1] = 0; }},
      {"item beyond 32 bits", [&](Json& j) { set(j)["items"][0] = 0x100000000; }},
      {"sphere missing", [&](Json& j) { set(j)["spheres"].erase(0); }},
      {"negative radius", [&](Json& j) { set(j)["spheres"][3] = -1; }},
      {"node without a plane", [&](Json& j) { tree(j)["nodes"][0] = 2; }},
      {"node its own child", [&](Json& j) { tree(j)["nodes"][1] = 0; }},
      {"child out of range", [&](Json& j) { tree(j)["nodes"][1] = 7; }},
      {"member out of range", [&](Json& j) { tree(j)["nodes"][1] = -3; }},
      {"smallest child", [&](Json& j) { tree(j)["nodes"][1] = -2147483648; }},
      {"member twice", [&](Json& j) { tree(j)["nodes"][1] = -2; }},
      {"wrong mask", [&](Json& j) { tree(j)["nodes"][3] = 3; }},
      {"wrong false mask", [&](Json& j) { tree(j)["nodes"][4] = 0; }},
      {"negative mask", [&](Json& j) { tree(j)["nodes"][4] = -1; }},
      {"group in itself", [&](Json& j) { tree(j)["members"][1] = 0; }},
      {"item twice", [&](Json& j) { tree(j)["members"][5] = 0; }},
      {"item absent", [&](Json& j) { tree(j)["members"][5] = 3; }},
      {"group that is an item", [&](Json& j) { tree(j)["members"][0] = 0; }},
      {"group of 65", [&](Json& j) { tree(j)["groups"][1] = 65; }},
      {"group of none", [&](Json& j) { tree(j)["groups"][5] = 0; }},
      {"group's members", [&](Json& j) { tree(j)["groups"][4] = 0xffffffffu; }},
      {"group's nodes", [&](Json& j) { tree(j)["groups"][6] = 2; }},
      {"node count", [&](Json& j) { tree(j)["groups"][3] = 2; }},
      {"no groups", [&](Json& j) { tree(j)["groups"].clear(); }},
      {"motion of equal frames",
       [](Json& j) { j["systems"][1]["motion"][1] = j["systems"][1]["motion"][0]; }},
      {"placement of five", [](Json& j) { j["systems"][0]["placement"].erase(0); }},
      {"ground in two items", [&](Json& j) { j["ground"] = set(j); }},
      {"notice without a count", [](Json& j) { j["report"]["notices"][0].erase(1); }},
      {"negative count", [](Json& j) { j["report"]["cuts"] = -1; }},
      {"a list", [](Json& j) { j = Json::array(); }}};
  for (const auto& [what, damage] : damages) {
    Json bad = good;
    damage(bad);
    ASSERT_NE(bad, good) << what;
    const std::vector<std::uint8_t> cbor = Json::to_cbor(bad);
    EXPECT_THROW(read_database(put("bad.json", bad.dump())), InputError) << what;
    EXPECT_THROW(read_database(put("bad.cbor", {cbor.begin(), cbor.end()})), InputError) << what;
  }
  Json infinite = good;
  infinite["view"]["eye"][0] = std::numeric_limits<double>::infinity();
  const std::vector<std::uint8_t> cbor = Json::to_cbor(infinite);
  EXPECT_THROW(read_database(put("bad.cbor", {cbor.begin(), cbor.end()})), InputError);
}

TEST_F(DatabaseFile, RandomDamageIsRefusedOrHarmless) {
  const std::uint64_t seed = 20260102;
  std::mt19937_64 random(seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  for (const char* name : {"fuzz.json", "fuzz.cbor"}) {
    const std::filesystem::path file = folder_ / name;
    write_database(small_database(), file);
    const std::string good = bytes_of(file);
    int refused = 0;
    for (int i = 0; i < 1000; ++i) {
      std::string bad = good;
      if (i % 4 == 0) bad.resize(random() % bad.size());
      for (std::uint64_t flips = i % 4 == 0 ? 0 : 1 + random() % 4; flips > 0; --flips)
        bad[random() % bad.size()] ^= static_cast<char>(1u << random() % 8);
      put(name, bad);
      try {
        is_database(file);
        read_database(file);
      } catch (const InputError&) {
        ++refused;
      }
    }
    EXPECT_GT(refused, 300) << name;
  }
}

}  // namespace
}  // namespace cigsim
