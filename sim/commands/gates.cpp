// SPDX-License-Identifier: MIT
// cigsim gates: what the priority hardware would have taken in parts of about 1975.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "models/machine/description.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/gates/ordering.hpp"
#include "sim/gates/parts.hpp"
#include "sim/gates/synthesis.hpp"
#include "sim/progress.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using namespace gates;
using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMostObjects = 256, kMostPlanes = 256, kMostFaces = 4096;
constexpr std::uint32_t kMostCounters = 64, kFacesOfWord = 32;
constexpr std::uint32_t kWidestMatrix = 64;  // objects; a wider one takes Yosys minutes

struct Size {
  std::uint32_t objects, planes;
};

struct Options {
  std::string sizes = "5x4,16x16,64x64", faces = "64,1024,4096";
  std::string machine = "asupt1975";
  bool json = false;
};

/// A line of the table.
struct Row {
  std::string module, size;
  Json parameters;
  Inventory inventory;
  double levels;
  std::vector<double> delays;  // ns, by family
};

/// How many objects the SO logic orders.
struct Ordering {
  std::size_t row;  // of the table
  Way way;
  std::uint32_t width;
};

std::vector<std::string> words(const std::string& list) {
  std::vector<std::string> result;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    result.push_back(list.substr(at, end - at));
    at = end + 1;
  }
  return result;
}

std::vector<Size> parse_sizes(const std::string& list) {
  std::vector<Size> sizes;
  for (const std::string& word : words(list)) {
    const std::size_t x = word.find('x');
    if (x == std::string::npos)
      throw UsageError(fmt::format("--size {}: is not OBJECTSxPLANES, such as 64x64", word));
    sizes.push_back(
        {static_cast<std::uint32_t>(parse_whole("--size", word.substr(0, x), 2, kMostObjects)),
         static_cast<std::uint32_t>(parse_whole("--size", word.substr(x + 1), 1, kMostPlanes))});
  }
  return sizes;
}

std::vector<std::uint32_t> parse_faces(const std::string& list) {
  std::vector<std::uint32_t> faces;
  for (const std::string& word : words(list)) {
    faces.push_back(
        static_cast<std::uint32_t>(parse_whole("--faces", word, 2 * kFacesOfWord, kMostFaces)));
    if (faces.back() % kFacesOfWord != 0)
      throw UsageError(fmt::format("--faces {}: is no multiple of {}", word, kFacesOfWord));
  }
  return faces;
}

void add_row(const Netlist& netlist, std::string module, std::string size, Json parameters,
             std::vector<Row>& rows) {
  Row row{std::move(module), std::move(size), std::move(parameters), {}, 0, {}};
  row.inventory = netlist.inventory(row.module);
  row.levels = netlist.longest_way(row.module, {});
  for (const Family& family : families())
    row.delays.push_back(netlist.longest_way(row.module, {family.gate_ns, family.ram_ns}));
  rows.push_back(std::move(row));
}

void map_all(const std::vector<Size>& sizes, const std::vector<std::uint32_t>& faces,
             std::vector<Row>& rows, std::vector<Ordering>& orderings) {
  std::set<std::uint32_t> counters;
  for (const Size& size : sizes)
    if (size.objects <= kMostCounters) counters.insert(size.objects);
  const double all = static_cast<double>(sizes.size() + counters.size() + 2 * faces.size());
  double done = 0;
  Progress progress("mapping");
  const Synthesis synthesis;
  const auto map = [&](const Circuit& circuit) {
    progress.show(done++ / all);
    return synthesis.map(circuit);
  };

  for (const auto& [objects, planes] : sizes) {
    const bool whole = objects <= kWidestMatrix;
    const Json parameters{{"Objects", objects}, {"Planes", planes}};
    const std::string both = fmt::format("{} x {}", objects, planes);
    const Netlist netlist = map({"priority_processor",
                                 whole ? "so_matrix" : "so_row",
                                 {{"Objects", objects}, {"Planes", planes}},
                                 true});
    const auto add = [&](const char* module, std::string size, const Json& sizes_of, Way way) {
      orderings.push_back({rows.size(), way, objects});
      add_row(netlist, module, std::move(size), sizes_of, rows);
    };
    add("so_pair", fmt::format("{} plane{}", planes, planes == 1 ? "" : "s"), {{"Planes", planes}},
        Way::kPair);
    add("so_row", both, parameters, Way::kRow);
    if (whole) add("so_matrix", both, parameters, Way::kMatrix);
  }
  for (const std::uint32_t members : counters)
    add_row(map({"priority_processor", "object_counters", {{"Members", members}}}),
            "object_counters", fmt::format("{} objects", members), {{"Members", members}}, rows);
  for (const std::uint32_t number : faces)
    for (const char* module : {"active_set", "priority_resolver"})
      add_row(map({"priority_resolver", module, {{"Faces", number}}}), module,
              fmt::format("{} faces", number), {{"Faces", number}}, rows);
}

