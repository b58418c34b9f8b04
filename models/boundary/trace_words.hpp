// SPDX-License-Identifier: MIT
// The words on pins: as text, and field by field in waves.
#pragma once

#include <ostream>
#include <string>
#include <systemc>

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

inline void sc_trace(sc_core::sc_trace_file* file, const FrameWord& word, const std::string& name) {
  sc_core::sc_trace(file, word.frame, name + ".frame");
}
inline void sc_trace(sc_core::sc_trace_file* file, const ItemWord& word, const std::string& name) {
  sc_core::sc_trace(file, reinterpret_cast<const unsigned char&>(word.set), name + ".set", 2);
  sc_core::sc_trace(file, word.item, name + ".item");
  sc_core::sc_trace(file, word.end, name + ".end");
}
inline void sc_trace(sc_core::sc_trace_file* file, const EdgeWord& word, const std::string& name) {
  sc_core::sc_trace(file, word.face, name + ".face");
  sc_core::sc_trace(file, word.first_line, name + ".first_line");
  sc_core::sc_trace(file, word.end_line, name + ".end_line");
  sc_core::sc_trace(file, word.left, name + ".left");
  sc_core::sc_trace(file, word.end, name + ".end");
  sc_core::sc_trace(file, word.x, name + ".x");
  sc_core::sc_trace(file, word.slope, name + ".slope");
}
inline void sc_trace(sc_core::sc_trace_file* file, const FaceWord& word, const std::string& name) {
  sc_core::sc_trace(file, word.face, name + ".face");
  sc_core::sc_trace(file, word.object, name + ".object");
  sc_core::sc_trace(file, word.colour, name + ".colour");
  sc_core::sc_trace(file, word.end, name + ".end");
}
inline void sc_trace(sc_core::sc_trace_file* file, const CrossingWord& word,
                     const std::string& name) {
  sc_core::sc_trace(file, word.face, name + ".face");
  sc_core::sc_trace(file, word.element, name + ".element");
  sc_core::sc_trace(file, word.left, name + ".left");
  sc_core::sc_trace(file, word.end, name + ".end");
  sc_core::sc_trace(file, word.cut, name + ".cut");
}
inline void sc_trace(sc_core::sc_trace_file* file, const SpanWord& word, const std::string& name) {
  sc_core::sc_trace(file, word.face, name + ".face");
  sc_core::sc_trace(file, word.first, name + ".first");
  sc_core::sc_trace(file, word.end, name + ".end");
  sc_core::sc_trace(file, word.last, name + ".last");
}

}  // namespace cigsim
