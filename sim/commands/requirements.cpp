// SPDX-License-Identifier: MIT
// cigsim requirements: what a scene asks of the machine (design section 5).
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "models/database/hierarchy.hpp"
#include "sim/commands/commands.hpp"
#include "sim/functional_machine.hpp"
#include "sim/progress.hpp"
#include "sim/scene.hpp"
#include "sim/stats.hpp"
#include "sim/view.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::optional<std::string> scene;
  ViewOptions view;
  PreparationChoices preparation;
  bool json = false;
};

struct Figure {
  const char* name;
  std::uint64_t value;
  const char* meaning;
};

struct Attribute {
  const char* name;
  bool used;
  std::string consequence;
};

struct DatabaseFigures {
  std::uint64_t items = 0, faces = 0, edges = 0, two_sided = 0, moving = 0, planes = 0, groups = 0,
                pairs = 0, largest_group = 0, largest_planes = 0, choices = 0;
};

void add_set(const FaceSet& set, DatabaseFigures& figures) {
  figures.items += set.items.size();
  figures.faces += set.faces.size();
  for (const PreparedFace& face : set.faces) {
    figures.edges += face.corner_count;
    figures.two_sided += face.two_sided ? 1 : 0;
  }
}

DatabaseFigures figures_of(const Database& database) {
  DatabaseFigures figures;
  for (const PreparedSystem& system : database.systems) {
    add_set(system.set, figures);
    figures.moving += system.motion.empty() ? 0 : 1;
    figures.planes += system.hierarchy.planes.size();
    figures.groups += system.hierarchy.groups.size();
    figures.pairs += pair_count(system.hierarchy);
    figures.choices += system.hierarchy.choices.size();
    for (const Group& group : system.hierarchy.groups) {
      figures.largest_group = std::max<std::uint64_t>(figures.largest_group, group.member_count);
      figures.largest_planes = std::max<std::uint64_t>(figures.largest_planes, group.node_count);
    }
  }
  return figures;
}

// The largest of each count over the frames.
FrameStats worst_frame(const Database& database, const std::vector<FrameView>& views,
                       const Raster& raster) {
  MachineOptions options;
  options.raster = raster;
  FunctionalMachine machine(database, options);
  Progress progress("measuring");
  FrameStats worst;
  for (std::size_t i = 0; i < views.size(); ++i) {
    machine.compute(views[i].viewpoint, views[i].position);
    const FrameStats& stats = machine.stats();
    for (const auto count :
         {&FrameStats::active_items, &FrameStats::faces, &FrameStats::edges, &FrameStats::crossings,
          &FrameStats::worst_line_crossings, &FrameStats::spans})
      worst.*count = std::max(worst.*count, stats.*count);
    progress.show(static_cast<double>(i + 1) / static_cast<double>(views.size()));
  }
  return worst;
}

std::vector<Figure> scene_rows(const LoadedScene& scene, const DatabaseFigures& figures) {
  const Database& database = scene.database;
  std::vector<Figure> rows{{"objects", database.object_count, ""}};
  if (scene.facts) rows.push_back({"models", scene.facts->models, ""});
  const std::vector<Figure> rest{
      {"coordinate_systems", database.systems.size(), "the environment's own included"},
      {"items", figures.items, "entries of the priority lists"},
      {"faces", figures.faces, "of objects, after the cuts of preparation"},
      {"edges", figures.edges, "of these faces"},
      {"ground_faces", database.ground.faces.size(), ""},
      {"planes", figures.planes, "separation planes"},
      {"groups", figures.groups, "of the priority hierarchy"},
      {"pairs", figures.pairs, "TRUE/FALSE pairs over all groups"},
      {"largest_group_members", figures.largest_group, "rows of counters or of the SO matrix"},
      {"largest_group_planes", figures.largest_planes, "side tests of a group"},
      {"choices", figures.choices, "things with several descriptions"}};
  rows.insert(rows.end(), rest.begin(), rest.end());
  return rows;
}

std::vector<Figure> view_rows(const FrameStats& worst, std::size_t frames) {
  return {{"frames", frames, "measured; the largest of each count follows"},
          {"active_items", worst.active_items, "in view"},
          {"front_faces", worst.faces, "on the raster"},
          {"frame_edges", worst.edges, "on the raster"},
          {"crossings", worst.crossings, "of edges and lines"},
          {"worst_line_crossings", worst.worst_line_crossings, "on one line"},
          {"spans", worst.spans, "visible"}};
}

