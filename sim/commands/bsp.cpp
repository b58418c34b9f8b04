// SPDX-License-Identifier: MIT
// cigsim bsp: the polygons of a scene as a BSP tree (Fuchs, Kedem, Naylor 1980).
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "models/database/bsp/build.hpp"
#include "models/database/bsp/traversal.hpp"
#include "models/database/database_file.hpp"
#include "models/environment/detail.hpp"
#include "models/environment/read.hpp"
#include "models/environment/write.hpp"
#include "sim/arguments.hpp"
#include "sim/bsp/bsp_json.hpp"
#include "sim/bsp/part_names.hpp"
#include "sim/bsp/tree_picture.hpp"
#include "sim/commands/commands.hpp"
#include "sim/host_time.hpp"
#include "sim/progress.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMostCandidates = 4096;
constexpr std::size_t kPrioritiesPrinted = 40;

struct Options {
  std::string scene, rule = "cost";
  RootOptions root;
  std::optional<double> weight;
  std::optional<Vec3> eye;
  std::optional<std::string> tree, output;
  bool json = false;
};

struct Result {
  std::uint64_t faces = 0, moving = 0, ground = 0;
  std::vector<Notice> notices;
  BspTree tree;
  double seconds = 0;
  std::optional<std::vector<std::uint32_t>> priorities;
};

void check(const Options& options) {
  if (options.weight && options.root.rule != BspRule::kConflicts)
    throw UsageError("--weight belongs to --rule 2");
  if (options.tree) {
    check_ending("--tree", *options.tree, {"svg"});
    check_not_input("--tree", *options.tree, options.scene);
  }
  if (options.output) {
    check_ending("-o", *options.output, {"json"});
    check_not_input("-o", *options.output, options.scene);
  }
  if (is_database(options.scene))
    throw UsageError(fmt::format("{} is prepared; give the scene it was made from", options.scene));
}

Result build(const Options& options) {
  const ReadResult read = read_environment(options.scene);
  Result result;
  BspPolygons polygons = bsp_polygons(most_detailed(read.environment));
  result.faces = polygons.faces;
  result.moving = polygons.moving_objects;
  result.ground = read.environment.ground.size();
  result.notices = read.notices;
  result.notices.insert(result.notices.end(), polygons.notices.begin(), polygons.notices.end());
  Progress progress("building the tree");
  BspOptions build_options{options.root, [&](double share) { progress.show(share); }};
  HostTime time;
  result.tree = build_bsp(std::move(polygons), build_options);
  result.seconds = time.lap() / 1000;
  if (options.eye) result.priorities = visibility_priorities(result.tree, *options.eye);
  return result;
}

Json figures(const Options& options, const Result& r) {
  Json out{{"scene", options.scene},
           {"rule", options.rule},
           {"candidates", options.root.candidates},
           {"seed", options.root.seed},
           {"faces", r.faces},
           {"polygons", r.tree.polygons},
           {"fragments", r.tree.members.size()},
           {"splits", r.tree.splits},
           {"nodes", r.tree.nodes.size()},
           {"leaves", r.tree.leaves()},
           {"depth", r.tree.depth},
           {"dividing_planes", r.tree.dividing_planes},
           {"seconds", r.seconds}};
  if (options.root.rule == BspRule::kConflicts) out["weight"] = options.root.weight;
  if (options.eye) out["eye"] = {options.eye->x, options.eye->y, options.eye->z};
  Json notices = Json::array();
  for (const Notice& notice : r.notices)
    notices.push_back({{"count", notice.count}, {"what", notice.what}});
  out["notices"] = std::move(notices);
  return out;
}

// Places of BspTree::members, the highest priority first.
std::vector<std::uint32_t> by_priority(const std::vector<std::uint32_t>& priorities) {
  std::vector<std::uint32_t> order(priorities.size());
  for (std::uint32_t m = 0; m < order.size(); ++m) order[priorities.size() - priorities[m]] = m;
  return order;
}

void print_json(const Options& options, const Result& r) {
  Json out = figures(options, r);
  if (r.priorities) {
    const std::vector<std::string> names = part_names(r.tree);
    Json list = Json::array();
    for (const std::uint32_t m : by_priority(*r.priorities))
      list.push_back({{"priority", (*r.priorities)[m]},
                      {"name", names[m]},
                      {"object", r.tree.polygon(r.tree.members[m]).origin.object}});
    out["priorities"] = std::move(list);
  }
  fmt::print("{}\n", dump(out));
}

void print_priorities(const Result& r) {
  const std::vector<std::string> names = part_names(r.tree);
  const std::vector<std::uint32_t> order = by_priority(*r.priorities);
  fmt::print("Priority from the eyepoint, the highest first\n");
  for (std::size_t i = 0; i < std::min(order.size(), kPrioritiesPrinted); ++i)
    fmt::print("{:>10}  {:<10} of object {}\n", (*r.priorities)[order[i]], names[order[i]],
               r.tree.polygon(r.tree.members[order[i]]).origin.object);
  if (order.size() > kPrioritiesPrinted)
    fmt::print("{:>10}  more; all of them with --json, or in the file of -o\n",
               order.size() - kPrioritiesPrinted);
}

