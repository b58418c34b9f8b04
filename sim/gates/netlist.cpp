// SPDX-License-Identifier: MIT
#include "sim/gates/netlist.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <vector>

#include "sim/gates/parts.hpp"

namespace cigsim::gates {
namespace {

using Json = nlohmann::json;

constexpr int kConstant = -1;  // a net that is always 0, or 1, or either

struct Module;

/// Where a net gets its value.
struct Driver {
  int cell = -1;    // none: an input
  int output = -1;  // of the cell
};

/// Inputs that an output waits for.
struct Cell {
  enum class Kind { kGate, kRegister, kRamRead, kModule } kind;
  int levels = 0;
  const Module* module = nullptr;
  std::vector<int> inputs, outputs;  // nets
};

struct Module {
  Inventory own;
  std::set<std::string> output_ports;
  std::vector<Cell> cells;
  std::vector<int> inputs, outputs;  // nets
  std::vector<Driver> drivers;       // by net
};

std::uint64_t packages_for(std::uint64_t count, int per_package) {
  return (count + static_cast<std::uint64_t>(per_package) - 1) /
         static_cast<std::uint64_t>(per_package);
}

void add(Inventory& sum, const Inventory& part) {
  for (const auto& [name, count] : part.gates) sum.gates[name] += count;
  sum.flip_flops += part.flip_flops;
  sum.ram_bits += part.ram_bits;
  sum.ram_packages += part.ram_packages;
}

std::vector<int> nets(const Json& bits) {
  std::vector<int> result;
  for (const Json& bit : bits) result.push_back(bit.is_number() ? bit.get<int>() : kConstant);
  return result;
}

std::vector<int> slice(const std::vector<int>& nets, std::size_t index, std::size_t width) {
  const auto first = nets.begin() + static_cast<std::ptrdiff_t>(index * width);
  return {first, first + static_cast<std::ptrdiff_t>(width)};
}

std::uint64_t binary(const Json& digits) {
  return std::stoull(digits.get<std::string>(), nullptr, 2);
}

// A memory: a cell for each place that is read, and one for all that is written.
void add_memory(const Json& cell, Module& module) {
  const Json& parameters = cell.at("parameters");
  const Json& connections = cell.at("connections");
  const std::uint64_t width = binary(parameters.at("WIDTH")), size = binary(parameters.at("SIZE")),
                      reads = binary(parameters.at("RD_PORTS"));
  const std::string clocked = parameters.at("RD_CLK_ENABLE").get<std::string>();
  if (std::ranges::count(clocked, '1') != 0)
    throw std::runtime_error("a memory with a register behind it");
  module.own.ram_bits += width * size;
  module.own.ram_packages += packages_for(width, kRamBits) * packages_for(size, kRamWords) * reads;
  const std::vector<int> address = nets(connections.at("RD_ADDR")),
                         data = nets(connections.at("RD_DATA"));
  for (std::uint64_t r = 0; r < reads; ++r)
    module.cells.push_back({Cell::Kind::kRamRead, 0, nullptr,
                            slice(address, r, address.size() / reads), slice(data, r, width)});
  Cell write{Cell::Kind::kRegister, 0, nullptr, {}, {}};
  for (const char* port : {"WR_ADDR", "WR_DATA", "WR_EN"}) {
    const std::vector<int> bits = nets(connections.at(port));
    write.inputs.insert(write.inputs.end(), bits.begin(), bits.end());
  }
  module.cells.push_back(std::move(write));
}

void add_cell(const Json& cell, const std::map<std::string, Module>& modules, Module& module) {
  const std::string type = cell.at("type").get<std::string>();
  if (type == "$mem_v2") return add_memory(cell, module);
  if (type == "ZERO" || type == "ONE") return;
  Cell made{Cell::Kind::kGate, 0, nullptr, {}, {}};
  const std::string_view output_of_part = type == "$_DFF_P_" ? "Q" : "Y";
  if (const Part* part = find_part(type)) {
    made.levels = part->levels;
    ++module.own.gates[type];
  } else if (type == "$_DFF_P_") {
    made.kind = Cell::Kind::kRegister;
    ++module.own.flip_flops;
  } else if (const auto found = modules.find(type); found != modules.end()) {
    made.kind = Cell::Kind::kModule;
    made.module = &found->second;
  } else {
    throw std::runtime_error("there is no part for the cell " + type);
  }
  const auto put = [](std::vector<int>& to, const Json& bits) {
    const std::vector<int> added = nets(bits);
    to.insert(to.end(), added.begin(), added.end());
  };
  // Ports of cells are in the order of their names, as those of modules are here.
  for (const auto& [port, bits] : cell.at("connections").items()) {
    if (made.kind == Cell::Kind::kRegister && port == "C") continue;
    const bool output =
        made.module != nullptr ? made.module->output_ports.contains(port) : port == output_of_part;
    put(output ? made.outputs : made.inputs, bits);
  }
  module.cells.push_back(std::move(made));
}

void connect(Module& module) {
  int last = 0;
  const auto see = [&last](const std::vector<int>& nets) {
    for (const int net : nets) last = std::max(last, net);
  };
  see(module.inputs);
  see(module.outputs);
  for (const Cell& cell : module.cells) see(cell.inputs), see(cell.outputs);
  module.drivers.resize(static_cast<std::size_t>(last) + 1);
  for (std::size_t c = 0; c < module.cells.size(); ++c)
    for (std::size_t o = 0; o < module.cells[c].outputs.size(); ++o)
      if (const int net = module.cells[c].outputs[o]; net != kConstant)
        module.drivers[static_cast<std::size_t>(net)] = {static_cast<int>(c), static_cast<int>(o)};
}

/// When the nets of a module settle, for inputs that settle at given times.
class Arrivals {
 public:
  using Times = std::vector<double>;

