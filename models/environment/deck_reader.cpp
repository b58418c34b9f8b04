// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "models/environment/deck.hpp"
#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"
#include "models/numeric/plane.hpp"

namespace cigsim {
namespace {

/// The columns `first` to `last` of a card, from 1; shorter cards end in blanks.
std::string_view columns(std::string_view card, std::size_t first, std::size_t last) {
  if (card.size() < first) return {};
  return card.substr(first - 1, last - first + 1);
}

bool blank(std::string_view text) { return text.find_first_not_of(' ') == std::string_view::npos; }

std::string without_blanks(std::string_view field) {
  std::string text(field);
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  return text;
}

/// FORTRAN I: an optional sign and digits, blank is 0.
std::optional<int> fortran_integer(std::string_view field) {
  std::string text = without_blanks(field);
  if (text.empty()) return 0;
  if (text[0] == '+') text.erase(0, 1);
  int value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

bool all_digits(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// FORTRAN F8.2: digits with an optional sign, point and exponent (E, D or its sign alone); without
/// a point the last two digits are decimals. Blank is 0.
std::optional<double> fortran_real(std::string_view field) {
  const std::string text = without_blanks(field);
  if (text.empty()) return 0.0;
  const std::size_t sign = text[0] == '+' || text[0] == '-';
  const std::size_t mantissa_end =
      std::min(text.find_first_not_of("0123456789.", sign), text.size());
  const std::string mantissa = text.substr(sign, mantissa_end - sign);
  const std::size_t point = mantissa.find('.');
  std::string digits = mantissa;
  if (point != std::string::npos) digits.erase(point, 1);
  if (digits.empty() || !all_digits(digits)) return std::nullopt;

  std::string power = text.substr(mantissa_end);
  if (!power.empty() && (power[0] == 'E' || power[0] == 'D')) {
    power.erase(0, 1);
    if (power.empty()) return std::nullopt;
  }
  int exponent = 0;
  if (!power.empty()) {
    if (power[0] == '+') power.erase(0, 1);
    const auto [stop, error] = std::from_chars(power.data(), power.data() + power.size(), exponent);
    if (error != std::errc() || stop != power.data() + power.size()) return std::nullopt;
  }
  exponent -= point == std::string::npos ? 2 : static_cast<int>(mantissa.size() - point - 1);
  const std::string scientific =
      (text[0] == '-' ? "-" : "") + digits + "e" + std::to_string(exponent);
  double value = 0;
  const auto [stop, error] =
      std::from_chars(scientific.data(), scientific.data() + scientific.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return value;
}

class DeckReader {
 public:
  explicit DeckReader(const std::string& name) : name_(name) {}

  StumpDeck read(std::string_view text) {
    while (!text.empty() && !ended_) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view next = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      ++line_;
      if (!next.empty() && next.back() == '\r') next.remove_suffix(1);
      if (!blank(next)) card(next);
    }
    if (!ended_) fail("the deck ends without an E card; add a line \"E \"");
    if (deck_.objects.empty()) fail("holds no object; add V and F cards before the E card");
    finish_object();
    const auto rest = static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
    if (text.find_first_not_of(" \r\n") != std::string_view::npos)
      deck_.notices.push_back(
          {"lines after the E card left unread", std::max<std::uint64_t>(rest, 1)});
    return std::move(deck_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(name_, line_, what); }

  void card(std::string_view text) {
    if (text.find('\t') != std::string_view::npos)
      fail("a card holds a tab; its fields stand in fixed columns, use blanks");
    const std::string_view type = columns(text, 1, 2);
    if (type == "V " || type == "V") return vertex(text);
    if (type == "F " || type == "F") return face(text);
    if (type == "S " || type == "S") return plane(text);
    if (type == "E " || type == "E") {
      ended_ = true;
      return;
    }
    fail("unknown card type \"" + std::string(type) +
         "\"; columns 1-2 must hold V, F, S or E and a blank");
  }

  void nothing_in(std::string_view text, std::size_t first, std::size_t last,
                  const std::string& why) const {
    if (!blank(columns(text, first, last)))
      fail("text in columns " + std::to_string(first) + "-" + std::to_string(last) + "; " + why);
  }

  double real(std::string_view text, std::size_t first) const {
    const std::string_view field = columns(text, first, first + 7);
    const std::optional<double> value = fortran_real(field);
    if (!value)
      fail("\"" + std::string(field) + "\" in columns " + std::to_string(first) + "-" +
           std::to_string(first + 7) + " is no number; write one in F8.2");
    return *value;
  }

  int integer(std::string_view text, std::size_t first) const {
    const std::string_view field = columns(text, first, first + 2);
    const std::optional<int> value = fortran_integer(field);
    if (!value || *value < 0)
      fail("\"" + std::string(field) + "\" in columns " + std::to_string(first) + "-" +
           std::to_string(first + 2) + " is no vertex number; write one in I3, from 1");
    return *value;
  }

  Vec3 point(std::string_view text, std::size_t first) const {
    return {real(text, first), real(text, first + 8), real(text, first + 16)};
  }

  void vertex(std::string_view text) {
    nothing_in(text, 3, 4, "a V card has its number in columns 5-7");
    nothing_in(text, 32, 72, "a V card ends with z in columns 24-31");
    if (deck_.objects.empty() || !deck_.objects.back().faces.empty()) {
      finish_object();
      deck_.objects.emplace_back();
      numbers_.clear();
    }
    const int number = integer(text, 5);
    if (number == 0) fail("a V card has no vertex number; write one in columns 5-7, from 1");
    std::vector<Vec3>& vertices = deck_.objects.back().vertices;
    if (!numbers_.emplace(number, static_cast<std::uint32_t>(vertices.size())).second)
      fail("vertex " + std::to_string(number) +
           " stands twice in this object; give each vertex its own number");
    vertices.push_back(point(text, 8));
    last_vertex_line_ = line_;
  }

  void face(std::string_view text) {
    if (deck_.objects.empty()) fail("an F card before any V card; put the object's V cards first");
    nothing_in(text, 3, 4, "an F card has its first vertex number in columns 5-7");
    nothing_in(text, 35, 72, "an F card holds at most ten vertex numbers, in columns 5-34");
    Face face;
    bool ended = false;
    for (std::size_t i = 0; i < 10; ++i) {
      const int number = integer(text, 5 + 3 * i);
      if (number == 0) {
        ended = true;
        continue;
      }
      if (ended) fail("vertex numbers of an F card must stand side by side from column 5");
      const auto vertex = numbers_.find(number);
      if (vertex == numbers_.end())
        fail("vertex " + std::to_string(number) +
             " is not among the V cards of this object; correct the number");
      face.vertices.push_back(vertex->second);
    }
    std::vector<std::uint32_t> distinct = face.vertices;
    std::sort(distinct.begin(), distinct.end());
    const auto n = std::unique(distinct.begin(), distinct.end()) - distinct.begin();
    if (n < 3)
      fail("a face needs at least 3 different vertices, not " + std::to_string(n) +
           "; complete or remove the card");
    std::reverse(face.vertices.begin(), face.vertices.end());
    deck_.objects.back().faces.push_back(std::move(face));
  }

  void plane(std::string_view text) {
    nothing_in(text, 3, 4, "an S card has its first coordinate in columns 5-12");
    const std::array<Vec3, 3> points{point(text, 5), point(text, 29), point(text, 53)};
    if (collinear(points[0], points[1], points[2]))
      fail("the three points of the plane lie on one line; move one of them off it");
    deck_.planes.push_back(points);
  }

  void finish_object() {
    if (!deck_.objects.empty() && deck_.objects.back().faces.empty()) {
      line_ = last_vertex_line_;
      fail("V cards without F cards after them; add the object's faces");
    }
  }

  std::string name_;
  int line_ = 0;
  int last_vertex_line_ = 0;
  bool ended_ = false;
  std::map<int, std::uint32_t> numbers_;
  StumpDeck deck_;
};

}  // namespace

StumpDeck parse_deck(std::string_view text, const std::string& name) {
  return DeckReader(name).read(text);
}

StumpDeck read_stump_deck(const std::filesystem::path& file) {
  return parse_deck(read_whole_file(file), file.string());
}

ReadResult read_deck(const std::filesystem::path& file) {
  StumpDeck deck = read_stump_deck(file);
  ReadResult result;
  result.environment.name = file.stem().string();
  result.environment.models.push_back({result.environment.name, 0});
  result.environment.objects = std::move(deck.objects);
  result.notices = std::move(deck.notices);
  return result;
}

}  // namespace cigsim
