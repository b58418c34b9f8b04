// SPDX-License-Identifier: MIT
#include "sim/cards_screen.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "sim/arguments.hpp"
#include "sim/drawing/svg.hpp"

namespace cigsim {
namespace {

using hidden_line::DrawnEdge;
using hidden_line::HiddenEdges;

constexpr double kSheet = 600;

// Cuts a line at the square -1 to 1; false when nothing is left.
bool cut(Vec2& from, Vec2& to) {
  const Vec2 d{to.x - from.x, to.y - from.y};
  double low = 0, high = 1;
  const auto keep = [&](double at, double slope) {  // at + slope t >= 0
    if (slope == 0) return at >= 0;
    const double t = -at / slope;
    (slope > 0 ? low : high) = slope > 0 ? std::max(low, t) : std::min(high, t);
    return true;
  };
  if (!keep(from.x + 1, d.x) || !keep(1 - from.x, -d.x) || !keep(from.y + 1, d.y) ||
      !keep(1 - from.y, -d.y) || low > high)
    return false;
  const auto place = [&](double t) -> Vec2 {
    return {std::clamp(from.x + d.x * t, -1.0, 1.0), std::clamp(from.y + d.y * t, -1.0, 1.0)};
  };
  const Vec2 a = place(low), b = place(high);
  from = a;
  to = b;
  return true;
}

template <class Draw>
void for_each_line(const HiddenEdges& edges, Draw draw) {
  for (const DrawnEdge& edge : edges.drawn) {
    Vec2 from = edge.from, to = edge.to;
    if (cut(from, to)) draw(from, to);
  }
}

}  // namespace

std::string cards_svg(const HiddenEdges& edges, std::string_view title) {
  SvgDrawing drawing(kSheet, kSheet, title);
  const auto pixel = [](const Vec2& p) -> Vec2 {
    return {(p.x + 1) * kSheet / 2, (1 - p.y) * kSheet / 2};
  };
  for_each_line(edges,
                [&](const Vec2& from, const Vec2& to) { drawing.line(pixel(from), pixel(to)); });
  return drawing.svg();
}

std::string cards_dots(const HiddenEdges& edges, int columns, int rows) {
  const int side = std::min(columns * 2, rows * 4);  // dots are about square
  std::vector<unsigned char> cells(static_cast<std::size_t>(columns) * rows, 0);
  constexpr unsigned char kDots[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
  for_each_line(edges, [&](const Vec2& from, const Vec2& to) {
    const double reach = (side - 1) / 2.0;
    const int steps =
        1 + static_cast<int>(std::max(std::abs(to.x - from.x), std::abs(to.y - from.y)) * reach);
    for (int s = 0; s <= steps; ++s) {
      const double t = static_cast<double>(s) / steps;
      const int x = static_cast<int>(std::lround((from.x + (to.x - from.x) * t + 1) * reach)) +
                    (columns * 2 - side) / 2;
      const int y = static_cast<int>(std::lround((1 - from.y - (to.y - from.y) * t) * reach));
      cells[static_cast<std::size_t>(y / 4) * columns + x / 2] |= kDots[y % 4][x % 2];
    }
  });
  std::string out;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    // U+2800 and the dots, in UTF-8.
    out += "\xe2";
    out += static_cast<char>(0xa0 | cells[i] >> 6);
    out += static_cast<char>(0x80 | (cells[i] & 0x3f));
    if ((i + 1) % static_cast<std::size_t>(columns) == 0) out += "\r\n";
  }
  return out;
}

struct LiveTerminal::State {
  termios before;
};

LiveTerminal::LiveTerminal() : state_(new State) {
  if (!isatty(STDIN_FILENO) || !isatty(STDOUT_FILENO) ||
      tcgetattr(STDIN_FILENO, &state_->before) != 0) {
    delete state_;
    throw UsageError("--live needs a terminal for input and output; use --keys FILE without one");
  }
  termios raw = state_->before;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);  // Ctrl-C still interrupts
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 0;
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
    columns_ = size.ws_col;
    rows_ = size.ws_row;
  }
  std::fputs("\x1b[?25l\x1b[2J", stdout);
}

LiveTerminal::~LiveTerminal() {
  std::fputs("\x1b[?25h\n", stdout);
  std::fflush(stdout);
  tcsetattr(STDIN_FILENO, TCSANOW, &state_->before);
  delete state_;
}

int LiveTerminal::key(int ms) {
  pollfd wait{STDIN_FILENO, POLLIN, 0};
  if (poll(&wait, 1, ms) <= 0) return kNothing;
  char typed[8] = {};
  const ssize_t n = read(STDIN_FILENO, typed, sizeof typed - 1);
  if (n <= 0) return kQuit;
  const std::string_view text(typed, static_cast<std::size_t>(n));
  if (text == "\x1b[C" || text == "\x1bOC") return 3;
  if (text == "\x1b[D" || text == "\x1bOD") return 4;
  if (text == "\x1b[A" || text == "\x1bOA") return 6;
  if (text == "\x1b[B" || text == "\x1bOB") return 7;
  switch (typed[0]) {
    case ' ':
      return 2;
    case 't':
      return 5;
    case 'p':
      return 8;
    case 'f':
      return 9;
    case 'n':
      return 10;
    case 'r':
      return 11;
    case '+':
      return 12;
    case '-':
      return 13;
    case 'd':
      return 14;
    case 'q':
      return kQuit;
    default:
      return kNothing;
  }
}

void LiveTerminal::show(const std::string& picture, const std::string& status) {
  std::fputs("\x1b[H", stdout);
  std::fputs(picture.c_str(), stdout);
  std::fputs(status.c_str(), stdout);
  std::fputs("\x1b[K", stdout);
  std::fflush(stdout);
}

const char* LiveTerminal::legend() {
  return "Right, Left: theta +2, -2 degrees a picture (keys 3, 4); t stops it (5)\n"
         "Up, Down: phi +2, -2 (6, 7); p stops it (8)\n"
         "f, n: farther, nearer by 0.25 (9, 10); r stops it (11)\n"
         "+, -: view plane out, in by 0.2 (12, 13); d stops it (14)\n"
         "Space: stops all (2); q: ends\n";
}

}  // namespace cigsim
