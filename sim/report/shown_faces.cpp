// SPDX-License-Identifier: MIT
#include "sim/report/shown_faces.hpp"

#include <algorithm>
#include <tuple>

#include "models/video_processor/fill.hpp"

namespace cigsim {
namespace {

struct LineCrossing {
  std::uint32_t element = 0;
  bool left = false;
  std::uint32_t face = 0;
};

// The crossings of a line, EO3's order: by element, right edges first, then by face.
std::vector<std::vector<LineCrossing>> ordered_lines(const FrameFaces& faces, int height) {
  std::vector<std::vector<LineCrossing>> lines(static_cast<std::size_t>(height));
  for (std::uint32_t f = 0; f < faces.faces.size(); ++f)
    for (const FaceEdge& edge : faces.edges_of(f)) {
      const auto elements = faces.elements_of(edge);
      for (std::size_t k = 0; k < elements.size(); ++k)
        lines[static_cast<std::size_t>(edge.first_line) + k].push_back(
            {static_cast<std::uint32_t>(elements[k]), edge.left, f});
    }
  for (auto& line : lines)
    std::sort(line.begin(), line.end(), [](const LineCrossing& a, const LineCrossing& b) {
      return std::tie(a.element, a.left, a.face) < std::tie(b.element, b.left, b.face);
    });
  return lines;
}

LineLimit limit_of(const std::vector<LineCrossing>& line, std::uint32_t capacity,
                   OverloadPolicy policy) {
  if (line.size() <= capacity || policy == OverloadPolicy::kExtend) return {};
  if (policy == OverloadPolicy::kCut) return {kNone, line[capacity].element};
  std::vector<std::uint32_t> numbers;
  for (const LineCrossing& crossing : line) numbers.push_back(crossing.face);
  std::sort(numbers.begin(), numbers.end());
  return {numbers[capacity], kNone};
}

}  // namespace

void keep_first(FrameFaces& faces, std::size_t count) {
  if (count >= faces.faces.size()) return;
  faces.edges.resize(faces.faces[count].first_edge);
  faces.faces.resize(count);
}

std::vector<std::uint32_t> crossings_by_line(const FrameFaces& faces, int height) {
  std::vector<std::uint32_t> counts(static_cast<std::size_t>(height));
  for (const FaceEdge& edge : faces.edges)
    for (int r = edge.first_line; r < edge.end_line; ++r) ++counts[static_cast<std::size_t>(r)];
  return counts;
}

std::vector<LineLimit> line_limits(const FrameFaces& faces, int height, std::uint32_t capacity,
                                   OverloadPolicy policy) {
  std::vector<LineLimit> limits(static_cast<std::size_t>(height));
  if (capacity == 0) return limits;
  const auto lines = ordered_lines(faces, height);
  for (std::size_t r = 0; r < limits.size(); ++r) limits[r] = limit_of(lines[r], capacity, policy);
  return limits;
}

Picture shown_picture(const FrameFaces& faces, const std::vector<LineLimit>& limits,
                      const Colour& background, const Raster& raster) {
  Picture picture;
  picture.fit(raster);
  std::fill(picture.colours.begin(), picture.colours.end(), video_processor::packed(background));
  std::fill(picture.numbers.begin(), picture.numbers.end(), 0);
  const auto width = static_cast<std::uint32_t>(raster.width);
  // One line after the other; on it the inside state of each face (PR1), and the faces inside.
  const auto lines = ordered_lines(faces, raster.height);
  std::vector<int> state(faces.faces.size());
  std::vector<std::uint32_t> inside;  // ascending
  for (std::size_t r = 0; r < lines.size(); ++r) {
    const std::uint32_t end = std::min(width, limits[r].elements);
    std::uint32_t from = 0;
    const auto show = [&](std::uint32_t to) {
      if (from < to && !inside.empty()) {
        const RasterFace& face = faces.faces[inside.front()];
        video_processor::fill_run(picture.colours.data() + r * width + from,
                                  picture.numbers.data() + r * width + from,
                                  static_cast<int>(to - from), video_processor::packed(face.colour),
                                  video_processor::number_of(face.object));
      }
      from = std::max(from, to);
    };
    for (const LineCrossing& crossing : lines[r]) {
      if (crossing.face >= limits[r].faces) continue;
      show(std::min(crossing.element, end));
      int& s = state[crossing.face];
      const bool before = s == 1;
      s = crossing.left ? std::min(s + 1, 1) : std::max(s - 1, -1);
      if (before == (s == 1)) continue;
      const auto at = std::lower_bound(inside.begin(), inside.end(), crossing.face);
      if (before)
        inside.erase(at);
      else
        inside.insert(at, crossing.face);
    }
    show(end);
    for (const LineCrossing& crossing : lines[r]) state[crossing.face] = 0;
    inside.clear();
  }
  return picture;
}

}  // namespace cigsim
