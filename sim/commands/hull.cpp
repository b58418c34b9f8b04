// SPDX-License-Identifier: MIT
// cigsim hull: the convex hull of points, by the fast algorithm or by Levine's of 1975.
#include "models/database/hull/hull.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "models/environment/input_error.hpp"
#include "models/environment/off_writer.hpp"
#include "models/environment/text_file.hpp"
#include "models/environment/write.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/point_groups.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string file;
  std::optional<std::string> output;
  bool levine = false, per_object = false, merge = false, json = false;
};

struct Result {
  PointGroup group;
  Hull hull;
  std::vector<std::vector<std::uint32_t>> facets;
};

const char* name_of_dimension(int dimension) {
  constexpr const char* kNames[] = {"a point", "a line", "a polygon", "a solid"};
  return kNames[dimension];
}

Result hull_of(PointGroup group, bool levine) {
  Hull hull = levine ? levine_hull(group.points) : convex_hull(group.points);
  auto facets = hull_facets(group.points, hull);
  return {std::move(group), std::move(hull), std::move(facets)};
}

// The faces to write: facets where they are asked for, and of a polygon; else triangles.
std::vector<std::vector<std::uint32_t>> faces_of(const Result& result, bool merge) {
  if (merge || result.hull.dimension < 3) return result.facets;
  std::vector<std::vector<std::uint32_t>> faces;
  for (const HullTriangle& t : result.hull.triangles) faces.emplace_back(t.begin(), t.end());
  return faces;
}

Object object_of(const Result& result, bool merge) {
  Object object{result.group.name, 0, {}, {}};
  std::vector<std::uint32_t> number(result.group.points.size());
  for (const std::uint32_t v : result.hull.vertices) {
    number[v] = static_cast<std::uint32_t>(object.vertices.size());
    object.vertices.push_back(result.group.points[v]);
  }
  for (std::vector<std::uint32_t>& face : faces_of(result, merge)) {
    for (std::uint32_t& v : face) v = number[v];
    object.faces.push_back({std::move(face), {}});
  }
  return object;
}

Environment scene_of(const std::vector<Result>& results, const Options& options) {
  Environment scene;
  scene.name = "hull of " + options.file;
  scene.models.push_back({"hull", 0});
  for (const Result& result : results) {
    if (result.hull.dimension < 2)
      throw InputError(options.file, 0,
                       fmt::format("the points of {} have {} for a hull, which has no face to "
                                   "write; leave out -o or these points",
                                   result.group.name, name_of_dimension(result.hull.dimension)));
    scene.objects.push_back(object_of(result, options.merge));
  }
  return scene;
}

void write(const std::vector<Result>& results, const Options& options) {
  const Environment scene = scene_of(results, options);
  if (lower_ending(*options.output) == "off")
    write_file(*options.output, [&](std::ostream& out) { write_off(scene, out); });
  else
    write_environment(scene, *options.output);
}

void print_json(const std::vector<Result>& results, const Options& options) {
  Json list = Json::array();
  for (const Result& r : results) {
    Json figures{
        {"name", r.group.name},
        {"points", r.group.points.size()},
        {"dimension", r.hull.dimension},
        {"hull_points", r.hull.vertices.size()},
        {"triangles", r.hull.triangles.size()},
        {"facets", r.facets.size()},
        {"tests", r.hull.counters.tests},
        {"equivalent_tests", equivalent_tests(r.group.points.size(), r.hull.triangles.size())},
        {"points_added", r.hull.counters.added},
        {"exact_decisions", r.hull.counters.exact}};
    if (options.levine) figures["rounds"] = r.hull.counters.rounds;
    list.push_back(std::move(figures));
  }
  Json all{{"file", options.file}, {"method", options.levine ? "levine" : "quickhull"}};
  if (options.output) all["output"] = *options.output;
  all["hulls"] = std::move(list);
  fmt::print("{}\n", dump(all));
}

void print_row(const char* name, std::uint64_t value, const char* meaning) {
  fmt::print("  {:<20}{:>14}  {}\n", name, value, meaning);
}

void print_table(const Result& r, bool levine) {
  const HullCounters& c = r.hull.counters;
  fmt::print("{}: the hull is {}\n", r.group.name, name_of_dimension(r.hull.dimension));
  print_row("points", r.group.points.size(), "NPTS");
  print_row("hull points", r.hull.vertices.size(), "NPTH, extreme points");
  if (r.hull.dimension < 3) return;
  print_row("triangles", r.hull.triangles.size(), "NPH = 2 NPTH - 4");
  print_row("facets", r.facets.size(), "coplanar triangles merged");
  print_row("tests", c.tests, "NT, signed distances from planes");
  print_row("equivalent tests", equivalent_tests(r.group.points.size(), r.hull.triangles.size()),
            "NEQ = 3 NPTS NPH, of Chand and Kapur");
  if (levine) print_row("rounds", c.rounds, "of tests of all points left");
  print_row("exact decisions", c.exact, "sides that doubles left in doubt");
}

int run(const Options& options) {
  if (options.output) check_ending("-o", *options.output, {"off", "obj", "json", "cbor"});
  std::vector<Result> results;
  for (PointGroup& group : read_point_groups(options.file, options.per_object))
    results.push_back(hull_of(std::move(group), options.levine));
  if (options.output) write(results, options);
  if (options.json) {
    print_json(results, options);
    return 0;
  }
  for (const Result& result : results) print_table(result, options.levine);
  if (options.output) fmt::print("{} written\n", *options.output);
  return 0;
}

}  // namespace

void add_hull(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("hull", "Find the convex hull of points, exactly");
  command->footer(
      "Examples:\n"
      "  cigsim hull points.xyz -o hull.obj      the hull as a scene that `cigsim run` takes\n"
      "  cigsim hull city.json --per-object      one hull for each object\n"
      "  cigsim hull points.csv --levine         Levine's algorithm of 1975, with his counts\n");
  add_points_option(*command, options->file);
  command
      ->add_option("-o,--output", options->output,
                   "Write the hull; the ending chooses OFF, OBJ, JSON or CBOR")
      ->type_name("FILE");
  command->add_flag("--merge", options->merge,
                    "Write facets of any number of corners instead of triangles");
  command->add_flag("--levine", options->levine,
                    "Levine's algorithm of 1975; time points times triangles");
  command->add_flag("--per-object", options->per_object, "One hull for each object");
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace cigsim