/// Cycles of the machine for a step of logic with this delay.
Cycle cycles_for(double ns, const MachineDescription& machine) {
  return std::max<Cycle>(1, static_cast<Cycle>(std::ceil(ns / machine.clock_ns)));
}

std::uint64_t objects_in_cycles(const Ordering& ordering, Cycle cycles, Cycle of_step) {
  return objects_in(ordering.way, static_cast<std::uint64_t>(cycles / of_step), ordering.width);
}

std::string_view name_of(Way way) {
  switch (way) {
    case Way::kPair:
      return "a pair at a time";
    case Way::kRow:
      return "a row at a time";
    case Way::kMatrix:
      return "the matrix at a time";
  }
  return "";
}

void print_table(const std::vector<Row>& rows, const std::vector<Ordering>& orderings,
                 const MachineDescription& machine) {
  fmt::print("{:<18}{:<12}{:>9}{:>12}{:>10}{:>10}{:>8}", "circuit", "size", "gates", "flip-flops",
             "RAM bits", "packages", "levels");
  for (const Family& family : families()) fmt::print("{:>12}", fmt::format("{} ns", family.name));
  fmt::print("\n");
  for (const Row& row : rows) {
    fmt::print("{:<18}{:<12}{:>9}{:>12}{:>10}{:>10}{:>8}", row.module, row.size,
               row.inventory.gate_count(), row.inventory.flip_flops, row.inventory.ram_bits,
               row.inventory.packages(), row.levels);
    for (const double delay : row.delays) fmt::print("{:>12}", delay);
    fmt::print("\n");
  }
  fmt::print(
      "\nObjects whose SO matrix is worked out in a line of {} cycles and in a frame of {}, "
      "with a cycle of {} ns:\n",
      machine.line_cycles, machine.frame_cycles, machine.clock_ns);
  fmt::print("{:<22}{:<12}{:>10}{:>14}{:>14}{:>14}\n", "way", "size", "packages", "74S cycles",
             "in a line", "in a frame");
  for (const Ordering& ordering : orderings) {
    const Row& row = rows[ordering.row];
    const Cycle step = cycles_for(row.delays.front(), machine);
    fmt::print("{:<22}{:<12}{:>10}{:>14}{:>14}{:>14}\n", name_of(ordering.way), row.size,
               row.inventory.packages(), step,
               objects_in_cycles(ordering, machine.line_cycles, step),
               objects_in_cycles(ordering, machine.frame_cycles, step));
  }
  fmt::print("\nParts, with how many are in a package:");
  const char* separator = " ";
  for (const Part& part : parts()) {
    fmt::print("{}{} {} {}", separator, part.name, part.package, part.per_package);
    separator = ", ";
  }
  fmt::print("; flip-flop 74S174 {}; RAM 74S189 {} x {}.\n", kFlipFlopsPerPackage, kRamWords,
             kRamBits);
  for (const Family& family : families())
    fmt::print("{}: {} ns a gate level, {} ns a RAM; {}.\n", family.name, family.gate_ns,
               family.ram_ns, family.source);
  fmt::print(
      "XOR and multiplexer count as two levels. Loads, wires, and what registers take of a "
      "cycle are left out.\n");
}

