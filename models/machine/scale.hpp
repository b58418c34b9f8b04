// SPDX-License-Identifier: MIT
// From the environment's doubles to machine words (docs/machine.md, "Machine words").
#pragma once

#include "models/boundary/words.hpp"
#include "models/database/database.hpp"
#include "models/numeric/machine_word.hpp"

namespace cigsim {

/// The power of two by which coordinates of a database are multiplied: the largest for which all of
/// its coordinates keep to half the range of a coordinate word, and an eyepoint to the whole whose
/// coordinates go up to `eye_reach` either way (environment units; 0: nothing is known of it).
int coordinate_scale(const Database& database, const WordFormats& formats, double eye_reach = 0);

/// The word of a coordinate, to nearest, halves up; saturates.
Word coordinate_word(double value, int scale, const WordFormats& formats, std::uint64_t& overflows);

/// The 1.30 word of a number in -1..1, to nearest, halves up.
Word direction_word(double value, const WordFormats& formats);

/// The view in machine words.
ViewWords view_words(const ViewTransform& view, int scale, const WordFormats& formats,
                     std::uint64_t& overflows);

}  // namespace cigsim
