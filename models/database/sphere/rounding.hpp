// SPDX-License-Identifier: MIT
// Rationals to doubles with a stated rounding, and roots of rationals.
#pragma once

#include "models/numeric/number.hpp"

namespace cigsim {

/// The double nearest to a value that is within the range of doubles.
double nearest_double(const Exact& value);

/// The smallest double whose square is not below `value` >= 0: the root, rounded upward. Infinity
/// when that is beyond the largest double.
double root_up(const Exact& value);

/// The double nearest to the root of `value` >= 0.
double root_nearest(const Exact& value);

/// The smallest double not below a + b, both of them finite and not negative.
double sum_up(double a, double b);

}  // namespace cigsim
