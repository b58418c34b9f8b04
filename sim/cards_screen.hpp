// SPDX-License-Identifier: MIT
// Pictures of Pfister's decks: as SVG, and as dots in a terminal that is typed at.
#pragma once

#include <string>
#include <string_view>

#include "models/hidden_line/galimberti_montanari.hpp"

namespace cigsim {

/// His screen: -1 to 1 both ways, 600 x 600 pixels; lines are cut at its border.
std::string cards_svg(const hidden_line::HiddenEdges& edges, std::string_view title);

/// The same in dots of Braille characters, two by four a character: `rows` lines of `columns`
/// characters, each ended by a carriage return and a line feed.
std::string cards_dots(const hidden_line::HiddenEdges& edges, int columns, int rows);

/// The terminal of standard input without line editing and echo, its cursor hidden, for as long as
/// one exists. Throws UsageError when standard input or output is no terminal.
class LiveTerminal {
 public:
  LiveTerminal();
  ~LiveTerminal();
  LiveTerminal(const LiveTerminal&) = delete;
  LiveTerminal& operator=(const LiveTerminal&) = delete;

  static constexpr int kNothing = 0, kQuit = -1;
  /// Waits at most `ms`; a function key 2 to 14, kQuit, or kNothing.
  int key(int ms);
  void show(const std::string& picture, const std::string& status);
  int columns() const { return columns_; }
  int rows() const { return rows_; }

  /// What to type for which key.
  static const char* legend();

 private:
  struct State;
  State* state_;
  int columns_ = 80, rows_ = 24;
};

}  // namespace cigsim
