// SPDX-License-Identifier: MIT
// cigsim hidden-line: a scene as a line drawing, by Levine's algorithm of 1975.
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "models/database/database_file.hpp"
#include "models/environment/input_error.hpp"
#include "models/environment/write.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/hidden_line/scene_parts.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/embedded.hpp"
#include "sim/experiments/hidden_line_experiment.hpp"
#include "sim/hidden_line_picture.hpp"
#include "sim/host_time.hpp"
#include "sim/scene.hpp"
#include "sim/stats.hpp"
#include "sim/view.hpp"

namespace cigsim {
namespace {

using hidden_line::Counters;
using hidden_line::HiddenLines;
using hidden_line::PartKind;
using Json = nlohmann::ordered_json;

struct Options {
  std::optional<std::string> scene;
  std::string output;
  ViewOptions view;
  bool hidden = false, json = false;
  std::vector<std::uint32_t> wires;
};

// Beside Levine's.
constexpr NamedCounter kOwnCounters[] = {{"decided_by_shadow", "", &Counters::decided_by_shadow},
                                         {"exact_decisions", "", &Counters::exact}};

template <class Visit>
void for_each_counter(Visit visit) {
  for (const NamedCounter& c : kHiddenLineCounters) visit(c);
  for (const NamedCounter& c : kOwnCounters) visit(c);
}

struct Scene {
  std::string name;
  ReadResult read;
  Database database;
};

Scene load(const std::optional<std::string>& file) {
  Scene scene;
  if (!file) {
    scene.name = "built-in airfield";
    scene.read = parse_json(embedded_text(embedded_scenes(), "airfield.json"), scene.name);
  } else {
    scene.name = *file;
    if (is_database(*file))
      throw InputError(*file, 0,
                       "is a prepared database, whose faces are cut; give the scene it was "
                       "prepared from");
    scene.read = read_environment(*file);
  }
  scene.database = prepare_scene(scene.read, scene.name, {});
  return scene;
}

bool moves(const Environment& environment) {
  for (const CoordinateSystem& system : environment.systems)
    if (!system.motion.empty()) return true;
  return false;
}

// Of every system of the environment at a frame.
std::vector<Placement> placements_at(const Scene& scene, double frame) {
  std::vector<Placement> out;
  std::size_t moving = 0;
  for (const CoordinateSystem& system : scene.read.environment.systems)
    out.push_back(system.motion.empty()
                      ? system.placement
                      : frame_calculator::placement_at(scene.database.systems[++moving], frame));
  return out;
}

HiddenLines lines_at(const Scene& scene, const Options& options, double frame) {
  Notices notices;
  hidden_line::PartSet parts = hidden_line::scene_parts(
      scene.read.environment, placements_at(scene, frame), options.wires, notices);
  if (parts.parts.size() > HiddenLines::kMostParts)
    throw InputError(scene.name, 0,
                     fmt::format("makes {} solids and figures; hidden lines compare each with "
                                 "each and take {} at most, give a part of the scene",
                                 parts.parts.size(), HiddenLines::kMostParts));
  std::vector<Plane> planes = hidden_line::table_planes(scene.read.environment);
  const std::vector<Plane>& own = scene.database.systems.front().hierarchy.planes;
  planes.insert(planes.end(), own.begin(), own.end());
  return HiddenLines(std::move(parts), planes);
}

std::filesystem::path numbered(const std::string& output, std::size_t frame, std::size_t frames) {
  std::filesystem::path file(output);
  if (frames == 1) return file;
  return file.parent_path() /
         fmt::format("{}-{:04}{}", file.stem().string(), frame, file.extension().string());
}

Json counters_json(const Counters& counters) {
  Json out = Json::object();
  for_each_counter([&](const NamedCounter& c) { out[c.key] = counters.*c.value; });
  return out;
}

void print_counters(const Counters& counters) {
  for_each_counter([&](const NamedCounter& c) {
    fmt::print("  {:<8}{:<40}{:>10}\n", c.letters, c.key, counters.*c.value);
  });
}

Json kinds_json(const HiddenLines& lines) {
  std::array<std::uint64_t, 3> kinds{};
  for (const hidden_line::Part& part : lines.parts()) ++kinds[static_cast<std::size_t>(part.kind)];
  return {{"solids", kinds[0]},
          {"figures", kinds[1]},
          {"wire_frames", kinds[2]},
          {"separation_planes", lines.sepl().planes()},
          {"unresolved_pairs", lines.sepl().unresolved_pairs()}};
}

int draw(const Options& options) {
  check_ending("-o", options.output, {"svg"});
  const std::vector<PathRow> path = load_path(options.view);
  const Scene scene = load(options.scene);
  const std::size_t objects = scene.read.environment.objects.size();
  for (const std::uint32_t wire : options.wires)
    if (wire > objects)
      throw UsageError(
          fmt::format("--wire: there is no object {}; the scene has {}", wire, objects));
  const std::vector<FrameView> views = frame_views(options.view, path, scene.database);
  const Raster raster = options.view.raster.value_or(Raster());
  const bool moving = moves(scene.read.environment);
  HiddenLines lines = lines_at(scene, options, views.front().position);
  Json frames = Json::array();
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (moving && i > 0) lines = lines_at(scene, options, views[i].position);
    const ViewTransform view = frame_calculator::view_transform(views[i].viewpoint, raster);
    HostTime time;
    lines.compute(view, options.hidden);
    const double ms = time.lap();
    const std::vector<PictureLine> drawn = picture_lines(lines, view);
    const std::filesystem::path file = numbered(options.output, i, views.size());
    write_file(file, lines_svg(drawn, raster, "Hidden lines of " + scene.name));
    Json frame{{"file", file.string()}, {"host_ms", ms}, {"lines", drawn.size()}};
    frame.update(counters_json(lines.counters()));
    frames.push_back(std::move(frame));
  }
  Json figures{{"scene", scene.name}, {"objects", objects}};
  figures.update(kinds_json(lines));
  if (options.json) {
    figures["frames"] = std::move(frames);
    fmt::print("{}\n", dump(figures));
    return 0;
  }
  for (const auto& [name, value] : figures.items())
    fmt::print("{:<20}{:>10}\n", name, value.is_string() ? value.get<std::string>() : value.dump());
  fmt::print("{}{}: {} lines, counted as in Levine 1975, app. III\n",
             frames.back()["file"].get<std::string>(), views.size() > 1 ? " (the last)" : "",
             frames.back()["lines"].get<std::size_t>());
  print_counters(lines.counters());
  return 0;
}

}  // namespace