void print_json(const std::vector<Row>& rows, const std::vector<Ordering>& orderings,
                const MachineDescription& machine) {
  Json circuits = Json::array(), ways = Json::array(), list = Json::object(),
       speeds = Json::object();
  for (const Row& row : rows) {
    Json delays = Json::object();
    for (std::size_t f = 0; f < row.delays.size(); ++f)
      delays[std::string(families()[f].name)] = row.delays[f];
    circuits.push_back({{"module", row.module},
                        {"parameters", row.parameters},
                        {"gates", row.inventory.gate_count()},
                        {"flip_flops", row.inventory.flip_flops},
                        {"ram_bits", row.inventory.ram_bits},
                        {"packages", row.inventory.packages()},
                        {"levels", row.levels},
                        {"delay_ns", std::move(delays)},
                        {"parts", row.inventory.gates}});
  }
  for (const Ordering& ordering : orderings) {
    const Row& row = rows[ordering.row];
    const Cycle step = cycles_for(row.delays.front(), machine);
    ways.push_back(
        {{"module", row.module},
         {"parameters", row.parameters},
         {"cycles_of_a_step", step},
         {"objects_in_a_line", objects_in_cycles(ordering, machine.line_cycles, step)},
         {"objects_in_a_frame", objects_in_cycles(ordering, machine.frame_cycles, step)}});
  }
  for (const Part& part : parts())
    list[std::string(part.name)] = {
        {"package", part.package}, {"per_package", part.per_package}, {"levels", part.levels}};
  for (const Family& family : families())
    speeds[std::string(family.name)] = {
        {"gate_ns", family.gate_ns}, {"ram_ns", family.ram_ns}, {"source", family.source}};
  const Json all{{"machine", machine.name},
                 {"clock_ns", machine.clock_ns},
                 {"line_cycles", machine.line_cycles},
                 {"frame_cycles", machine.frame_cycles},
                 {"parts", std::move(list)},
                 {"families", std::move(speeds)},
                 {"circuits", std::move(circuits)},
                 {"ordering", std::move(ways)}};
  fmt::print("{}\n", dump(all));
}

int gates_of(const Options& options) {
  const std::vector<Size> sizes = parse_sizes(options.sizes);
  const std::vector<std::uint32_t> faces = parse_faces(options.faces);
  const MachineDescription machine = load_machine(options.machine);
  if (machine.line_cycles == 0 || machine.frame_cycles == 0)
    throw UsageError(fmt::format("--machine {}: has no fixed line and frame", options.machine));
  std::vector<Row> rows;
  std::vector<Ordering> orderings;
  map_all(sizes, faces, rows, orderings);
  const auto print = options.json ? print_json : print_table;
  print(rows, orderings, machine);
  return 0;
}

}  // namespace

void add_gates(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "gates", "Count what the priority hardware takes in parts of about 1975");
  command->footer(
      "Maps the RTL of the SO logic, the counters and the priority resolver to 74S gates with\n"
      "Yosys (package yosys); tells gates, packages, gate levels and delays, and how many objects\n"
      "could be ordered in a line and in a frame.\n"
      "\nExamples:\n"
      "  cigsim gates                        the sizes of the manual, docs/machine/gates.md\n"
      "  cigsim gates --size 8x8,32x64 --faces 256 --json\n");
  command
      ->add_option("--size", options->sizes,
                   "Sizes of the SO logic, up to 256x256; whole matrices up to 64 objects")
      ->type_name("OBJECTSxPLANES,…");
  command->add_option("--faces", options->faces, "Sizes of the resolver, multiples of 32")
      ->type_name("N,…");
  command->add_option("--machine", options->machine, "Its clock, line and frame are the measure")
      ->type_name("PRESET|FILE.json");
  command->add_flag("--json", options->json, "Print JSON instead of the tables");
  command->callback([options, &exit_code] { exit_code = gates_of(*options); });
}

}  // namespace cigsim
