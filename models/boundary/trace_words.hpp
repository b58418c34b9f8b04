// SPDX-License-Identifier: MIT
// The words on pins: as text, and field by field in waves.
#pragma once

#include <ostream>
#include <string>
#include <systemc>
#include <type_traits>

#include "models/boundary/fields.hpp"
#include "models/boundary/words.hpp"

namespace cigsim {

inline std::ostream& operator<<(std::ostream& out, const FrameWord& word) {
  return out << "frame " << word.frame;
}
inline std::ostream& operator<<(std::ostream& out, const ItemWord& word) {
  if (word.end) return out << "end";
  return out << "set " << static_cast<int>(word.set) << " item " << word.item;
}
inline std::ostream& operator<<(std::ostream& out, const EdgeWord& word) {
  if (word.end) return out << "end";
  return out << "face " << word.face << " lines " << word.first_line << ".." << word.end_line
             << (word.left ? " left" : " right") << " x " << word.x << " slope " << word.slope;
}
inline std::ostream& operator<<(std::ostream& out, const FaceWord& word) {
  if (word.end) return out << "end";
  return out << "face " << word.face << " object " << word.object << " colour " << word.colour;
}
inline std::ostream& operator<<(std::ostream& out, const CrossingWord& word) {
  if (word.cut) return out << "end, cut at " << word.element;
  if (word.end) return out << "end";
  return out << "face " << word.face << " element " << word.element
             << (word.left ? " left" : " right");
}
inline std::ostream& operator<<(std::ostream& out, const SpanWord& word) {
  out << "face ";
  if (word.face == kNone)
    out << "none";
  else
    out << word.face;
  return out << " elements " << word.first << ".." << word.end << (word.last ? " last" : "");
}

template <class Word>
void trace_fields(sc_core::sc_trace_file* file, const Word& word, const std::string& name) {
  for_each_field(word, [&](const char* field, const auto& value) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, SetId>)
      sc_core::sc_trace(file, reinterpret_cast<const unsigned char&>(value), name + "." + field, 2);
    else
      sc_core::sc_trace(file, value, name + "." + field);
  });
}

inline void sc_trace(sc_core::sc_trace_file* file, const FrameWord& word, const std::string& name) {
  trace_fields(file, word, name);
}
inline void sc_trace(sc_core::sc_trace_file* file, const ItemWord& word, const std::string& name) {
  trace_fields(file, word, name);
}
inline void sc_trace(sc_core::sc_trace_file* file, const EdgeWord& word, const std::string& name) {
  trace_fields(file, word, name);
}
inline void sc_trace(sc_core::sc_trace_file* file, const FaceWord& word, const std::string& name) {
  trace_fields(file, word, name);
}
inline void sc_trace(sc_core::sc_trace_file* file, const CrossingWord& word,
                     const std::string& name) {
  trace_fields(file, word, name);
}
inline void sc_trace(sc_core::sc_trace_file* file, const SpanWord& word, const std::string& name) {
  trace_fields(file, word, name);
}

}  // namespace cigsim
