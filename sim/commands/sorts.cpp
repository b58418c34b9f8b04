// SPDX-License-Identifier: MIT
// cigsim sorts: the sorts of hidden-surface algorithms (Sandor 1979, sec. 5.3) on the lists of a
// scene, and on the keys of his example.
#include "models/survey/sorting/sorts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "models/survey/sorting/scene_lists.hpp"
#include "models/survey/visible_surface/frame.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/processor_time.hpp"
#include "sim/scene.hpp"
#include "sim/stats.hpp"
#include "sim/view.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
using survey::Record;
using survey::SortLists;
using survey::SortWork;

// A list in order makes quicksort compare every pair, one in the reverse order bubble sort.
constexpr std::size_t kLongestSquare = 50000;
constexpr unsigned kRadix = 32;  // two passes for an element of up to 1,023

struct Options {
  std::optional<std::string> scene;
  ViewOptions view;
  PreparationChoices preparation;
  bool json = false, example = false;
};

struct Sort {
  const char* name;
  void (*run)(std::vector<Record>&, SortWork&);
  bool square;  ///< of the order of N^2 for some lists
};

void library_sort(std::vector<Record>& records, SortWork& work) {
  std::sort(records.begin(), records.end(), [&work](const Record& a, const Record& b) {
    ++work.comparisons;
    return a.key < b.key;
  });
}

constexpr Sort kSorts[] = {
    {"bubble", [](std::vector<Record>& r, SortWork& w) { survey::bubble_sort(r, w); }, true},
    {"quicksort", [](std::vector<Record>& r, SortWork& w) { survey::quicksort(r, w); }, true},
    {"radix", [](std::vector<Record>& r, SortWork& w) { survey::radix_sort(r, kRadix, w); }, false},
    {"std::sort", library_sort, false}};

struct Result {
  const Sort* sort;
  SortWork work;
  double host_ms = 0;
  bool left_out = false;
  bool in_order = true;
};

Result measure(const Sort& sort, const SortLists& lists) {
  Result result{&sort, {}};
  std::vector<Record> records;
  for (const auto& list : lists.lists) {
    result.left_out |= sort.square && list.size() > kLongestSquare;
    if (result.left_out) break;
    records = list;
    ProcessorTime time;
    sort.run(records, result.work);
    result.host_ms += time.lap();
    result.in_order &=
        records.size() == list.size() &&
        std::is_sorted(records.begin(), records.end(),
                       [](const Record& a, const Record& b) { return a.key < b.key; });
  }
  return result;
}

std::string keys_of(std::span<const Record> records) {
  std::string text;
  for (const Record& r : records) text += fmt::format("{:>5}", r.key);
  return text;
}

std::string numbers(const std::vector<std::uint32_t>& values) {
  std::string text;
  for (const std::uint32_t v : values) text += fmt::format("{:>5}", v);
  return text;
}

// The ten keys of sec. 5.3, in the steps in which they are printed there, and to the end.
int print_example() {
  const std::uint32_t keys[] = {503, 512, 908, 897, 275, 426, 154, 509, 677, 703};
  std::vector<Record> given;
  for (const std::uint32_t key : keys) given.push_back({key, 0});
  SortWork work;
  std::vector<Record> records = given;
  fmt::print("Quicksort: exchanges of the first pass, then of its two parts\n  given       {}\n",
             keys_of(given));
  int count = 0;
  survey::quicksort(records, work, [&](const survey::Exchange& e) {
    fmt::print("  {:>2} {:<9}{}   {} and {}\n", ++count, e.right_moves ? "j moves" : "i moves",
               keys_of(e.records), e.records[e.i].key, e.records[e.j].key);
  });
  fmt::print("  {} comparisons, {} exchanges\n", work.comparisons, work.exchanges);
  fmt::print("Radix sort, base 10\n  given       {}\n", keys_of(given));
  records = given;
  work = {};
  survey::radix_sort(records, 10, work, [](const survey::RadixPass& pass) {
    fmt::print("  counts      {}\n  allocated   {}\n  pass {}      {}\n", numbers(pass.counts),
               numbers(pass.allocated), pass.digit + 1, keys_of(pass.records));
  });
  fmt::print("  {} passes, {} moves\n", work.passes, work.moves);
  records = given;
  work = {};
  survey::bubble_sort(records, work);
  fmt::print("Bubble sort\n  sorted      {}\n  {} passes, {} comparisons, {} exchanges\n",
             keys_of(records), work.passes, work.comparisons, work.exchanges);
  return 0;
}

