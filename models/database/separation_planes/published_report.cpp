// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "models/database/separation_planes/published.hpp"

namespace cigsim::separation_planes {
namespace {

// FORTRAN F5.1 and I3. A value that rounds to nothing has no sign.
std::string f5_1(double value) {
  std::string text = fmt::format("{:5.1f}", value);
  if (text == " -0.0") text = "  0.0";
  return text.size() > 5 ? "*****" : text;
}
std::string i3(std::size_t value) {
  const std::string text = fmt::format("{:3}", value);
  return text.size() > 3 ? "***" : text;
}

}  // namespace

std::string published_report(const PublishedTable& table) {
  if (!table.found) return "SEPARATION PLANES COULD NOT BE FOUND.\n";
  std::string out =
      fmt::format("NUMBER OF SEPARATION PLANES REQUIRED = {}\n\n", i3(table.planes.size()));
  for (std::size_t p = 0; p < table.planes.size(); ++p) {
    const auto& [plane, candidate, pairs] = table.planes[p];
    out += fmt::format("FOR PLANE NUMBER{}\n", i3(p + 1));
    out += fmt::format("THE UNIT NORMAL IS:{}{}{}\n", f5_1(plane.normal.x), f5_1(plane.normal.y),
                       f5_1(plane.normal.z));
    out += fmt::format("AND THE DIRECTED DISTANCE IS:{}\n", f5_1(plane.distance));
    out += fmt::format("{:<43}{:<10}{}\n", "THE TRUE/FALSE PAIRS FOR THIS PLANE ARE:", "TRUE",
                       "FALSE");
    out += fmt::format("{:43}{:<10}{}\n", "", "-----", "-----");
    for (const ObjectPair& pair : pairs)
      out += fmt::format("{:44}{}{:7}{}\n", "", i3(pair.true_object), "", i3(pair.false_object));
  }
  return out + "NORMAL TERMINATION\n";
}

}  // namespace cigsim::separation_planes
