// SPDX-License-Identifier: MIT
// cigsim clip: what clipping by clusters, edges and polygons (Sandor 1979, sec. 4) has to do for a
// view of a scene.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "models/survey/clipping/scene_clip.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/scene.hpp"
#include "sim/stats.hpp"
#include "sim/view.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
using survey::ClipCounts;

constexpr double kNearest = 1e-6, kFarthest = 1e9;

struct Options {
  std::optional<std::string> scene;
  ViewOptions view;
  PreparationChoices preparation;
  double view_plane = 1;
  bool json = false;
};

Json json_of(const ClipCounts::Clusters& c) {
  return {{"tested", c.tested},
          {"outside", c.outside},
          {"too_small", c.too_small},
          {"inside", c.inside},
          {"cut", c.cut}};
}
Json json_of(const ClipCounts::Parts& p) {
  return {{"tested", p.tested}, {"outside", p.outside}, {"inside", p.inside}, {"cut", p.cut}};
}

void print_json(const std::string& scene, const Raster& raster, const Options& options,
                const ClipCounts& c) {
  const Json figures{{"scene", scene},
                     {"raster", {raster.width, raster.height}},
                     {"view_plane", options.view_plane},
                     {"groups", json_of(c.groups)},
                     {"items", json_of(c.items)},
                     {"items_inside_groups", c.items_inside_groups},
                     {"items_dropped_with_groups", c.items_dropped_with_groups},
                     {"back_faces", c.back_faces},
                     {"edges", json_of(c.edges)},
                     {"polygons", json_of(c.polygons)},
                     {"polygon_vertices_tested", c.work.vertices},
                     {"polygon_meetings", c.work.meetings}};
  fmt::print("{}\n", dump(figures));
}

void print_table(const std::string& scene, const Raster& raster, const Options& options,
                 const ClipCounts& c) {
  fmt::print("Clipping ({}): {} x {} elements, view plane at {}\n", scene, raster.width,
             raster.height, options.view_plane);
  fmt::print("{:<22}{:>9}{:>9}{:>11}{:>9}{:>9}\n", "", "tested", "outside", "too small", "inside",
             "cut");
  const auto clusters = [](const char* name, const ClipCounts::Clusters& row) {
    fmt::print("{:<22}{:>9}{:>9}{:>11}{:>9}{:>9}\n", name, row.tested, row.outside, row.too_small,
               row.inside, row.cut);
  };
  const auto parts = [](const char* name, const ClipCounts::Parts& row) {
    fmt::print("{:<22}{:>9}{:>9}{:>11}{:>9}{:>9}\n", name, row.tested, row.outside, "", row.inside,
               row.cut);
  };
  clusters("groups of clusters", c.groups);
  clusters("clusters", c.items);
  parts("edges of cut ones", c.edges);
  parts("polygons of cut ones", c.polygons);
  fmt::print(
      "{} clusters were accepted and {} dropped with their groups. {} faces of cut clusters look\n"
      "away. Polygons: {} vertices tested, {} meetings with planes computed.\n",
      c.items_inside_groups, c.items_dropped_with_groups, c.back_faces, c.work.vertices,
      c.work.meetings);
}

int clip(const Options& options) {
  const std::vector<PathRow> path = load_path(options.view);
  const LoadedScene scene = load_scene(options.scene, options.preparation);
  const std::vector<FrameView> views = frame_views(options.view, path, scene.database);
  const Raster raster = options.view.raster.value_or(Raster());
  const ClipCounts counts = survey::clip_scene(scene.database, views.front().viewpoint, raster,
                                               views.front().position, options.view_plane);
  (options.json ? print_json : print_table)(scene.name, raster, options, counts);
  return 0;
}

}  // namespace

void add_clip(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("clip", "Count what clipping has to do for a view of a scene");
  command->footer(
      "Clusters are clipped by their spheres; those that are cut, edge by edge and polygon by\n"
      "polygon (Sutherland and Hodgman). The first frame of a path is measured.\n"
      "\nExamples:\n"
      "  cigsim clip                               the built-in airfield\n"
      "  cigsim clip city.json --view-plane 0.5    with the view plane half a unit ahead\n");
  add_scene_option(*command, options->scene);
  add_view_options(*command, options->view);
  add_preparation_options(*command, options->preparation);
  command
      ->add_option_function<std::string>(
          "--view-plane",
          [options](const std::string& text) {
            options->view_plane = parse_number("--view-plane", text, kNearest, kFarthest);
          },
          "Distance of the view plane from the eye, in the scene's units; nothing before it is "
          "seen. Default: 1")
      ->type_name("D");
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command->callback([options, &exit_code] { exit_code = clip(*options); });
}

}  // namespace cigsim