std::vector<Attribute> attributes_of(const LoadedScene& scene, const DatabaseFigures& figures) {
  const std::size_t ground = scene.database.ground.faces.size();
  const auto choose = [](bool used, std::string then, std::string otherwise) {
    return used ? std::move(then) : std::move(otherwise);
  };
  std::vector<Attribute> rows{
      {"moving models", figures.moving > 0,
       choose(figures.moving > 0,
              fmt::format("{} systems are placed and ordered in each frame", figures.moving),
              "left out: priorities come from the static planes alone")},
      {"ground", ground > 0,
       choose(ground > 0, fmt::format("{} faces below every object", ground), "left out")},
      {"levels of detail", figures.choices > 0,
       choose(figures.choices > 0,
              fmt::format("{} projected radii decide what is retrieved", figures.choices),
              "left out: every object has one description")},
      {"two-sided faces", figures.two_sided > 0,
       choose(figures.two_sided > 0,
              fmt::format("{} faces show their backs too", figures.two_sided),
              "left out: a face turned away is dropped")}};
  if (scene.facts)
    rows.push_back({"sun shading", scene.facts->sun,
                    choose(scene.facts->sun, "fixed in the colours at preparation; no stage shades",
                           "left out: stated colours are shown as they are")});
  for (const char* name : {"fading", "smooth shading", "lights", "edge smoothing"})
    rows.push_back({name, false, "left out: no scene format has it"});
  return rows;
}

void print_json(const LoadedScene& scene, const Raster& raster, const std::vector<Figure>& database,
                const std::vector<Figure>& view, const std::vector<Attribute>& attributes) {
  const auto object = [](const std::vector<Figure>& rows) {
    Json out = Json::object();
    for (const Figure& row : rows) out[row.name] = row.value;
    return out;
  };
  Json list = Json::array();
  for (const Attribute& a : attributes)
    list.push_back({{"name", a.name}, {"used", a.used}, {"consequence", a.consequence}});
  const Json figures{{"scene", scene.name},
                     {"database", object(database)},
                     {"raster", {raster.width, raster.height}},
                     {"view", object(view)},
                     {"attributes", std::move(list)}};
  fmt::print("{}\n", dump(figures));
}

void print_table(const LoadedScene& scene, const Raster& raster,
                 const std::vector<Figure>& database, const std::vector<Figure>& view,
                 const std::vector<Attribute>& attributes) {
  const auto print = [](const std::vector<Figure>& rows) {
    for (const Figure& row : rows)
      fmt::print("  {:<24}{:>12}{}{}\n", row.name, row.value, *row.meaning == '\0' ? "" : "  ",
                 row.meaning);
  };
  fmt::print("The scene ({})\n", scene.name);
  print(database);
  fmt::print("The view at {} x {}\n", raster.width, raster.height);
  print(view);
  fmt::print("What is used\n");
  for (const Attribute& a : attributes)
    fmt::print("  {:<24}{:>12}  {}\n", a.name, a.used ? "yes" : "no", a.consequence);
}

int requirements(const Options& options) {
  const std::vector<PathRow> path = load_path(options.view);
  const LoadedScene scene = load_scene(options.scene, options.preparation);
  const std::vector<FrameView> views = frame_views(options.view, path, scene.database);
  const Raster raster = options.view.raster.value_or(Raster());
  const DatabaseFigures figures = figures_of(scene.database);
  const FrameStats worst = worst_frame(scene.database, views, raster);
  const auto print = options.json ? print_json : print_table;
  print(scene, raster, scene_rows(scene, figures), view_rows(worst, views.size()),
        attributes_of(scene, figures));
  return 0;
}

}  // namespace

void add_requirements(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("requirements", "Tell what a scene asks of the machine");
  command->footer(
      "Examples:\n"
      "  cigsim requirements                             the built-in airfield\n"
      "  cigsim requirements city.json --path fly.csv    the worst over a path\n");
  add_scene_option(*command, options->scene);
  add_view_options(*command, options->view);
  add_preparation_options(*command, options->preparation);
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command->callback([options, &exit_code] { exit_code = requirements(*options); });
}

}  // namespace cigsim
