// SPDX-License-Identifier: MIT
// Wavefront OBJ, read here and not by Assimp, which holds coordinates in single precision, gives no
// line numbers and splits or merges a file's objects.
//
// Every `o` line is one object. A file without `o` takes its `g` groups as objects (the same name
// is the same object), and a file without either is one object. Axes are taken as they stand.
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <unordered_map>

#include "models/environment/input_error.hpp"
#include "models/environment/local_vertices.hpp"
#include "models/environment/obj_materials.hpp"
#include "models/environment/read.hpp"
#include "models/environment/text_file.hpp"

namespace cigsim {
namespace {

constexpr std::uint32_t kNoColour = 0xffffffff;

/// The words of a text, statement by statement, with the line each stands on. A backslash at the
/// end of a line continues the statement; # starts a comment.
class Words {
 public:
  explicit Words(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {}

  std::uint32_t line() const { return line_; }

  /// Goes to the next statement that has a word. False at the end of the text.
  bool next_statement() {
    while (at_ != end_) {
      skip_blanks();
      if (at_ == end_) return false;
      if (*at_ == '#') skip_to_newline();
      if (at_ == end_ || *at_ != '\n') return at_ != end_;
      ++at_;
      ++line_;
    }
    return false;
  }

  /// The next word of this statement, empty at its end.
  std::string_view word() {
    skip_blanks();
    if (at_ != end_ && *at_ == '#') skip_to_newline();
    const char* const begin = at_;
    while (at_ != end_ && !is_blank(*at_) && *at_ != '\n' && !at_continuation()) ++at_;
    return {begin, static_cast<std::size_t>(at_ - begin)};
  }

  /// What is left of this line, without blanks around it.
  std::string_view rest() {
    skip_blanks();
    const char* const begin = at_;
    while (at_ != end_ && *at_ != '\n') ++at_;
    const char* last = at_;
    while (last != begin && is_blank(last[-1])) --last;
    return {begin, static_cast<std::size_t>(last - begin)};
  }

  void skip_statement() {
    while (!word().empty()) {
    }
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

  bool at_continuation() const {
    if (*at_ != '\\') return false;
    const char* next = at_ + 1;
    if (next != end_ && *next == '\r') ++next;
    return next == end_ || *next == '\n';
  }

  void skip_blanks() {
    while (at_ != end_) {
      if (at_continuation()) {
        skip_to_newline();
        if (at_ != end_) ++at_;
        ++line_;
      } else if (is_blank(*at_)) {
        ++at_;
      } else {
        return;
      }
    }
  }

  void skip_to_newline() {
    while (at_ != end_ && *at_ != '\n') ++at_;
  }

  const char* at_;
  const char* end_;
  std::uint32_t line_ = 1;
};

std::string quoted(std::string_view word) {
  std::string text(1, '"');
  return text.append(word).append(1, '"');
}

/// Where an object or group begins in the list of faces.
struct Mark {
  std::size_t face;
  std::string name;
  bool is_group;
};

class ObjReader {
 public:
  ObjReader(const std::filesystem::path& file, std::string_view text) : file_(file), words_(text) {}

  ReadResult read() {
    while (words_.next_statement()) statement(words_.word());
    check_corners();
    const std::vector<Part> parts = divide();
    if (parts.empty())
      throw InputError(file_.string(), 0, "holds no object with faces; add f lines");
    build(parts);
    report();
    return std::move(result_);
  }

 private:
  /// An object to be: the faces of one or more stretches of the file.
  struct Part {
    std::string name;
    std::vector<std::pair<std::size_t, std::size_t>> faces;
  };

  [[noreturn]] void fail(const std::string& what) const { fail(words_.line(), what); }
  [[noreturn]] void fail(std::uint32_t line, const std::string& what) const {
    throw InputError(file_.string(), static_cast<int>(line), what);
  }

  void statement(std::string_view keyword) {
    if (keyword == "v") {
      vertex();
    } else if (keyword == "f" || keyword == "fo") {
      face();
    } else if (keyword == "o" || keyword == "g") {
      marks_.push_back({face_line_.size(), std::string(words_.rest()), keyword == "g"});
    } else if (keyword == "usemtl") {
      use_material(words_.rest());
    } else if (keyword == "mtllib") {
      material_library(words_.rest());
    } else {
      static constexpr std::string_view kOther[] = {"p", "l", "curv", "curv2", "surf"};
      for (const std::string_view other : kOther) dropped_elements_ += keyword == other;
      words_.skip_statement();
    }
  }

  double coordinate() {
    std::string_view word = words_.word();
    if (word.empty()) fail("v needs three coordinates; complete the line");
    const std::string_view whole = word;
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (stop != word.data() + word.size() || error == std::errc::invalid_argument)
      fail(quoted(whole) + " is no coordinate; write a decimal number");
    // Too small for a double reads as 0, too large as infinity.
    if (error == std::errc::result_out_of_range)
      value = std::strtod(std::string(whole).c_str(), nullptr);
    if (!std::isfinite(value)) fail(quoted(whole) + " is not finite; write a finite coordinate");
    return value;
  }

  void vertex() {
    if (vertices_.size() == std::numeric_limits<std::uint32_t>::max() - 1)
      fail("more vertices than 2^32 - 2; split the scene");
    const double x = coordinate(), y = coordinate();
    vertices_.push_back({x, y, coordinate()});
    words_.skip_statement();
  }

  /// The vertex of "v", "v/vt", "v//vn" or "v/vt/vn", from 0. Positive numbers may stand before
  /// their vertex; they are checked at the end of the file.
  std::uint32_t corner(std::string_view word) {
    std::int64_t index = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, index);
    if (error != std::errc() || (stop != end && *stop != '/'))
      fail(quoted(word) + " is no vertex of a face; write vertex numbers from 1");
    const auto count = static_cast<std::int64_t>(vertices_.size());
    if (index == 0) fail("vertex number 0 in a face; vertices count from 1");
    if (index < -count || index > std::numeric_limits<std::uint32_t>::max() - 1)
      fail("vertex " + std::to_string(index) + " is out of range; " + std::to_string(count) +
           " vertices stand before this line");
    return static_cast<std::uint32_t>(index < 0 ? count + index : index - 1);
  }

  void face() {
    const std::uint32_t line = words_.line();
    const std::size_t first = corners_.size();
    for (std::string_view word = words_.word(); !word.empty(); word = words_.word())
      corners_.push_back(corner(word));
    const std::size_t n = corners_.size() - first;
    if (n < 3)
      fail(line, "a face needs at least 3 vertices, not " + std::to_string(n) +
                     "; complete or remove the line");
    if (!has_three_distinct(first)) {
      corners_.resize(first);
      ++degenerate_faces_;
      return;
    }
    face_end_.push_back(corners_.size());
    face_line_.push_back(line);
    face_colour_.push_back(colour_);
  }

  bool has_three_distinct(std::size_t first) const {
    const std::uint32_t a = corners_[first];
    std::size_t i = first + 1;
    while (i < corners_.size() && corners_[i] == a) ++i;
    if (i == corners_.size()) return false;
    const std::uint32_t b = corners_[i];
    while (i < corners_.size() && (corners_[i] == a || corners_[i] == b)) ++i;
    return i != corners_.size();
  }

  void use_material(std::string_view name) {
    colour_ = kNoColour;
    if (name.empty() || name == "rgb_none") return;
    const auto library = materials_.find(name);
    std::optional<Colour> colour = colour_of_name(name);
    if (library != materials_.end()) colour = library->second;
    if (!colour) {
      ++unknown_materials_;
      return;
    }
    colour_ = std::uint32_t{colour->r} << 16 | std::uint32_t{colour->g} << 8 | colour->b;
  }

  /// One library whose name has blanks, or several names.
  void material_library(std::string_view names) {
    const std::filesystem::path folder = file_.parent_path();
    if (read_obj_materials(folder / names, materials_)) return;
    std::size_t at = 0;
    while (at < names.size()) {
      const std::size_t end = std::min(names.find(' ', at), names.size());
      const std::string_view name = names.substr(at, end - at);
      if (!name.empty() && !read_obj_materials(folder / name, materials_)) ++missing_libraries_;
      at = end + 1;
    }
  }

  std::size_t face_begin(std::size_t face) const { return face == 0 ? 0 : face_end_[face - 1]; }

  void check_corners() const {
    for (std::size_t f = 0; f < face_end_.size(); ++f)
      for (std::size_t c = face_begin(f); c < face_end_[f]; ++c)
        if (corners_[c] >= vertices_.size())
          fail(face_line_[f], "vertex " + std::to_string(std::uint64_t{corners_[c]} + 1) +
                                  " is out of range; the file has " +
                                  std::to_string(vertices_.size()) + " vertices");
  }

  std::vector<Part> divide() {
    bool by_object = false;
    for (const Mark& mark : marks_) by_object = by_object || !mark.is_group;
    std::vector<Part> parts;
    std::unordered_map<std::string, std::size_t> groups;
    const auto add = [&](const std::string& name, std::size_t begin, std::size_t end) {
      std::size_t part = parts.size();
      if (!by_object) {
        if (begin == end) return;
        part = groups.try_emplace(name, part).first->second;
      }
      if (part == parts.size()) parts.push_back({name, {}});
      parts[part].faces.push_back({begin, end});
    };
    std::size_t begin = 0;
    const std::string* name = nullptr;
    for (const Mark& mark : marks_) {
      if (mark.is_group == by_object) continue;
      if (name || mark.face > begin) add(name ? *name : std::string(), begin, mark.face);
      begin = mark.face;
      name = &mark.name;
    }
    if (name || face_end_.size() > begin)
      add(name ? *name : std::string(), begin, face_end_.size());
    return face_end_.empty() ? std::vector<Part>{} : parts;
  }

  void build(const std::vector<Part>& parts) {
    Environment& environment = result_.environment;
    environment.name = file_.stem().string();
    environment.models.push_back({environment.name, 0});
    environment.objects.resize(parts.size());
    LocalVertices local(vertices_.size());
    std::vector<bool> used(vertices_.size());
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      corners.clear();
      for (const auto& [begin, end] : parts[i].faces)
        corners.insert(corners.end(), corners_.begin() + static_cast<long>(face_begin(begin)),
                       corners_.begin() + static_cast<long>(face_begin(end)));
      Object& object = environment.objects[i];
      object.name = parts[i].name;
      const std::vector<std::uint32_t>& own = local.begin_object(corners);
      object.vertices.reserve(own.size());
      for (const std::uint32_t v : own) {
        object.vertices.push_back(vertices_[v]);
        used[v] = true;
      }
      for (const auto& [begin, end] : parts[i].faces) add_faces(object, local, begin, end);
      local.end_object();
      empty_objects_ += object.faces.empty();
    }
    for (const bool u : used) unused_vertices_ += !u;
  }

