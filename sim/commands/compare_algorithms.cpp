// SPDX-License-Identifier: MIT
// cigsim compare-algorithms: the hidden-surface algorithms of the survey (Sandor 1979, sec. 5.2) on
// one scene, each against the machine's own picture.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "models/survey/visible_surface/algorithm.hpp"
#include "models/survey/visible_surface/frame.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/functional_machine.hpp"
#include "sim/processor_time.hpp"
#include "sim/progress.hpp"
#include "sim/scene.hpp"
#include "sim/stats.hpp"
#include "sim/view.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
using survey::Algorithm;
using survey::Work;

constexpr std::uint64_t kMostRepeats = 1000;

struct Options {
  std::optional<std::string> scene;
  ViewOptions view;
  PreparationChoices preparation;
  std::uint64_t repeat = 1;
  bool json = false;
};

/// Of one algorithm over all frames.
struct Result {
  const Algorithm* algorithm;
  Work work;
  double host_ms = 0;
  std::uint64_t differs = 0;
};

struct Comparison {
  Raster raster;
  std::size_t frames = 0;
  std::uint64_t faces = 0, edges = 0, clusters = 0, faults = 0;
  std::vector<Result> results;

  std::uint64_t differs() const {
    std::uint64_t sum = 0;
    for (const Result& result : results) sum += result.differs;
    return sum;
  }
};

struct Counter {
  const char *name, *heading;
  std::uint64_t Work::*count;
};
constexpr Counter kCounters[] = {{"sorts", "sorts", &Work::sorts},
                                 {"comparisons", "comparisons", &Work::comparisons},
                                 {"segments", "segments", &Work::segments},
                                 {"depths", "depths", &Work::depths},
                                 {"subdivisions", "divisions", &Work::subdivisions},
                                 {"writes", "elements", &Work::writes}};

void add(const Work& work, Work& sum) {
  for (const auto count :
       {&Work::faces, &Work::edges, &Work::sorts, &Work::comparisons, &Work::segments,
        &Work::depths, &Work::subdivisions, &Work::writes, &Work::exact_tests})
    sum.*count += work.*count;
}

// The median time; the work is the same each time.
double measure(const Algorithm& algorithm, const survey::FaceList& list, std::uint64_t repeat,
               survey::FacePicture& picture, Work& work) {
  std::vector<double> times;
  for (std::uint64_t i = 0; i < repeat; ++i) {
    work = {};
    ProcessorTime time;
    algorithm.compute(list, picture, work);
    times.push_back(time.lap());
  }
  return median(std::move(times));
}

Comparison compare(const Database& database, const std::vector<FrameView>& views,
                   const Raster& raster, std::uint64_t repeat) {
  Comparison out;
  out.raster = raster;
  out.frames = views.size();
  for (const Algorithm& algorithm : survey::algorithms()) out.results.push_back({&algorithm, {}});
  MachineOptions options;
  options.number = NumberType::kExact;
  options.raster = raster;
  FunctionalMachine machine(database, options);
  Progress progress("comparing");
  survey::FacePicture got;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const survey::Frame frame =
        survey::make_frame(database, views[v].viewpoint, raster, views[v].position);
    const Picture& want = machine.compute(views[v].viewpoint, views[v].position);
    out.faces += frame.list.faces.size();
    out.edges += frame.list.edges.size();
    out.clusters += frame.list.clusters;
    out.faults += frame.faults.size();
    for (std::size_t a = 0; a < out.results.size(); ++a) {
      Result& result = out.results[a];
      Work work;
      result.host_ms += measure(*result.algorithm, frame.list, repeat, got, work);
      add(work, result.work);
      result.differs += survey::differences(frame.list, got, database.background, want);
      progress.show((static_cast<double>(v) +
                     static_cast<double>(a + 1) / static_cast<double>(out.results.size())) /
                    static_cast<double>(views.size()));
    }
  }
  return out;
}

// Time by the z-buffer's, in the survey's scale, where the z-buffer costs as much for any scene.
double relative(const Comparison& comparison, const Result& result) {
  const Result& plain = comparison.results.back();
  return plain.host_ms > 0 ? (*plain.algorithm->published_cost)[0] * result.host_ms / plain.host_ms
                           : 0;
}

