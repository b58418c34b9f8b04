// SPDX-License-Identifier: MIT
// The separating-object matrix told plane by plane, on signs and not on words (Levine 1975, ch.
// VI.E): what golden model and RTL are held against.
#pragma once

#include <string>
#include <vector>

#include "models/priority_processor/so_golden.hpp"

namespace cigsim {

/// A row an object, a sign a plane: '+', '-', or '0' where the plane tells nothing.
using SignRows = std::vector<std::string>;

/// '+' l may hide m, '-' m may hide l, '0' neither can, '?' no plane parts them. `eye` has signs.
inline char so_of(const SignRows& sepl, const std::string& eye, unsigned l, unsigned m) {
  bool l_may = false, m_may = false;
  for (std::size_t plane = 0; plane < eye.size(); ++plane) {
    const char of_l = sepl[l][plane], of_m = sepl[m][plane];
    if (of_l == '0' || of_m == '0' || of_l == of_m) continue;
    (of_l == eye[plane] ? l_may : m_may) = true;
  }
  if (l_may) return m_may ? '0' : '+';
  return m_may ? '-' : '?';
}

/// A row of the matrix. '.' for the object itself, and wherever one of the two is not active.
inline std::string so_row_of(const SignRows& sepl, const std::string& eye,
                             const std::vector<bool>& active, unsigned l) {
  std::string row(sepl.size(), '.');
  for (unsigned m = 0; m < sepl.size(); ++m)
    if (m != l && active[l] && active[m]) row[m] = so_of(sepl, eye, l, m);
  return row;
}

inline bool bit_of(const priority_processor::SoBits& bits, unsigned n) {
  return bits[n / 64] >> n % 64 & 1;
}

inline SignRows signs_of(const std::vector<priority_processor::SoRow>& rows, unsigned planes) {
  SignRows sepl;
  for (const priority_processor::SoRow& row : rows) {
    sepl.emplace_back();
    for (unsigned n = 0; n < planes; ++n)
      sepl.back() += !bit_of(row.tells, n) ? '0' : bit_of(row.plus, n) ? '+' : '-';
  }
  return sepl;
}

inline std::string signs_of(const priority_processor::SoBits& eye, unsigned planes) {
  std::string signs;
  for (unsigned n = 0; n < planes; ++n) signs += bit_of(eye, n) ? '+' : '-';
  return signs;
}

inline priority_processor::SoRow row_of(const std::string& signs) {
  priority_processor::SoRow row;
  for (std::size_t n = 0; n < signs.size(); ++n) {
    row.tells[n / 64] |= std::uint64_t{signs[n] != '0'} << n % 64;
    row.plus[n / 64] |= std::uint64_t{signs[n] == '+'} << n % 64;
  }
  return row;
}

inline priority_processor::SoBits bits_of(const std::string& eye) { return row_of(eye).plus; }

}  // namespace cigsim