void add_hidden_line(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "hidden-line", "Draw a scene with lines, hidden ones left out (Levine 1975)");
  command->footer(
      "Examples:\n"
      "  cigsim hidden-line scenes/levine-city.json -o city.svg\n"
      "  cigsim hidden-line scene.obj -o scene.svg --hidden dashed --eye 10,-20,8\n"
      "  cigsim hidden-line --path builtin --frames 20 -o fly.svg      fly-0000.svg and on\n");
  add_scene_option(*command, options->scene);
  command
      ->add_option("-o,--output", options->output,
                   "SVG to write; with several frames NAME-0000.svg and on")
      ->type_name("FILE.svg")
      ->required();
  command
      ->add_option_function<std::string>(
          "--hidden",
          [options](const std::string& text) {
            options->hidden =
                parse_choice<bool>("--hidden", text, {{"none", false}, {"dashed", true}});
          },
          "What becomes of hidden lines. Default: none")
      ->type_name("none|dashed");
  command
      ->add_option_function<std::string>(
          "--wire",
          [options](const std::string& text) {
            for (std::size_t at = 0; at <= text.size();) {
              const std::size_t end = std::min(text.find(',', at), text.size());
              options->wires.push_back(static_cast<std::uint32_t>(
                  parse_whole("--wire", text.substr(at, end - at), 1, 0xffffffffu)));
              at = end + 1;
            }
          },
          "Objects that are wire frames: they hide nothing")
      ->type_name("N,N,…");
  add_view_options(*command, options->view);
  command->add_flag("--json", options->json, "Print the counters of every frame as JSON");
  command->callback([options, &exit_code] { exit_code = draw(*options); });
}

}  // namespace cigsim
