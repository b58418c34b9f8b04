// SPDX-License-Identifier: MIT
// Stanford PLY (Turk 1994), text and binary, read here and not by Assimp 5.2, which does not return
// from some truncated PLY files. Axes are taken as they stand.
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "models/environment/input_error.hpp"
#include "models/environment/mesh_repair.hpp"
#include "models/environment/read.hpp"
#include "models/environment/text_file.hpp"

namespace cigsim {
namespace {

enum class Encoding { text, little, big };
enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

struct TypeName {
  std::string_view name;
  Type type;
};
constexpr TypeName kTypes[] = {
    {"char", Type::i8},   {"int8", Type::i8},     {"uchar", Type::u8},   {"uint8", Type::u8},
    {"short", Type::i16}, {"int16", Type::i16},   {"ushort", Type::u16}, {"uint16", Type::u16},
    {"int", Type::i32},   {"int32", Type::i32},   {"uint", Type::u32},   {"uint32", Type::u32},
    {"float", Type::f32}, {"float32", Type::f32}, {"double", Type::f64}, {"float64", Type::f64}};

struct Property {
  std::string name;
  Type type;
  bool is_list = false;
  Type count_type = Type::u8;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

class PlyReader {
 public:
  PlyReader(const std::filesystem::path& file, std::string_view bytes)
      : file_(file.string()), rest_(bytes) {}

  ReadResult read(const std::string& name) {
    header();
    for (const Element& element : elements_) {
      if (element.properties.empty()) continue;
      for (std::uint64_t i = 0; i < element.count; ++i) read_one(element, i);
    }
    for (const Face& face : object_.faces)
      for (const std::uint32_t v : face.vertices)
        if (v >= object_.vertices.size())
          throw InputError(file_, 0,
                           "a face names vertex " + std::to_string(v) + " of " +
                               std::to_string(object_.vertices.size()) +
                               ", counted from 0; correct the face");
    return result(name);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_, encoding_ == Encoding::text ? line_ : 0, what);
  }

  void header() {
    if (next_line() != "ply") fail("is no PLY file; its first line must be \"ply\"");
    std::string format;
    while (true) {
      if (rest_.empty()) fail("the header has no end_header; the file is cut off, copy it again");
      std::string_view line = next_line();
      const std::string_view keyword = word(line);
      if (keyword == "end_header") break;
      if (keyword == "format") format = word(line);
      if (keyword == "element") element(line);
      if (keyword == "property") property(line);
    }
    data_line_ = line_ + 1;
    if (format == "binary_little_endian") encoding_ = Encoding::little;
    if (format == "binary_big_endian") encoding_ = Encoding::big;
    if (format != "ascii" && encoding_ == Encoding::text)
      fail("unknown format \"" + format +
           "\"; it must be ascii, binary_little_endian or binary_big_endian");
  }

  std::string_view next_line() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  static std::string_view word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    const std::string_view found = line.substr(0, end);
    line.remove_prefix(end);
    return found;
  }

  void element(std::string_view line) {
    Element element;
    element.name = word(line);
    const std::string_view count = word(line);
    const auto [stop, error] =
        std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (error != std::errc() || stop != count.data() + count.size() || count.empty())
      fail("an element needs a name and a count; correct the line");
    if (element.name == "vertex" && element.count > std::numeric_limits<std::uint32_t>::max() - 1)
      fail("more vertices than 2^32 - 2; split the scene");
    elements_.push_back(std::move(element));
  }

  void property(std::string_view line) {
    if (elements_.empty()) fail("a property before any element; put an element line first");
    Property property;
    std::string_view type_name = word(line);
    property.is_list = type_name == "list";
    if (property.is_list) {
      property.count_type = type(word(line));
      type_name = word(line);
    }
    property.type = type(type_name);
    property.name = word(line);
    elements_.back().properties.push_back(std::move(property));
  }

  Type type(std::string_view name) const {
    for (const TypeName& t : kTypes)
      if (t.name == name) return t.type;
    fail("unknown type \"" + std::string(name) +
         "\" of a property; use char, uchar, short, ushort, "
         "int, uint, float or double");
  }

  void read_one(const Element& element, std::uint64_t i) {
    const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
    Vec3 place;
    Face face;
    double rgb[3] = {-1, -1, -1};
    for (const Property& p : element.properties) {
      if (p.is_list) {
        const bool corners = is_face && (p.name == "vertex_indices" || p.name == "vertex_index");
        list(p, corners ? &face : nullptr, element, i);
        continue;
      }
      const double value = scalar(p.type, element, i);
      if (p.name == "x") place.x = value;
      if (p.name == "y") place.y = value;
      if (p.name == "z") place.z = value;
      if (p.name == "red" && p.type == Type::u8) rgb[0] = value;
      if (p.name == "green" && p.type == Type::u8) rgb[1] = value;
      if (p.name == "blue" && p.type == Type::u8) rgb[2] = value;
    }
    if (is_vertex) add_vertex(place, i);
    if (!is_face) return;
    if (rgb[0] >= 0 && rgb[1] >= 0 && rgb[2] >= 0)
      face.colour = Colour{static_cast<std::uint8_t>(rgb[0]), static_cast<std::uint8_t>(rgb[1]),
                           static_cast<std::uint8_t>(rgb[2])};
    object_.faces.push_back(std::move(face));
  }