  explicit Arrivals(const Delays& delays) : delays_(delays) {}

  /// Those of the outputs. Longest way of all: longest().
  const Times& outputs(const Module& module, const Times& inputs) {
    Times& result = known_[&module][inputs];
    if (!result.empty() || module.outputs.empty()) return result;
    Walk walk{module, Times(module.drivers.size(), kUnknown), {}};
    walk.cells.resize(module.cells.size());
    for (std::size_t i = 0; i < inputs.size(); ++i)
      walk.nets[static_cast<std::size_t>(module.inputs[i])] = inputs[i];
    for (const Cell& cell : module.cells)
      if (cell.kind == Cell::Kind::kRegister) see(latest(walk, cell.inputs));
    for (const int net : module.outputs) result.push_back(see(at(walk, net)));
    return result;
  }
  double longest() const { return longest_; }

 private:
  static constexpr double kUnknown = -1, kOpen = -2;

  struct Walk {
    const Module& module;
    Times nets;
    std::vector<Times> cells;  // outputs of the modules within
  };

  double see(double time) {
    longest_ = std::max(longest_, time);
    return time;
  }

  double latest(Walk& walk, const std::vector<int>& nets) {
    double time = 0;
    for (const int net : nets) time = std::max(time, at(walk, net));
    return time;
  }

  double at(Walk& walk, int net) {
    if (net == kConstant) return 0;
    const double known = walk.nets[static_cast<std::size_t>(net)];
    if (known == kOpen) throw std::runtime_error("a loop of gates");
    if (known != kUnknown) return known;
    walk.nets[static_cast<std::size_t>(net)] = kOpen;
    const double time = driven(walk, walk.module.drivers[static_cast<std::size_t>(net)]);
    return walk.nets[static_cast<std::size_t>(net)] = time;
  }

