// SPDX-License-Identifier: MIT
#include "models/environment/obj_materials.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

namespace cigsim {
namespace {

std::uint8_t level(double diffuse) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(diffuse, 0.0, 1.0)));
}

std::string rest_of(std::istringstream& words) {
  std::string rest;
  std::getline(words >> std::ws, rest);
  rest.erase(rest.find_last_not_of(" \t\r") + 1);
  return rest;
}

bool read_diffuse(std::istringstream& words, Colour& colour) {
  double c[3];
  for (double& value : c) {
    std::string word;
    words >> word;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return false;
  }
  colour = {level(c[0]), level(c[1]), level(c[2])};
  return true;
}

}  // namespace

bool read_obj_materials(const std::filesystem::path& file, ObjMaterials& materials) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  std::ifstream input(file);
  std::string line, name;
  while (std::getline(input, line)) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "newmtl") name = rest_of(words);
    Colour colour;
    if (word == "Kd" && !name.empty() && read_diffuse(words, colour)) materials[name] = colour;
  }
  return input.eof();
}

std::optional<Colour> colour_of_name(std::string_view material) {
  if (material.size() != 10 || material.substr(0, 4) != "rgb_") return std::nullopt;
  std::uint32_t value = 0;
  const char* end = material.data() + material.size();
  const auto [stop, error] = std::from_chars(material.data() + 4, end, value, 16);
  if (error != std::errc() || stop != end) return std::nullopt;
  return Colour{static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
                static_cast<std::uint8_t>(value)};
}

}  // namespace cigsim
