// SPDX-License-Identifier: MIT
#include "sim/measure/picture_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "sim/measure/distance_transform.hpp"

namespace cigsim {
namespace {

// Elements beside which the object or the colour changes.
std::vector<std::uint8_t> edge_elements(const Picture& picture) {
  const auto w = static_cast<std::size_t>(picture.width);
  std::vector<std::uint8_t> edge(picture.numbers.size());
  const auto part = [&](std::size_t a, std::size_t b) {
    if (picture.numbers[a] == picture.numbers[b] && picture.colours[a] == picture.colours[b])
      return;
    edge[a] = edge[b] = 1;
  };
  for (std::size_t i = 0; i < edge.size(); ++i) {
    if ((i + 1) % w != 0) part(i, i + 1);
    if (i + w < edge.size()) part(i, i + w);
  }
  return edge;
}

// For each of `to` elements that of `from` which holds the place of its centre.
std::vector<std::size_t> mapped(int from, int to) {
  std::vector<std::size_t> places;
  const auto f = static_cast<std::size_t>(from), t = static_cast<std::size_t>(to);
  for (std::size_t i = 0; i < t; ++i) places.push_back((2 * i + 1) * f / (2 * t));
  return places;
}

void compare_colours(std::uint32_t a, std::uint32_t b, PictureError& error) {
  if (a == b) return;
  ++error.wrong_colours;
  for (int shift = 0; shift < 24; shift += 8) {
    const auto difference = static_cast<std::uint32_t>(
        std::abs(static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255)));
    error.colour_sum += difference;
    error.worst_colour = std::max(error.worst_colour, difference);
  }
}

}  // namespace

ReferencePicture reference_picture(Picture picture) {
  ReferencePicture reference;
  reference.squared_distance =
      squared_distances(edge_elements(picture), picture.width, picture.height);
  const auto w = static_cast<std::uint32_t>(picture.width),
             h = static_cast<std::uint32_t>(picture.height);
  for (std::uint32_t& distance : reference.squared_distance)
    if (distance == kNoDistance) distance = w * w + h * h;
  reference.picture = std::move(picture);
  return reference;
}

PictureError& PictureError::operator+=(const PictureError& other) {
  pictures += other.pictures;
  elements += other.elements;
  wrong += other.wrong;
  worst_distance = std::max(worst_distance, other.worst_distance);
  wrong_colours += other.wrong_colours;
  colour_sum += other.colour_sum;
  worst_colour = std::max(worst_colour, other.worst_colour);
  worst_share = std::max(worst_share, other.worst_share);
  worst_mean_colour = std::max(worst_mean_colour, other.worst_mean_colour);
  return *this;
}

PictureError picture_error(const Picture& picture, const ReferencePicture& reference) {
  const Picture& right = reference.picture;
  const std::vector<std::size_t> columns = mapped(picture.width, right.width),
                                 rows = mapped(picture.height, right.height);
  PictureError error;
  error.pictures = 1;
  error.elements = right.numbers.size();
  std::uint32_t worst = 0;
  for (std::size_t r = 0, i = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < columns.size(); ++c, ++i) {
      const std::size_t at = rows[r] * static_cast<std::size_t>(picture.width) + columns[c];
      compare_colours(picture.colours[at], right.colours[i], error);
      if (picture.numbers[at] == right.numbers[i]) continue;
      ++error.wrong;
      worst = std::max(worst, reference.squared_distance[i]);
    }
  error.worst_distance = std::sqrt(static_cast<double>(worst));
  error.worst_share = error.share();
  error.worst_mean_colour = error.mean_colour();
  return error;
}

nlohmann::ordered_json picture_error_json(const PictureError& error) {
  return {{"elements", error.elements},
          {"wrong", error.wrong},
          {"share", error.share()},
          {"worst_share", error.worst_share},
          {"worst_distance", error.worst_distance},
          {"colour",
           {{"wrong", error.wrong_colours},
            {"share", error.colour_share()},
            {"mean", error.mean_colour()},
            {"worst_mean", error.worst_mean_colour},
            {"worst", error.worst_colour}}}};
}

}  // namespace cigsim