void print_json(const std::string& scene, const Comparison& comparison) {
  Json list = Json::array();
  for (const Result& result : comparison.results) {
    Json work = Json::object();
    work["faces"] = result.work.faces;
    work["edges"] = result.work.edges;
    for (const Counter& counter : kCounters) work[counter.name] = result.work.*counter.count;
    work["exact_tests"] = result.work.exact_tests;
    Json row{{"name", result.algorithm->name},
             {"year", result.algorithm->year},
             {"kind", result.algorithm->kind},
             {"work", std::move(work)},
             {"host_ms", result.host_ms},
             {"differs", result.differs},
             {"relative", relative(comparison, result)}};
    row["survey"] =
        result.algorithm->published_cost ? Json(*result.algorithm->published_cost) : Json(nullptr);
    list.push_back(std::move(row));
  }
  const Json figures{{"scene", scene},
                     {"raster", {comparison.raster.width, comparison.raster.height}},
                     {"frames", comparison.frames},
                     {"faces", comparison.faces},
                     {"edges", comparison.edges},
                     {"clusters", comparison.clusters},
                     {"listability_faults", comparison.faults},
                     {"survey_faces", {100, 2500, 60000}},
                     {"algorithms", std::move(list)}};
  fmt::print("{}\n", dump(figures));
}

std::string survey_columns(const Algorithm& algorithm) {
  if (!algorithm.published_cost) return fmt::format("{:>6}{:>7}{:>8}", "-", "-", "-");
  const auto& cost = *algorithm.published_cost;
  return fmt::format("{:>6}{:>7}{:>8}", cost[0], cost[1], cost[2]);
}

void print_differences(const Comparison& comparison) {
  const bool depth_agrees = comparison.results.back().differs == 0;
  for (const Result& result : comparison.results) {
    if (result.differs == 0) continue;
    const std::string_view limit = result.algorithm->limit;
    fmt::print("{}: {} elements differ from the machine's picture{}\n", result.algorithm->name,
               result.differs,
               depth_agrees && !limit.empty()
                   ? fmt::format("; as published it cannot show {}", limit)
                   : std::string());
  }
  if (comparison.differs() == 0)
    fmt::print("Every element of every picture is that of the machine's functional level.\n");
  else if (comparison.faults > 0)
    fmt::print("The machine has no right order here (listability faults: {}).\n",
               comparison.faults);
  else if (!depth_agrees)
    fmt::print(
        "The machine's order is not that of depth: something passes through what preparation has\n"
        "not cut for it, as models that move into each other do.\n");
}

void print_table(const std::string& scene, const Comparison& c) {
  fmt::print(
      "Hidden surfaces ({}): {} x {} elements, {} frame{}, {} faces, {} edges, {} clusters\n",
      scene, c.raster.width, c.raster.height, c.frames, c.frames == 1 ? "" : "s", c.faces, c.edges,
      c.clusters);
  fmt::print("{:<11}", "algorithm");
  for (const Counter& counter : kCounters) fmt::print("{:>13}", counter.heading);
  fmt::print("{:>11}{:>9}{:>10} |{:>6}{:>7}{:>8}\n", "host ms", "differs", "relative", "100",
             "2,500", "60,000");
  for (const Result& result : c.results) {
    fmt::print("{:<11}", result.algorithm->name);
    for (const Counter& counter : kCounters) fmt::print("{:>13}", result.work.*counter.count);
    fmt::print("{:>11.2f}{:>9}{:>10.1f} |{}\n", result.host_ms, result.differs, relative(c, result),
               survey_columns(*result.algorithm));
  }
  fmt::print(
      "host ms: processor time. relative: the same, with the z-buffer at 54. Right of it what\n"
      "Sutherland, Sproull and Schumacker (1974) estimated for scenes of so many faces: orders of\n"
      "magnitude only, for machines of their day; -: not among the figures used here.\n");
  print_differences(c);
}

int compare_algorithms(const Options& options) {
  const std::vector<PathRow> path = load_path(options.view);
  const LoadedScene scene = load_scene(options.scene, options.preparation);
  const std::vector<FrameView> views = frame_views(options.view, path, scene.database);
  const Comparison comparison =
      compare(scene.database, views, options.view.raster.value_or(Raster()), options.repeat);
  (options.json ? print_json : print_table)(scene.name, comparison);
  return comparison.differs() == 0 ? 0 : 1;
}

}  // namespace

void add_compare_algorithms(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "compare-algorithms", "Draw a scene by the hidden-surface algorithms of the 1970s");
  command->footer(
      "Warnock, Newell, Schumacker, Watkins, Bouknight, Wylie and a z-buffer get the same faces,\n"
      "in exact numbers. Ends with 1 when an element differs from the machine's picture.\n"
      "\nExamples:\n"
      "  cigsim compare-algorithms                       the built-in airfield\n"
      "  cigsim compare-algorithms city.json --repeat 5  steadier times\n");
  add_scene_option(*command, options->scene);
  add_view_options(*command, options->view);
  add_preparation_options(*command, options->preparation);
  command
      ->add_option_function<std::string>(
          "--repeat",
          [options](const std::string& text) {
            options->repeat = parse_whole("--repeat", text, 1, kMostRepeats);
          },
          "Compute each picture so many times and tell the median time. Default: 1")
      ->type_name("N");
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command->callback([options, &exit_code] { exit_code = compare_algorithms(*options); });
}

}  // namespace cigsim