  void add_vertex(const Vec3& place, std::uint64_t i) {
    if (!std::isfinite(place.x) || !std::isfinite(place.y) || !std::isfinite(place.z))
      fail("vertex " + std::to_string(i) + " is not finite; correct its coordinates");
    object_.vertices.push_back(place);
  }

  void list(const Property& p, Face* face, const Element& element, std::uint64_t i) {
    const double count = scalar(p.count_type, element, i);
    if (!(count >= 0) || count != std::floor(count))
      fail("a list has no valid length; write a whole number from 0");
    for (double k = 0; k < count; ++k) {
      const double value = scalar(p.type, element, i);
      if (!face) continue;
      if (!(value >= 0 && value < 4294967295.0) || value != std::floor(value))
        fail("face " + std::to_string(i) + " holds no valid vertex number; vertices count from 0");
      face->vertices.push_back(static_cast<std::uint32_t>(value));
    }
  }

  double scalar(Type type, const Element& element, std::uint64_t i) {
    if (encoding_ == Encoding::text) return text_scalar(element, i);
    switch (type) {
      case Type::i8:
        return static_cast<std::int8_t>(binary<std::uint8_t>(element, i));
      case Type::u8:
        return binary<std::uint8_t>(element, i);
      case Type::i16:
        return static_cast<std::int16_t>(binary<std::uint16_t>(element, i));
      case Type::u16:
        return binary<std::uint16_t>(element, i);
      case Type::i32:
        return static_cast<std::int32_t>(binary<std::uint32_t>(element, i));
      case Type::u32:
        return binary<std::uint32_t>(element, i);
      case Type::f32:
        return std::bit_cast<float>(binary<std::uint32_t>(element, i));
      default:
        return std::bit_cast<double>(binary<std::uint64_t>(element, i));
    }
  }

  [[noreturn]] void cut_off(const Element& element, std::uint64_t i) const {
    fail("ends at " + element.name + " " + std::to_string(i) + " of " +
         std::to_string(element.count) + "; the file is cut off, copy or export it again");
  }

  double text_scalar(const Element& element, std::uint64_t i) {
    std::size_t begin = 0;
    while (begin < rest_.size() && static_cast<unsigned char>(rest_[begin]) <= ' ')
      data_line_ += rest_[begin++] == '\n';
    rest_.remove_prefix(begin);
    if (rest_.empty()) cut_off(element, i);
    line_ = data_line_;
    std::size_t end = 0;
    while (end < rest_.size() && static_cast<unsigned char>(rest_[end]) > ' ') ++end;
    std::string_view token = rest_.substr(0, end);
    rest_.remove_prefix(end);
    double value = 0;
    const std::string_view digits = token.substr(token.size() > 1 && token[0] == '+');
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || stop != digits.data() + digits.size())
      fail("\"" + std::string(token) + "\" is no number; write a decimal number");
    return value;
  }

  template <class Bits>
  Bits binary(const Element& element, std::uint64_t i) {
    if (rest_.size() < sizeof(Bits)) cut_off(element, i);
    Bits value = 0;
    for (std::size_t k = 0; k < sizeof(Bits); ++k) {
      const std::size_t at = encoding_ == Encoding::big ? k : sizeof(Bits) - 1 - k;
      value = static_cast<Bits>(value << 7 << 1 | static_cast<unsigned char>(rest_[at]));
    }
    rest_.remove_prefix(sizeof(Bits));
    return value;
  }

  ReadResult result(const std::string& name) {
    object_.name = name;
    join_vertices(object_);
    const std::uint64_t degenerate = drop_degenerate_faces(object_);
    if (object_.faces.empty())
      throw InputError(file_, 0, "holds no object with faces; export a mesh of polygons");
    ReadResult result;
    result.environment.name = name;
    result.environment.models.push_back({name, 0});
    result.environment.objects.push_back(std::move(object_));
    if (degenerate > 0)
      result.notices.push_back(
          {"faces of fewer than three different vertices dropped", degenerate});
    return result;
  }

  std::string file_;
  std::string_view rest_;
  Encoding encoding_ = Encoding::text;
  int line_ = 0;
  int data_line_ = 0;
  std::vector<Element> elements_;
  Object object_;
};

}  // namespace

ReadResult read_ply(const std::filesystem::path& file) {
  const std::string bytes = read_whole_file(file);
  return PlyReader(file, bytes).read(file.stem().string());
}

}  // namespace cigsim
