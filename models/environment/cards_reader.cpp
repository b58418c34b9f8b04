// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "models/environment/cards.hpp"
#include "models/environment/input_error.hpp"
#include "models/environment/placement.hpp"
#include "models/environment/text_file.hpp"

namespace cigsim {
namespace {

constexpr double kMostWhole = 32767;   // FIXED BIN(15)
constexpr std::size_t kIdLength = 30;  // ID CHAR(30)

enum class Instruction { kView, kVertex, kFace, kPlot, kBegin, kEnd, kStop, kUnknown };

Instruction instruction_of(std::string_view id) {
  // His order: INDEX is asked for one after the other.
  constexpr std::array<std::string_view, 7> kWords{
      "VIEW DATA", "VERTEX", "FACE", "PLOT", "BEGIN STRUCTURE DATA", "END STRUCTURE DATA", "STOP"};
  for (std::size_t i = 0; i < kWords.size(); ++i)
    if (id.find(kWords[i]) != std::string_view::npos) return static_cast<Instruction>(i);
  return Instruction::kUnknown;
}

// The characters of a deck, with line numbers.
class Stream {
 public:
  Stream(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  [[noreturn]] void fail(const std::string& what, int line = 0) const {
    throw InputError(name_, line > 0 ? line : line_, what);
  }
  int line() const { return line_; }
  bool at_end() const { return at_ == text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[at_]; }
  char take() {
    const char c = text_[at_++];
    line_ += c == '\n';
    return c;
  }
  void skip_blanks() {
    while (!at_end() && blank(peek())) take();
  }
  /// Blanks and at most one comma.
  void skip_separator() {
    skip_blanks();
    if (peek() != ',') return;
    take();
    skip_blanks();
  }
  /// Up to a blank, comma, semicolon, quote or equals sign.
  std::string word() {
    std::string out;
    while (!at_end() && !blank(peek()) &&
           std::string_view(",;'=").find(peek()) == std::string_view::npos)
      out += take();
    return out;
  }
  /// After the opening quote.
  std::string quoted() {
    const int from = line_;
    std::string out;
    while (true) {
      if (at_end()) fail("the quote that begins here is not closed; add a quote", from);
      const char c = take();
      if (c == '\'') {
        if (peek() != '\'') return out;
        take();
      }
      if (c == '\n' || c == '\r') continue;
      out += c;
    }
  }

 private:
  static bool blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  int line_ = 1;
};

std::string upper(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

class CardsReader {
 public:
  CardsReader(std::string_view text, const std::string& name) : in_(text, name) {}

  CardsDeck read() {
    bool stopped = false;
    for (in_.skip_separator(); !stopped && !in_.at_end(); in_.skip_separator()) {
      const int line = in_.line();
      if (in_.peek() != '\'')
        in_.fail("an instruction in quotes must stand here, as 'VERTEX'; found \"" +
                 some_of_the_rest() + "\"");
      in_.take();
      const std::string id = in_.quoted().substr(0, kIdLength);
      stopped = carry_out(instruction_of(id), id, line);
    }
    if (deck_.structures.empty())
      in_.fail(open_
                   ? "the structure has no 'END STRUCTURE DATA'; add it after the last 'FACE'"
                   : "holds no structure; add 'VERTEX' and 'FACE' cards and 'END STRUCTURE DATA'");
    if (!stopped) deck_.notices.push_back({"deck ends without 'STOP'", 1});
    in_.skip_separator();
    if (stopped && !in_.at_end())
      deck_.notices.push_back({"deck goes on after 'STOP': left unread", 1});
    return std::move(deck_);
  }

 private:
  using Fields = std::vector<std::pair<const char*, double*>>;

  std::string some_of_the_rest() {
    std::string out;
    while (!in_.at_end() && in_.peek() != '\n' && out.size() < 20) out += in_.take();
    return out;
  }

  // True for STOP.
  bool carry_out(Instruction instruction, const std::string& id, int line) {
    switch (instruction) {
      case Instruction::kView:
        view(line);
        break;
      case Instruction::kVertex:
        vertex(line);
        break;
      case Instruction::kFace:
        face(line);
        break;
      case Instruction::kPlot:
        plot(line);
        break;
      case Instruction::kBegin:
        structure_ = {};
        places_.clear();
        open_ = true;
        ended_ = false;
        break;
      case Instruction::kEnd:
        end(line);
        break;
      case Instruction::kStop:
        return true;
      case Instruction::kUnknown:
        deck_.reports.push_back("line " + std::to_string(line) + ": '" + id +
                                "' is not a legal instruction; skipped up to the next quote");
        deck_.notices.push_back({"unknown instruction '" + id + "' skipped", 1});
        while (!in_.at_end() && in_.peek() != '\'') in_.take();
    }
    return false;
  }

  double number(const std::string& text, const std::string& what) {
    double value = 0;
    const char* first = text.data() + (!text.empty() && text[0] == '+');
    const char* last = text.data() + text.size();
    const auto [stop, error] = std::from_chars(first, last, value);
    if (text.empty() || error != std::errc() || stop != last || !std::isfinite(value) ||
        text.find_first_not_of("+-0123456789.eE") != std::string::npos)
      in_.fail(what + " is \"" + text + "\", which is no number; write one, as 2.5 or 1E3");
    return value;
  }

  int whole(double value, const std::string& what, double least, int line) {
    if (value != std::floor(value) || value < least || value > kMostWhole)
      in_.fail(what + " must be a whole number from " + std::to_string(static_cast<int>(least)) +
                   " to 32767",
               line);
    return static_cast<int>(value);
  }

  // GET DATA: NAME=value up to a semicolon; what is not named stays as it is.
  void get_data(const std::string& instruction, const Fields& fields) {
    const int line = in_.line();
    std::string names;
    for (const auto& field : fields)
      names += (names.empty() ? "" : ", ") + std::string(field.first);
    for (in_.skip_separator(); in_.peek() != ';'; in_.skip_separator()) {
      if (in_.at_end() || in_.peek() == '\'')
        in_.fail("the data of '" + instruction + "' do not end; put a semicolon after the last",
                 line);
      const std::string name = upper(in_.word());
      in_.skip_blanks();
      if (in_.peek() != '=')
        in_.fail("\"" + name + "\" in the data of '" + instruction +
                 "' has no value; write NAME=value");
      in_.take();
      in_.skip_blanks();
      const auto field = std::find_if(fields.begin(), fields.end(),
                                      [&](const auto& f) { return name == f.first; });
      if (field == fields.end())
        in_.fail("'" + instruction + "' has no " + (name.empty() ? "nameless value" : name) +
                 "; it has " + names);
      *field->second = number(in_.word(), name);
    }
    in_.take();
    for (const auto& [name, value] : fields)
      if (std::isnan(*value))
        in_.fail("'" + instruction + "' lacks " + name + ", and no card before gave it; add " +
                     name + "=…",
                 line);
  }

  // GET LIST.
  double get_number(const std::string& what) {
    in_.skip_separator();
    if (in_.at_end() || in_.peek() == '\'')
      in_.fail(what + " is missing; there are fewer numbers than the card says");
    const std::string text = in_.word();
    if (text.empty()) in_.fail(what + " is missing before '" + in_.peek() + "'");
    return number(text, what);
  }

  void view(int line) {
    get_data("VIEW DATA", {{"R", &view_[0]},
                           {"D", &view_[1]},
                           {"THETA", &view_[2]},
                           {"PHI", &view_[3]},
                           {"DR", &view_[4]},
                           {"DD", &view_[5]},
                           {"DTHETA", &view_[6]},
                           {"DPHI", &view_[7]}});
    CardsView v{view_[0], view_[1], view_[2], view_[3], view_[4], view_[5], view_[6], view_[7]};
    // The increments count at once; the angles keep them, the distances do not (RMAG = R + DR).
    v.theta = view_[2] += v.dtheta;
    v.phi = view_[3] += v.dphi;
    if (!(v.d + v.dd > 0)) in_.fail("D must be above 0: the view plane lies before the eye", line);
    deck_.view = v;
  }

  void vertex(int line) {
    if (ended_) in_.fail("'VERTEX' after 'END STRUCTURE DATA'; begin a new structure first", line);
    open_ = true;
    get_data("VERTEX", {{"X", &vertex_[0]},
                        {"Y", &vertex_[1]},
                        {"Z", &vertex_[2]},
                        {"NEDGES", &vertex_[3]},
                        {"TAG", &vertex_[4]}});
    const int edges = whole(vertex_[3], "NEDGES", 0, line), tag = whole(vertex_[4], "TAG", 1, line);
    for (int i = 0; i < edges; ++i)
      get_number("number " + std::to_string(i + 1) + " of NEDGES = " + std::to_string(edges));
    if (!places_.emplace(tag, static_cast<std::uint32_t>(structure_.vertices.size())).second)
      in_.fail("TAG " + std::to_string(tag) +
                   " stands twice in this structure; give each vertex its own",
               line);
    structure_.vertices.push_back({tag, {vertex_[0], vertex_[1], vertex_[2]}, line});
  }

  void face(int line) {
    if (ended_) in_.fail("'FACE' after 'END STRUCTURE DATA'; begin a new structure first", line);
    open_ = true;
    get_data("FACE", {{"LABEL", &face_[0]}, {"NVERT", &face_[1]}});
    const int label = whole(face_[0], "LABEL", 0, line),
              corners = whole(face_[1], "NVERT", 3, line);
    CardsFace out{label, {}, line};
    for (int i = 0; i < corners; ++i) {
      const std::string what = "corner " + std::to_string(i + 1) + " of " + std::to_string(corners);
      const int tag = whole(get_number(what), what, 1, in_.line());
      const auto at = places_.find(tag);
      if (at == places_.end())
        in_.fail("no 'VERTEX' card has TAG " + std::to_string(tag) + "; put it before the face");
      if (std::find(out.vertices.begin(), out.vertices.end(), at->second) != out.vertices.end())
        in_.fail("the face names vertex " + std::to_string(tag) + " twice; name each corner once",
                 line);
      out.vertices.push_back(at->second);
    }
    structure_.faces.push_back(std::move(out));
  }

  void end(int line) {
    if (ended_) in_.fail("'END STRUCTURE DATA' twice; begin a new structure first", line);
    if (structure_.faces.empty()) in_.fail("the structure has no 'FACE'; add its faces", line);
    deck_.structures.push_back(structure_);
    ended_ = true;
    open_ = false;
  }

  void plot(int line) {
    get_data("PLOT", {{"DELAY", &delay_}});
    if (!ended_) in_.fail("'PLOT' before 'END STRUCTURE DATA'; there is nothing to draw yet", line);
    if (!deck_.view) in_.fail("'PLOT' before 'VIEW DATA'; say where the eye stands first", line);
    deck_.plots.push_back(
        {static_cast<std::uint32_t>(deck_.structures.size() - 1), *deck_.view, delay_, line});
  }

  Stream in_;
  CardsDeck deck_;
  CardsStructure structure_;
  std::map<int, std::uint32_t> places_;
  bool open_ = false, ended_ = false;
  // What GET DATA leaves as it was; nothing yet.
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double view_[8] = {kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
  double vertex_[5] = {kNone, kNone, kNone, kNone, kNone};
  double face_[2] = {kNone, kNone};
  double delay_ = kNone;
};

// Bodies of a structure: faces that share vertices, directly or through others, are one.
std::vector<Object> objects_of(const CardsStructure& structure) {
  std::vector<std::uint32_t> body(structure.vertices.size());
  std::iota(body.begin(), body.end(), 0);
  const auto root = [&](std::uint32_t v) {
    while (body[v] != v) v = body[v] = body[body[v]];
    return v;
  };
  for (const CardsFace& face : structure.faces)
    for (const std::uint32_t v : face.vertices) body[root(v)] = root(face.vertices.front());
  std::vector<Object> objects;
  std::map<std::uint32_t, std::size_t> place;
  std::vector<std::uint32_t> local(structure.vertices.size());
  std::vector<char> known(structure.vertices.size(), 0);
  for (const CardsFace& face : structure.faces) {
    const auto [at, fresh] = place.emplace(root(face.vertices.front()), objects.size());
    if (fresh) objects.emplace_back();
    Object& object = objects[at->second];
    Face out;
    for (const std::uint32_t v : face.vertices) {
      if (!known[v]) {
        known[v] = 1;
        local[v] = static_cast<std::uint32_t>(object.vertices.size());
        object.vertices.push_back(from_cards_axes(structure.vertices[v].position));
      }
      out.vertices.push_back(local[v]);
    }
    std::reverse(out.vertices.begin(), out.vertices.end());
    object.faces.push_back(std::move(out));
  }
  return objects;
}

}  // namespace

CardsDeck parse_cards(std::string_view text, const std::string& name) {
  return CardsReader(text, name).read();
}

CardsDeck read_cards_deck(const std::filesystem::path& file) {
  return parse_cards(read_whole_file(file), file.string());
}

DefaultView cards_view(const CardsView& view) {
  const double r = view.r + view.dr, d = view.d + view.dd;
  const Vec3 ahead{cos_degrees(view.phi) * sin_degrees(view.theta), 0 - sin_degrees(view.phi),
                   0 - cos_degrees(view.phi) * cos_degrees(view.theta)};
  DefaultView out;
  out.eye = {from_cards_axes(ahead * -r), view.theta, 0 - view.phi, 0};
  out.fov = 2 * std::atan(1 / d) * 180 / std::numbers::pi;
  return out;
}

ReadResult read_cards(const std::filesystem::path& file) {
  CardsDeck deck = read_cards_deck(file);
  ReadResult result;
  result.environment.name = file.stem().string();
  result.environment.models.push_back({result.environment.name, 0});
  result.environment.objects = objects_of(deck.structures.back());
  if (deck.view) result.environment.view = cards_view(*deck.view);
  result.notices = std::move(deck.notices);
  if (deck.structures.size() > 1)
    result.notices.push_back(
        {"structure that a later one replaces: left out", deck.structures.size() - 1});
  return result;
}

}  // namespace cigsim