void print_table(const Options& options, const Result& r) {
  const auto row = [](const char* name, std::uint64_t value, const char* meaning) {
    fmt::print("{:<18}{:>12}{}{}\n", name, value, *meaning == '\0' ? "" : "  ", meaning);
  };
  row("faces", r.faces, "of the objects that stand still");
  row("polygons", r.tree.polygons, "planar and convex, into the tree");
  row("fragments", r.tree.members.size(), "polygons and parts in the tree");
  row("splits", r.tree.splits, "times that a plane cut a polygon in two");
  row("nodes", r.tree.nodes.size(), "coplanar polygons share one");
  if (r.tree.dividing_planes > 0)
    row("dividing planes", r.tree.dividing_planes, "nodes without a polygon");
  row("leaves", r.tree.leaves(), "regions of space");
  row("depth", r.tree.depth, "nodes on the longest way down");
  fmt::print("{:<18}{:>12.3f}  seconds\n", "time", r.seconds);
  if (r.moving > 0) row("left out", r.moving, "objects that move");
  if (r.ground > 0) row("left out", r.ground, "ground faces, which are below all polygons");
  for (const Notice& notice : r.notices)
    fmt::print("{:<18}{:>12}  {}\n", "notice", notice.count, notice.what);
  if (r.priorities) print_priorities(r);
  for (const auto& file : {options.tree, options.output})
    if (file) fmt::print("{} written\n", *file);
}

int run(const Options& options) {
  check(options);
  const Result result = build(options);
  if (options.output) {
    Json whole = figures(options, result);
    whole["tree"] = bsp_tree_json(result.tree, result.priorities);
    write_file(*options.output, dump(whole) + "\n");
  }
  if (options.tree) write_file(*options.tree, bsp_picture(result.tree));
  (options.json ? print_json : print_table)(options, result);
  return 0;
}

void add_rule_options(CLI::App& command, const std::shared_ptr<Options>& options) {
  command
      .add_option_function<std::string>(
          "--rule",
          [options](const std::string& text) {
            options->rule = text;
            options->root.rule = parse_choice<BspRule>("--rule", text,
                                                       {{"first", BspRule::kFirst},
                                                        {"1", BspRule::kFewestSplits},
                                                        {"2", BspRule::kConflicts},
                                                        {"cost", BspRule::kCost}});
          },
          "Which polygon becomes a root: the first, the one that splits fewest (1), the one that "
          "eliminates most conflicts (2), or the one of least expected cost. Default: cost")
      ->type_name("first|1|2|cost");
  command
      .add_option_function<std::string>(
          "--weight",
          [options](const std::string& text) {
            options->root.weight = parse_number("--weight", text);
            options->weight = options->root.weight;
          },
          "Of rule 2: what a conflict among the polygons that a root splits counts. Default: 1")
      ->type_name("W");
  command
      .add_option_function<std::string>(
          "--candidates",
          [options](const std::string& text) {
            options->root.candidates =
                static_cast<std::uint32_t>(parse_whole("--candidates", text, 1, kMostCandidates));
          },
          "Polygons of a longer list that are tried as its root, drawn at random. Default: 128 "
          "for rules 1 and 2, 64 for cost")
      ->type_name("N");
  command
      .add_option_function<std::string>(
          "--seed",
          [options](const std::string& text) {
            options->root.seed =
                parse_whole("--seed", text, 0, std::numeric_limits<std::uint64_t>::max());
          },
          "Of these draws; the same scene, rule and seed give the same tree. Default: 1")
      ->type_name("S");
  command.add_flag_callback(
      "--polygon-planes", [options] { options->root.dividing_planes = false; },
      "Rule cost: planes of polygons only, no dividing plane across an axis");
}

}  // namespace

void add_bsp(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "bsp", "Part a scene's polygons by a tree that gives their priority from any eyepoint");
  command->footer(
      "Examples:\n"
      "  cigsim bsp scenes/fuchs-overlap.json --rule 1 --eye -3,-16,20 --tree tree.svg\n"
      "  cigsim bsp city.json -o tree.json\n");
  command->add_option("SCENE", options->scene, "Scene file")->required()->type_name("");
  add_rule_options(*command, options);
  command
      ->add_option_function<std::string>(
          "--eye",
          [options](const std::string& text) { options->eye = parse_vector("--eye", text); },
          "Number the polygons by their visibility priority from here")
      ->type_name("X,Y,Z");
  command->add_option("--tree", options->tree, "Draw the tree")->type_name("OUT.svg");
  command->add_option("-o,--output", options->output, "Write the tree")->type_name("OUT.json");
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace cigsim
