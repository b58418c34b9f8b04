// SPDX-License-Identifier: MIT
#include "sim/cosim/so_cases.hpp"

#include <numeric>
#include <utility>

namespace cigsim::cosim {
namespace {

using priority_processor::SoBits;
using priority_processor::SoRow;

void set(SoBits& bits, unsigned n, bool value) {
  const std::uint64_t bit = std::uint64_t{1} << n % 64;
  bits[n / 64] = value ? bits[n / 64] | bit : bits[n / 64] & ~bit;
}

void flip(SoBits& bits, unsigned n) { bits[n / 64] ^= std::uint64_t{1} << n % 64; }

/// The lowest `count` bits.
SoBits lowest(unsigned count) {
  SoBits bits{};
  for (unsigned w = 0; w < bits.size(); ++w)
    if (count > w * 64)
      bits[w] = count >= w * 64 + 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count % 64) - 1;
  return bits;
}

/// `count` bits, each set with probability 2^-halvings.
SoBits random_bits(Random& random, unsigned count, unsigned halvings) {
  SoBits bits = lowest(count);
  for (unsigned w = 0; w * 64 < count; ++w)
    for (unsigned n = 0; n < halvings; ++n) bits[w] &= random.bits();
  return bits;
}

}  // namespace

std::vector<SoRow> random_so_rows(Random& random, SoKind kind, unsigned objects, unsigned planes) {
  std::vector<SoRow> rows(objects);
  for (SoRow& row : rows) {
    const unsigned halvings = kind == SoKind::kDense  ? 0
                              : kind == SoKind::kThin ? 2 + random.below(3)
                                                      : 1;
    row = {random_bits(random, planes, halvings), random_bits(random, planes, 1)};
  }
  switch (kind) {
    case SoKind::kEmpty:
      for (SoRow& row : rows) row.tells = {};
      break;
    case SoKind::kOnePlane: {
      SoBits plane{};
      set(plane, random.below(planes), true);
      for (SoRow& row : rows) row.tells = random.below(4) == 0 ? SoBits{} : plane;
      break;
    }
    case SoKind::kEqualRows:
      for (SoRow& row : rows) row = rows[0];
      break;
    case SoKind::kNearDuplicates:
      for (SoRow& row : rows) {
        row = rows[0];
        for (unsigned n = random.below(4); n > 0; --n) flip(row.plus, random.below(planes));
        if (random.below(4) == 0) flip(row.tells, random.below(planes));
      }
      break;
    case SoKind::kInLine: {
      std::vector<unsigned> place(objects);
      std::iota(place.begin(), place.end(), 0u);
      for (unsigned n = objects; n > 1; --n) std::swap(place[n - 1], place[random.below(n)]);
      // Plane n stands between places n and n + 1, with its plus side towards the latter.
      for (unsigned o = 0; o < objects; ++o)
        rows[o] = {lowest(planes), lowest(place[o] < planes ? place[o] : planes)};
      break;
    }
    default:
      break;
  }
  return rows;
}

SoBits random_so_eye(Random& random, unsigned planes, const SoBits& before) {
  SoBits eye = before;
  switch (random.below(4)) {
    case 0:
      return lowest(random.below(planes + 1));
    case 1:
      flip(eye, random.below(planes));
      return eye;
    default:
      return random_bits(random, planes, 1);
  }
}

SoBits random_so_active(Random& random, unsigned objects) {
  SoBits active{};
  switch (random.below(16)) {
    case 0:
      return random_bits(random, objects, 1);
    case 1:
      set(active, random.below(objects), true);
      return active;
    case 2:
      return random.below(4) == 0 ? active : random_bits(random, objects, 3);
    default:
      return lowest(objects);
  }
}

}  // namespace cigsim::cosim
