// SPDX-License-Identifier: MIT
#include "models/survey/visible_surface/algorithm.hpp"

#include <algorithm>

namespace cigsim::survey {
namespace {

constexpr std::string_view kNoPenetration = "faces that pass through each other";

constexpr Algorithm kAlgorithms[] = {
    {"Warnock", "1969", "area", warnock, std::array<double, 3>{11, 64, 307}, ""},
    {"Newell", "1972", "depth first", newell, std::array<double, 3>{1, 10, 507}, ""},
    {"Schumacker", "1969", "depth first", schumacker, std::array<double, 3>{30, 179, 1215},
     kNoPenetration},
    {"Watkins", "1970", "depth last", watkins, std::nullopt, ""},
    {"Bouknight", "1970", "depth last", bouknight, std::nullopt, ""},
    {"Wylie", "1967", "depth last", wylie, std::nullopt, kNoPenetration},
    {"z-buffer", "1974", "no sort", z_buffer, std::array<double, 3>{54, 54, 54}, ""}};

std::uint32_t packed(const Colour& c) {
  return 0xff000000u | std::uint32_t{c.b} << 16 | std::uint32_t{c.g} << 8 | c.r;
}

}  // namespace

std::span<const Algorithm> algorithms() { return kAlgorithms; }

std::uint64_t differences(const FaceList& list, const FacePicture& faces, const Colour& background,
                          const Picture& picture) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < picture.numbers.size(); ++i) {
    const std::uint32_t f = faces.faces[i];
    const std::uint32_t number = f == kNone ? 0 : list.faces[f].object;
    const std::uint32_t colour = packed(f == kNone ? background : list.faces[f].colour);
    count += std::min(number, 65535u) != picture.numbers[i] || colour != picture.colours[i];
  }
  return count;
}

}  // namespace cigsim::survey