void print_json(const std::string& scene, const std::vector<SortLists>& lists,
                const std::vector<std::vector<Result>>& results) {
  Json list = Json::array();
  for (std::size_t l = 0; l < lists.size(); ++l) {
    Json sorts = Json::array();
    for (const Result& r : results[l]) {
      Json row{{"sort", r.sort->name}, {"left_out", r.left_out}};
      if (!r.left_out) {
        row["comparisons"] = r.work.comparisons;
        row["exchanges"] = r.work.exchanges;
        row["moves"] = r.work.moves;
        row["passes"] = r.work.passes;
        row["host_ms"] = r.host_ms;
        row["in_order"] = r.in_order;
      }
      sorts.push_back(std::move(row));
    }
    list.push_back({{"list", lists[l].name},
                    {"meaning", lists[l].meaning},
                    {"lists", lists[l].lists.size()},
                    {"records", lists[l].records},
                    {"sorts", std::move(sorts)}});
  }
  fmt::print("{}\n", dump(Json{{"scene", scene}, {"lists", std::move(list)}}));
}

void print_table(const std::string& scene, const std::vector<SortLists>& lists,
                 const std::vector<std::vector<Result>>& results) {
  fmt::print("Sorts on the lists of a picture ({})\n", scene);
  for (std::size_t l = 0; l < lists.size(); ++l) {
    fmt::print("{}: {}; {} records in {} list{}\n", lists[l].name, lists[l].meaning,
               lists[l].records, lists[l].lists.size(), lists[l].lists.size() == 1 ? "" : "s");
    fmt::print("  {:<12}{:>14}{:>12}{:>12}{:>10}{:>11}\n", "sort", "comparisons", "exchanges",
               "moves", "passes", "host ms");
    for (const Result& r : results[l]) {
      if (r.left_out) {
        fmt::print("  {:<12}left out: a list of more than {} records\n", r.sort->name,
                   kLongestSquare);
        continue;
      }
      fmt::print("  {:<12}{:>14}{:>12}{:>12}{:>10}{:>11.3f}{}\n", r.sort->name, r.work.comparisons,
                 r.work.exchanges, r.work.moves, r.work.passes, r.host_ms,
                 r.in_order ? "" : "  NOT IN ORDER");
    }
  }
  fmt::print(
      "radix: base {}; std::sort counts no exchanges, moves or passes; host ms: processor time\n",
      kRadix);
}

int sorts(const Options& options) {
  if (options.example) return print_example();
  const std::vector<PathRow> path = load_path(options.view);
  const LoadedScene scene = load_scene(options.scene, options.preparation);
  const std::vector<FrameView> views = frame_views(options.view, path, scene.database);
  const survey::Frame frame =
      survey::make_frame(scene.database, views.front().viewpoint,
                         options.view.raster.value_or(Raster()), views.front().position);
  const std::vector<SortLists> lists = survey::scene_lists(frame.list);
  std::vector<std::vector<Result>> results;
  bool in_order = true;
  for (const SortLists& each : lists) {
    auto& rows = results.emplace_back();
    for (const Sort& sort : kSorts) {
      rows.push_back(measure(sort, each));
      in_order &= rows.back().in_order;
    }
  }
  (options.json ? print_json : print_table)(scene.name, lists, results);
  return in_order ? 0 : 1;
}

}  // namespace

void add_sorts(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "sorts", "Measure bubble sort, quicksort and radix sort on the lists of a picture");
  command->footer(
      "The first frame of a path is measured.\n"
      "\nExamples:\n"
      "  cigsim sorts                    the built-in airfield\n"
      "  cigsim sorts --example          Sandor's ten keys, step by step\n");
  add_scene_option(*command, options->scene);
  add_view_options(*command, options->view);
  add_preparation_options(*command, options->preparation);
  command->add_flag("--example", options->example,
                    "Print the steps of the survey's example instead of measuring a scene");
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command->callback([options, &exit_code] {
    if (options->example && (options->scene || options->json))
      throw UsageError("--example stands alone; leave out the scene and --json");
    exit_code = sorts(*options);
  });
}

}  // namespace cigsim
