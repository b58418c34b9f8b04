// SPDX-License-Identifier: MIT
#include "sim/bsp/part_names.hpp"

namespace cigsim {

std::vector<std::string> part_names(const BspTree& tree) {
  std::vector<std::uint32_t> parts(tree.polygons), named(tree.polygons);
  for (const std::uint32_t item : tree.members) ++parts[tree.polygon(item).origin.order];
  std::vector<std::string> names;
  names.reserve(tree.members.size());
  for (const std::uint32_t item : tree.members) {
    const std::uint32_t order = tree.polygon(item).origin.order;
    const bool letters = tree.polygons <= 26;
    std::string name;
    if (letters)
      name.push_back(static_cast<char>('A' + order));
    else
      name = std::to_string(order + 1);
    if (parts[order] > 1) {
      if (!letters) name.push_back('.');
      name += std::to_string(++named[order]);
    }
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace cigsim
