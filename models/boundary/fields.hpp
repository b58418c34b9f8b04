// SPDX-License-Identifier: MIT
// The fields of the words on pins, by name: for waves, comparisons and faults.
#pragma once

#include <cstdint>
#include <type_traits>

#include "models/boundary/words.hpp"

namespace cigsim {

/// Calls f(name, field) for each field of a word, which may be const.
template <class Word, class F>
void for_each_field(Word& word, F&& f) {
  using Plain = std::remove_const_t<Word>;
  if constexpr (std::is_same_v<Plain, FrameWord>) {
    f("frame", word.frame);
  } else if constexpr (std::is_same_v<Plain, ItemWord>) {
    f("set", word.set);
    f("item", word.item);
    f("end", word.end);
  } else if constexpr (std::is_same_v<Plain, EdgeWord>) {
    f("face", word.face);
    f("first_line", word.first_line);
    f("end_line", word.end_line);
    f("left", word.left);
    f("end", word.end);
    f("x", word.x);
    f("slope", word.slope);
  } else if constexpr (std::is_same_v<Plain, FaceWord>) {
    f("face", word.face);
    f("object", word.object);
    f("colour", word.colour);
    f("end", word.end);
  } else if constexpr (std::is_same_v<Plain, CrossingWord>) {
    f("face", word.face);
    f("element", word.element);
    f("left", word.left);
    f("end", word.end);
    f("cut", word.cut);
  } else {
    static_assert(std::is_same_v<Plain, SpanWord>);
    f("face", word.face);
    f("first", word.first);
    f("end", word.end);
    f("last", word.last);
  }
}

/// A field as a number, sign extended.
template <class Field>
std::int64_t field_value(const Field& field) {
  return static_cast<std::int64_t>(field);
}

/// What a word ends: the line that it belongs to, or the frame of a stream without lines.
inline bool ends_stream(const FrameWord&) { return false; }
inline bool ends_stream(const ItemWord& word) { return word.end; }
inline bool ends_stream(const EdgeWord& word) { return word.end; }
inline bool ends_stream(const FaceWord& word) { return word.end; }
inline bool ends_stream(const CrossingWord& word) { return word.end; }
inline bool ends_stream(const SpanWord& word) { return word.last; }

}  // namespace cigsim
