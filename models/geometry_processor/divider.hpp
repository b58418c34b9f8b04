// SPDX-License-Identifier: MIT
// The geometry processor's divider: restoring, two bits a clock, on magnitudes with the sign apart
// (docs/machine/geometry_processor.md, GP7 and GP13).
#pragma once

#include <cassert>
#include <cstdint>

#include "models/geometry_processor/program.hpp"

namespace cigsim::geometry_processor {

class Divider {
 public:
  explicit Divider(const WordFormats& formats) : formats_(formats) {}

  /// num / den in 1.30. What a machine gives for |num| > den, or den <= 0, is of no use; here 1.
  void begin_quotient(std::int64_t num, std::int64_t den) {
    const int bits = formats_.quotient_fraction;
    const std::uint64_t size = magnitude(num);
    std::uint64_t value = std::uint64_t{1} << bits;
    if (den > 0 && size < static_cast<std::uint64_t>(den))
      value = bits_of(size, static_cast<std::uint64_t>(den), bits);
    begin(num < 0, value << (kQuotientFraction - bits), quotient_clocks(formats_));
  }

  /// num / den in 13.18, rounded on the magnitude. Of no use unless den exceeds one line; then 0.
  void begin_slope(std::int64_t num, std::int64_t den) {
    constexpr int kWhole = 13;
    const int bits = kWhole + formats_.raster_fraction + 1;
    const std::uint64_t size = magnitude(num);
    const std::uint64_t divisor = den > 0 ? static_cast<std::uint64_t>(den) << kWhole : 0;
    std::uint64_t value = 0;
    if (size < divisor) value = (bits_of(size, divisor, bits) + 1) / 2;
    begin(num < 0, value << (kRasterFraction - formats_.raster_fraction), slope_clocks(formats_));
  }

  /// A clock goes by.
  void step() {
    if (left_ > 0) --left_;
  }

  /// Not before the division is over.
  std::int64_t result() const {
    assert(left_ == 0);
    return result_;
  }
  /// For waves.
  const std::int64_t& result_register() const { return result_; }
  const int& clocks_left() const { return left_; }

 private:
  static std::uint64_t magnitude(std::int64_t value) {
    return static_cast<std::uint64_t>(value < 0 ? -value : value);
  }
  static std::uint64_t bits_of(std::uint64_t rest, std::uint64_t divisor, int bits) {
    std::uint64_t value = 0;
    for (int i = 0; i < bits; ++i) {
      rest <<= 1;
      const bool one = rest >= divisor;
      rest -= one ? divisor : 0;
      value = value << 1 | one;
    }
    return value;
  }
  void begin(bool negative, std::uint64_t value, int clocks) {
    result_ = negative ? -static_cast<std::int64_t>(value) : static_cast<std::int64_t>(value);
    left_ = clocks;
  }

  WordFormats formats_;
  std::int64_t result_ = 0;
  int left_ = 0;
};

}  // namespace cigsim::geometry_processor
