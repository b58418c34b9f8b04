// SPDX-License-Identifier: MIT
// cigsim sphere: the smallest sphere round points, by the fast method or by Levine's of 1975.
#include "models/database/sphere/sphere.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "models/environment/input_error.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/point_groups.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

enum class Method { kWelzl, kLevine };

// Levine's step 2 looks at each pair of hull points.
constexpr std::size_t kMostLevineHullPoints = 100000;

struct Options {
  std::string file;
  Method method = Method::kWelzl;
  LevineSphereOptions levine;
  bool per_object = false, json = false;
};

struct Result {
  PointGroup group;
  std::optional<BoundingSphere> sphere;
  std::optional<LevineSphere> levine;
};

LevineSphere search(const PointGroup& group, const Options& options) {
  const Hull hull = convex_hull(group.points);
  if (hull.vertices.size() > kMostLevineHullPoints)
    throw InputError(options.file, 0,
                     fmt::format("{} has {} points on its hull, and Levine's method looks at each "
                                 "pair of them; use --method welzl",
                                 group.name, hull.vertices.size()));
  return levine_sphere(group.points, hull, options.levine);
}

Result sphere_of(PointGroup group, const Options& options) {
  Result result{std::move(group), {}, {}};
  try {
    if (options.method == Method::kLevine) {
      result.levine = search(result.group, options);
      result.sphere = result.levine->sphere;
    } else {
      result.sphere = minimum_sphere(result.group.points);
    }
  } catch (const std::invalid_argument& error) {
    throw InputError(options.file, 0, std::string(error.what()) + "; scale the points");
  }
  return result;
}

Json vector_json(const Vec3& v) { return Json{v.x, v.y, v.z}; }

Json figures_of(const LevineSphere& levine) {
  return Json{
      {"hull_points", levine.hull_points},           {"tests", levine.tests},
      {"spheres_created", levine.spheres_created},   {"spheres_tested", levine.spheres_tested},
      {"spheres_expected", levine.spheres_expected}, {"selected", levine.selected}};
}

void print_json(const std::vector<Result>& results, const Options& options) {
  Json list = Json::array();
  for (const Result& r : results) {
    Json figures{
        {"name", r.group.name}, {"points", r.group.points.size()}, {"found", r.sphere.has_value()}};
    if (r.sphere) {
      figures["centre"] = vector_json(r.sphere->centre);
      figures["radius"] = r.sphere->radius;
      figures["support"] = r.sphere->support;
    }
    if (r.levine) figures["levine"] = figures_of(*r.levine);
    list.push_back(std::move(figures));
  }
  fmt::print("{}\n", dump(Json{{"file", options.file},
                               {"method", options.method == Method::kLevine ? "levine" : "welzl"},
                               {"spheres", std::move(list)}}));
}

template <class Value>
void print_row(const char* name, const Value& value, const char* meaning) {
  fmt::print("  {:<20}{:>14}  {}\n", name, value, meaning);
}

void print_sphere(const Result& r) {
  const BoundingSphere& s = *r.sphere;
  fmt::print("{}: {} points\n", r.group.name, r.group.points.size());
  fmt::print("  {:<20}{} {} {}\n", "centre", s.centre.x, s.centre.y, s.centre.z);
  fmt::print("  {:<20}{}\n", "radius", s.radius);
  for (const std::uint32_t i : s.support) {
    const Vec3& p = r.group.points[i];
    fmt::print("  {:<20}{} {} {}  (point {})\n", "rests on", p.x, p.y, p.z, i + 1);
  }
}

void print_counts(const LevineSphere& levine) {
  print_row("hull points", levine.hull_points, "NPTH");
  print_row("tests", levine.tests, "NT, points put into a sphere's equation");
  print_row("spheres created", levine.spheres_created, "NSC");
  print_row("spheres tested", levine.spheres_tested, "NST, centre among their points");
  print_row("spheres expected", fmt::format("{:.6g}", levine.spheres_expected),
            "ESC, of a search in no order");
  if (levine.selected.empty()) return;
  print_row("selected points", fmt::format("{}", fmt::join(levine.selected, " ")),
            "SP, places in the order of solid angles");
  print_row("type", levine.selected.size(), "TSC, points that the sphere rests on");
}

void print_none(const Result& r, const Options& options) {
  const std::size_t last = options.levine.last_point.value_or(r.levine->hull_points);
  const bool all = last >= r.levine->hull_points;
  fmt::print("{}: {} points, NO sphere found by point {}{}\n", r.group.name, r.group.points.size(),
             all ? r.levine->hull_points : last,
             all ? ", the last: leave out --published-loops" : "; --last-point all searches on");
}

void print_text(const Result& r, const Options& options) {
  if (r.sphere)
    print_sphere(r);
  else
    print_none(r, options);
  if (r.levine) print_counts(*r.levine);
}

int run(const Options& options) {
  std::vector<Result> results;
  for (PointGroup& group : read_point_groups(options.file, options.per_object))
    results.push_back(sphere_of(std::move(group), options));
  if (options.json)
    print_json(results, options);
  else
    for (const Result& result : results) print_text(result, options);
  for (const Result& result : results)
    if (!result.sphere) return 1;
  return 0;
}

void add_levine_options(CLI::App& command, Options& options) {
  command
      .add_option_function<std::string>(
          "--last-point",
          [&options](const std::string& text) {
            options.levine.last_point.reset();
            if (text != "all")
              options.levine.last_point =
                  parse_whole("--last-point", text, 2, std::numeric_limits<std::uint32_t>::max());
          },
          "Of levine: give up after this point in the order of solid angles; `all`: never. "
          "Default: 26, as published")
      ->type_name("N|all");
  command.add_flag("--published-loops", options.levine.published_loops,
                   "Of levine: the loops to the letter, which try no triple with the last point");
}

}  // namespace

void add_sphere(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("sphere", "Find the smallest sphere round points, exactly");
  command->footer(
      "Exit code 1: a search of Levine's gave up.\n"
      "\nExamples:\n"
      "  cigsim sphere points.xyz                     centre, radius, and what it rests on\n"
      "  cigsim sphere city.json --per-object --json  one sphere for each object\n"
      "  cigsim sphere points.csv --method levine     Levine's search of 1975, with his counts\n");
  add_points_option(*command, options->file);
  command
      ->add_option_function<std::string>(
          "--method",
          [options](const std::string& text) {
            options->method = parse_choice<Method>(
                "--method", text, {{"welzl", Method::kWelzl}, {"levine", Method::kLevine}});
          },
          "welzl (pivots, fast) or levine (1975). Default: welzl")
      ->type_name("METHOD");
  add_levine_options(*command, *options);
  command->add_flag("--per-object", options->per_object, "One sphere for each object");
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace cigsim