  double driven(Walk& walk, const Driver& driver) {
    if (driver.cell < 0) return 0;
    const Cell& cell = walk.module.cells[static_cast<std::size_t>(driver.cell)];
    switch (cell.kind) {
      case Cell::Kind::kRegister:
        return 0;
      case Cell::Kind::kGate:
        return latest(walk, cell.inputs) + cell.levels * delays_.gate;
      case Cell::Kind::kRamRead:
        return latest(walk, cell.inputs) + delays_.ram;
      case Cell::Kind::kModule:
        break;
    }
    Times& times = walk.cells[static_cast<std::size_t>(driver.cell)];
    if (times.empty()) {
      Times inputs;
      for (const int net : cell.inputs) inputs.push_back(at(walk, net));
      times = outputs(*cell.module, inputs);
    }
    return times[static_cast<std::size_t>(driver.output)];
  }

  Delays delays_;
  std::map<const Module*, std::map<Times, Times>> known_;
  double longest_ = 0;
};

// The module's name in the source.
std::string source_name(const std::string& name, const Json& module) {
  const Json& attributes = module.at("attributes");
  std::string text =
      attributes.contains("hdlname") ? attributes.at("hdlname").get<std::string>() : name;
  if (!text.empty() && text.front() == '\\') text.erase(0, 1);
  return text;
}

}  // namespace

std::uint64_t Inventory::gate_count() const {
  std::uint64_t count = 0;
  for (const auto& [name, number] : gates) count += number;
  return count;
}

std::uint64_t Inventory::packages() const {
  std::uint64_t count = ram_packages + packages_for(flip_flops, kFlipFlopsPerPackage);
  for (const auto& [name, number] : gates)
    count += packages_for(number, find_part(name)->per_package);
  return count;
}

struct Netlist::Modules {
  std::map<std::string, Module> by_name;
  std::map<std::string, std::string> names;  // by the name in the source

  const Module& find(const std::string& module) const {
    const auto found = names.find(module);
    if (found == names.end()) throw std::runtime_error("no module " + module);
    return by_name.at(found->second);
  }
};

Netlist::Netlist(const std::string& json) : modules_(std::make_unique<Modules>()) {
  try {
    const Json all = Json::parse(json).at("modules");
    for (const auto& [name, module] : all.items()) {
      Module& made = modules_->by_name[name];
      modules_->names[source_name(name, module)] = name;
      for (const auto& [port, description] : module.at("ports").items()) {
        const bool output = description.at("direction") == "output";
        if (output) made.output_ports.insert(port);
        std::vector<int>& to = output ? made.outputs : made.inputs;
        const std::vector<int> bits = nets(description.at("bits"));
        to.insert(to.end(), bits.begin(), bits.end());
      }
    }
    for (const auto& [name, module] : all.items()) {
      Module& made = modules_->by_name.at(name);
      for (const auto& [cell_name, cell] : module.at("cells").items())
        add_cell(cell, modules_->by_name, made);
      connect(made);
    }
  } catch (const Json::exception& error) {
    throw std::runtime_error(std::string("no netlist of Yosys: ") + error.what());
  }
}

Netlist::~Netlist() = default;
Netlist::Netlist(Netlist&&) noexcept = default;

Inventory Netlist::inventory(const std::string& module) const {
  std::map<const Module*, Inventory> known;
  const auto sum = [&known](const auto& self, const Module& of) -> const Inventory& {
    const auto [found, fresh] = known.try_emplace(&of, of.own);
    if (fresh)
      for (const Cell& cell : of.cells)
        if (cell.module != nullptr) add(found->second, self(self, *cell.module));
    return found->second;
  };
  return sum(sum, modules_->find(module));
}

double Netlist::longest_way(const std::string& module, const Delays& delays) const {
  const Module& top = modules_->find(module);
  Arrivals arrivals(delays);
  arrivals.outputs(top, std::vector<double>(top.inputs.size(), 0));
  return arrivals.longest();
}

}  // namespace cigsim::gates
