// SPDX-License-Identifier: MIT
// How wrong a picture is beside a reference: in object numbers, in how far from an edge, in colour.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "models/boundary/transactions.hpp"

namespace cigsim {

/// A right picture, and for each element the square of its distance from an edge: from the nearest
/// element that has a neighbour (left, right, above, below) of another object or colour. Without
/// any such element it is the square of the picture's diagonal.
struct ReferencePicture {
  Picture picture;
  std::vector<std::uint32_t> squared_distance;
};
ReferencePicture reference_picture(Picture picture);

/// Sums over one picture or several.
struct PictureError {
  std::uint64_t pictures = 0, elements = 0;
  std::uint64_t wrong = 0;          ///< elements with another object number
  double worst_distance = 0;        ///< of a wrong element from an edge of the reference, elements
  std::uint64_t wrong_colours = 0;  ///< elements with another colour
  std::uint64_t colour_sum = 0;     ///< of differences: red, green and blue of all elements
  std::uint32_t worst_colour = 0;   ///< largest difference of a red, green or blue, 0..255
  double worst_share = 0;           ///< of the wrong elements of one picture
  double worst_mean_colour = 0;     ///< mean_colour() of one picture

  double share() const { return of(wrong, elements); }
  double colour_share() const { return of(wrong_colours, elements); }
  /// Mean absolute difference of a red, green or blue, as a share of 255.
  double mean_colour() const { return of(colour_sum, elements * 3 * 255); }

  PictureError& operator+=(const PictureError& other);
  friend bool operator==(const PictureError&, const PictureError&) = default;

 private:
  static double of(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
  }
};

/// Of one picture. A picture on another raster is compared at the elements of the reference: the
/// element that holds the place of the reference's centre is taken. Neither may be empty.
PictureError picture_error(const Picture& picture, const ReferencePicture& reference);

/// {"elements", "wrong", "share", "worst_share", "worst_distance", "colour": {…}}
nlohmann::ordered_json picture_error_json(const PictureError& error);

}  // namespace cigsim
