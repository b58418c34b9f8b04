// SPDX-License-Identifier: MIT
// The envelope of a number format: how large, how far from the origin, on how many lines, how near
// and how far away a scene may be seen so that the format takes no wrong decision. Found by search,
// not by a formula; a formula's prediction stands beside it where there is one.
//
// A wrong decision is what FrameFaults::any() says of a frame: an object number that differs
// further than half an element from every edge of the two objects, a wrong place in the priority
// list, a front face taken for a back face or the reverse. The referee is exact arithmetic on the
// same doubles.
//
// The axes of the search are what a user changes (the scene's scale, its offset, the raster, how
// near and how far the eyepoint stands); along each, seeded worlds are prepared and seen anew and
// judged in every format, all else staying benign. A limit is one of a quantity (Measures) that the
// frames themselves have, so that it can be held against any other scene: `demand`, for one, is
// the elements that the largest coordinate would span at the distance of the nearest face, and so
// means the same whether offset, raster, field of view or nearness made it large; `cut` is the
// same of the nearest face that the pyramid of vision cuts, as it does ground below the eyepoint.
// Of `clearance` only decisions count, of all others pictures too. The limit of a quantity is the
// last value at which every frame was right, before the first one that was wrong; a frame outside
// of a limit that was found earlier (in the order of Quantity) says nothing of later ones.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/stability/frame_judge.hpp"
#include "sim/stability/measures.hpp"

namespace cigsim::stability {

/// In the order in which limits are found.
enum class Quantity : std::uint8_t {
  kLines,
  kClearance,
  kSmallest,
  kLargest,
  kDemand,
  kNearness,
  kCut
};
inline constexpr std::size_t kQuantities = 7;

struct QuantityName {
  Quantity quantity;
  const char *name, *what;
  double Measures::*field;
  bool least;  ///< the limit is the least value allowed, not the most
};
/// By Quantity.
const std::array<QuantityName, kQuantities>& quantity_names();

/// A frame in which a format went wrong, so that one can repeat it.
struct EnvelopeFailure {
  std::string world, axis;
  int step = 0, view = 0;  ///< with the seed they give the instance
  double value = 0;        ///< of the quantity
  FrameFaults faults;
};

/// Of one quantity in one format.
struct EnvelopeLimit {
  bool searched = false;        ///< some frame inside of all earlier limits was looked at
  std::optional<double> value;  ///< every frame up to here was right; none: not even the first
  double reached = 0;           ///< the most extreme value that was looked at
  std::optional<EnvelopeFailure> failure;  ///< the first wrong one; none: all were right
  std::optional<double> predicted;         ///< by the formula of predicted_limit()
};

/// A format with its limits, by Quantity.
struct Envelope {
  Format format;
  std::array<EnvelopeLimit, kQuantities> limits;
  std::uint64_t frames = 0, wrong = 0;  ///< judged; at fault

  const EnvelopeLimit& limit(Quantity q) const { return limits[static_cast<std::size_t>(q)]; }
};

struct EnvelopeOptions {
  std::uint64_t seed = 1;
  int views = 4;          ///< of each world at each step, at least 1; more where it is worth it
  int stride = 1;         ///< 1: every step of an axis; more: every so many-th, a coarse search
  int most_lines = 2048;  ///< the largest raster, 16..16384
  bool airfield = true;   ///< the built-in scene besides the generated worlds
  std::vector<Format> formats;
  std::function<void(double)> progress;  ///< is told the share that is done
};

/// float, double, certified, and the words of the presets nasa1968, asupt1975 and unlimited. Exact
/// numbers are the referee.
std::vector<Format> searched_formats();

/// Whatever they are called.
bool same_numbers(const Format& a, const Format& b);

/// In the order of the formats. Deterministic, whatever the host.
std::vector<Envelope> search_envelope(const EnvelopeOptions& options);

/// What a plain error analysis gives for a limit, or nothing: with u the unit of the largest
/// coordinate that the format keeps (2^-24 for float, 2^-53 for double, 2^-(coordinate_bits - 2) on
/// machine words), a projected place is wrong by about 4 u · demand elements and a height by about
/// 4 u of the largest coordinate; a slope of f fraction bits is wrong by 2^-(f + 1) a line; the
/// products of a side test are of the third power of a length, and floats end at 2^128 and 2^-126.
std::optional<double> predicted_limit(const Format& format, Quantity quantity);

}  // namespace cigsim::stability