  void add_faces(Object& object, const LocalVertices& local, std::size_t begin, std::size_t end) {
    object.faces.reserve(object.faces.size() + (end - begin));
    for (std::size_t f = begin; f < end; ++f) {
      Face& face = object.faces.emplace_back();
      face.vertices.reserve(face_end_[f] - face_begin(f));
      for (std::size_t c = face_begin(f); c < face_end_[f]; ++c)
        face.vertices.push_back(local[corners_[c]]);
      const std::uint32_t colour = face_colour_[f];
      if (colour != kNoColour)
        face.colour =
            Colour{static_cast<std::uint8_t>(colour >> 16), static_cast<std::uint8_t>(colour >> 8),
                   static_cast<std::uint8_t>(colour)};
    }
  }

  void report() {
    const auto notice = [&](const char* what, std::uint64_t count) {
      if (count > 0) result_.notices.push_back({what, count});
    };
    notice("points, lines, curves and curved surfaces dropped", dropped_elements_);
    notice("faces of fewer than three different vertices dropped", degenerate_faces_);
    notice("vertices that no face uses dropped", unused_vertices_);
    notice("objects without faces", empty_objects_);
    notice("material libraries not found", missing_libraries_);
    notice("uses of a material without a colour", unknown_materials_);
  }

  std::filesystem::path file_;
  Words words_;
  std::vector<Vec3> vertices_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> face_end_;  ///< a face's corners end here, and the next one's begin
  std::vector<std::uint32_t> face_line_, face_colour_;
  std::vector<Mark> marks_;
  ObjMaterials materials_;
  std::uint32_t colour_ = kNoColour;
  std::uint64_t dropped_elements_ = 0, degenerate_faces_ = 0, unused_vertices_ = 0,
                empty_objects_ = 0, missing_libraries_ = 0, unknown_materials_ = 0;
  ReadResult result_;
};

}  // namespace

ReadResult read_obj(const std::filesystem::path& file) {
  const std::string text = read_whole_file(file);
  return ObjReader(file, text).read();
}

}  // namespace cigsim
