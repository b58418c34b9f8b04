// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string_view>

#include "sim/arguments.hpp"
#include "sim/stability/decision.hpp"

namespace cigsim::stability {
namespace {

constexpr std::string_view kWords = "machine:";

// machine:C,D,Q,R, each within the range of a machine description.
Format words_named(const std::string& name) {
  std::vector<std::string> parts;
  std::istringstream text(name.substr(kWords.size()));
  for (std::string part; std::getline(text, part, ',');) parts.push_back(part);
  if (parts.size() != 4)
    throw UsageError("--format: '" + name +
                     "' is not machine:C,D,Q,R: bits of a coordinate, and fraction bits of "
                     "directions, quotients and raster places");
  Format format{name, Arithmetic::kMachine, machine_preset("unlimited")};
  const auto bits = [&](std::size_t i, std::uint64_t low, std::uint64_t high) {
    return static_cast<int>(parse_whole("--format " + name, parts[i], low, high));
  };
  format.machine.formats = {bits(0, 16, 31), bits(1, 12, 30), bits(2, 8, 30), bits(3, 4, 18)};
  if (format.machine.formats.quotient_fraction % 2 != 0)
    throw UsageError("--format: '" + name +
                     "': the divider yields two bits a cycle, so that a quotient has an even "
                     "number of bits");
  return format;
}

bool is_preset(const std::string& name) {
  const std::vector<std::string>& presets = machine_presets();
  return std::find(presets.begin(), presets.end(), name) != presets.end();
}

}  // namespace

Format format_named(const std::string& name) {
  if (name == "float") return {name, Arithmetic::kFloat, {}};
  if (name == "double") return {name, Arithmetic::kDouble, {}};
  if (name == "certified") return {name, Arithmetic::kCertified, {}};
  if (name == "exact") return {name, Arithmetic::kExact, {}};
  if (name.starts_with(kWords)) return words_named(name);
  if (name == "machine") return {name, Arithmetic::kMachine, machine_preset("unlimited")};
  if (!std::filesystem::exists(name) && !is_preset(name))
    throw UsageError("--format: '" + name +
                     "' is none; choose from float, double, certified, exact, machine, a machine's "
                     "preset or file, and machine:C,D,Q,R");
  return {name, Arithmetic::kMachine, load_machine(name)};
}

std::vector<Format> usual_formats() {
  std::vector<Format> formats;
  for (const char* name : {"float", "double", "certified", "exact", "machine", "nasa1968"})
    formats.push_back(format_named(name));
  return formats;
}

}  // namespace cigsim::stability
