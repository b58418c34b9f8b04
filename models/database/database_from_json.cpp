// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "models/database/database_json.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

// A value and its place in the file, for messages.
class Node {
 public:
  Node(const Json& value, std::string place) : value_(value), place_(std::move(place)) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw DatabaseFault(place_ + ": " + what);
  }

  Node operator[](const char* key) const {
    if (!value_.is_object()) fail("must be an object");
    const auto found = value_.find(key);
    if (found == value_.end()) fail(std::string("has no \"") + key + "\"");
    return {*found, place_.empty() ? key : place_ + "." + key};
  }
  bool has(const char* key) const { return value_.is_object() && value_.contains(key); }
  Node entry(std::size_t index) const {
    return {value_[index], place_ + "[" + std::to_string(index) + "]"};
  }

  std::size_t size() const {
    if (!value_.is_array()) fail("must be a list");
    return value_.size();
  }
  /// Length of a list made of rows of `width` numbers, in rows.
  std::size_t rows(std::size_t width) const {
    if (size() % width != 0) fail("must hold " + std::to_string(width) + " numbers a row");
    const std::size_t count = size() / width;
    if (count >= kNone) fail("is too long");
    return count;
  }

  double number(std::size_t index) const { return finite(value_[index], index); }
  double number() const { return finite(value_, 0); }
  Vec3 vector(std::size_t first) const {
    return {number(first), number(first + 1), number(first + 2)};
  }

  template <class Int>
  Int whole(std::size_t index) const {
    return whole_of<Int>(value_[index], index);
  }
  template <class Int>
  Int whole() const {
    return whole_of<Int>(value_, 0);
  }

  std::string text() const {
    if (!value_.is_string()) fail("must be a string");
    return value_.get<std::string>();
  }

 private:
  double finite(const Json& value, std::size_t index) const {
    if (!value.is_number()) fail("entry " + std::to_string(index) + " must be a number");
    const double number = value.get<double>();
    if (!std::isfinite(number)) fail("entry " + std::to_string(index) + " must be finite");
    return number;
  }

  template <class Int>
  Int whole_of(const Json& value, std::size_t index) const {
    using Limits = std::numeric_limits<Int>;
    if (value.is_number_unsigned()) {
      const auto number = value.get<std::uint64_t>();
      if (number <= static_cast<std::uint64_t>(Limits::max())) return static_cast<Int>(number);
    } else if (value.is_number_integer()) {
      const auto number = value.get<std::int64_t>();
      if (number >= 0
              ? static_cast<std::uint64_t>(number) <= static_cast<std::uint64_t>(Limits::max())
              : Limits::is_signed && number >= static_cast<std::int64_t>(Limits::min()))
        return static_cast<Int>(number);
    }
    fail("entry " + std::to_string(index) + " must be a whole number in range");
  }

  const Json& value_;
  std::string place_;
};

bool is_whole_text(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// "num" or "num/den" with a positive denominator.
Exact rational(const Node& node) {
  const std::string text = node.text();
  const std::size_t slash = text.find('/');
  const std::string numerator = text.substr(0, slash);
  const std::string denominator = slash == std::string::npos ? "1" : text.substr(slash + 1);
  if (!is_whole_text(numerator) || !is_whole_text(denominator) || denominator.starts_with('-') ||
      denominator.find_first_not_of('0') == std::string::npos)
    node.fail("must be a fraction such as \"1/3\"");
  Exact value{mpz_class(numerator), mpz_class(denominator)};
  value.canonicalize();
  return value;
}

Colour colour(const Node& node, std::uint32_t packed) {
  if (packed > 0xffffff) node.fail("holds a colour above 0xffffff");
  return {static_cast<std::uint8_t>(packed >> 16), static_cast<std::uint8_t>(packed >> 8),
          static_cast<std::uint8_t>(packed)};
}

bool flag(const Node& list, std::size_t index) {
  const auto value = list.whole<std::uint32_t>(index);
  if (value > 1) list.fail("entry " + std::to_string(index) + " must be 0 or 1");
  return value == 1;
}

Sphere sphere(const Node& list, std::size_t first) {
  const Sphere result{list.vector(first), list.number(first + 3)};
  if (result.radius < 0) list.fail("holds a negative radius");
  return result;
}

void expect_rows(const Node& list, std::size_t width, std::size_t rows) {
  if (list.rows(width) != rows) list.fail("must hold " + std::to_string(rows) + " rows");
}

Placement placement(const Node& list, std::size_t first) {
  return {list.vector(first), list.number(first + 3), list.number(first + 4),
          list.number(first + 5)};
}

std::vector<Plane> planes(const Node& node) {
  const Node points = node["points"], list = node["planes"];
  const std::size_t point_count = points.rows(3);
  std::vector<Plane> result(list.rows(5));
  const auto point = [&](std::size_t index) {
    const auto which = list.whole<std::uint32_t>(index);
    if (which >= point_count) list.fail("entry " + std::to_string(index) + " names no point");
    return points.vector(std::size_t{3} * which);
  };
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = make_plane(
        {point(5 * i), point(5 * i + 1), point(5 * i + 2), point(5 * i + 3), point(5 * i + 4)});
  return result;
}

void read_faces(const Node& list, std::vector<PreparedFace>& faces) {
  faces.resize(list.rows(6));
  for (std::size_t i = 0; i < faces.size(); ++i) {
    PreparedFace& face = faces[i];
    face.first_corner = list.whole<std::uint32_t>(6 * i);
    face.corner_count = list.whole<std::uint32_t>(6 * i + 1);
    face.plane = list.whole<std::uint32_t>(6 * i + 2);
    face.object = list.whole<std::uint32_t>(6 * i + 3);
    face.colour = colour(list, list.whole<std::uint32_t>(6 * i + 4));
    face.two_sided = flag(list, 6 * i + 5);
  }
}

void read_items(const Node& list, const Node& spheres, std::vector<Item>& items) {
  items.resize(list.rows(4));
  expect_rows(spheres, 4, items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
    items[i] = {list.whole<std::uint32_t>(4 * i), list.whole<std::uint32_t>(4 * i + 1),
                list.whole<std::uint32_t>(4 * i + 2), list.whole<std::uint32_t>(4 * i + 3),
                sphere(spheres, 4 * i)};
}

FaceSet read_set(const Node& node) {
  FaceSet set;
  const Node vertices = node["vertices"];
  set.vertices.resize(vertices.rows(3));
  for (std::size_t i = 0; i < set.vertices.size(); ++i) set.vertices[i] = vertices.vector(3 * i);
  const Node cuts = node["cut_vertices"];
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const Node cut = cuts.entry(i);
    expect_rows(cut, 4, 1);
    set.cut_vertices.push_back(
        {cut.whole<std::uint32_t>(0),
         {rational(cut.entry(1)), rational(cut.entry(2)), rational(cut.entry(3))}});
  }
  const Node corners = node["corners"];
  set.corners.resize(corners.rows(1));
  for (std::size_t i = 0; i < set.corners.size(); ++i)
    set.corners[i] = corners.whole<std::uint32_t>(i);
  set.planes = planes(node);
  read_faces(node["faces"], set.faces);
  read_items(node["items"], node["spheres"], set.items);
  return set;
}

// The pairs of a table made by hand, in the order of its nodes.
void read_pairs(const Node& list, PriorityHierarchy& hierarchy) {
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < list.rows(3); ++i) {
    const auto n = list.whole<std::uint32_t>(3 * i);
    if (n < last || n >= hierarchy.nodes.size())
      list.fail("entry " + std::to_string(3 * i) + " must name a node, ascending");
    last = n;
    SeparationNode& node = hierarchy.nodes[n];
    if (node.pair_count++ == 0) node.first_pair = static_cast<std::uint32_t>(i);
    hierarchy.pairs.push_back(
        {list.whole<std::uint8_t>(3 * i + 1), list.whole<std::uint8_t>(3 * i + 2)});
  }
}

void read_choices(const Node& node, PriorityHierarchy& hierarchy) {
  const Node list = node["choices"];
  for (std::size_t c = 0; c < list.size(); ++c) {
    const Node row = list.entry(c);
    const std::size_t numbers = row.rows(1);
    if (numbers < 4) row.fail("must hold a sphere and thresholds");
    PreparedChoice& choice = hierarchy.choices.emplace_back();
    choice.sphere = sphere(row, 0);
    for (std::size_t i = 4; i < numbers; ++i) choice.thresholds.push_back(row.number(i));
  }
  const Node groups = node["choice_groups"];
  for (std::size_t i = 0; i < groups.rows(2); ++i) {
    const auto group = groups.whole<std::uint32_t>(2 * i);
    if (group >= hierarchy.groups.size() || hierarchy.groups[group].choice != kNone)
      groups.fail("entry " + std::to_string(2 * i) + " must name a group, each once");
    hierarchy.groups[group].choice = groups.whole<std::uint32_t>(2 * i + 1);
  }
}

PriorityHierarchy read_hierarchy(const Node& node) {
  PriorityHierarchy hierarchy;
  hierarchy.planes = planes(node);
  const Node nodes = node["nodes"];
  hierarchy.nodes.resize(nodes.rows(5));
  for (std::size_t i = 0; i < hierarchy.nodes.size(); ++i)
    hierarchy.nodes[i] = {nodes.whole<std::uint32_t>(5 * i), nodes.whole<std::int32_t>(5 * i + 1),
                          nodes.whole<std::int32_t>(5 * i + 2),
                          nodes.whole<std::uint64_t>(5 * i + 3),
                          nodes.whole<std::uint64_t>(5 * i + 4)};
  if (node.has("pairs")) read_pairs(node["pairs"], hierarchy);
  const Node members = node["members"], spheres = node["spheres"];
  hierarchy.members.resize(members.rows(2));
  expect_rows(spheres, 4, hierarchy.members.size());
  for (std::size_t i = 0; i < hierarchy.members.size(); ++i) {
    const auto kind = members.whole<std::uint32_t>(2 * i);
    if (kind > 2) members.fail("entry " + std::to_string(2 * i) + " must be 0, 1 or 2");
    hierarchy.members[i] = {kind == 1, members.whole<std::uint32_t>(2 * i + 1),
                            sphere(spheres, 4 * i), kind == 2};
  }
  const Node groups = node["groups"];
  hierarchy.groups.resize(groups.rows(4));
  for (std::size_t i = 0; i < hierarchy.groups.size(); ++i)
    hierarchy.groups[i] = {
        groups.whole<std::uint32_t>(4 * i), groups.whole<std::uint32_t>(4 * i + 1),
        groups.whole<std::uint32_t>(4 * i + 2), groups.whole<std::uint32_t>(4 * i + 3)};
  if (node.has("choices")) read_choices(node, hierarchy);
  return hierarchy;
}

PreparedSystem read_system(const Node& node) {
  PreparedSystem system;
  system.name = node["name"].text();
  const Node place = node["placement"];
  expect_rows(place, 6, 1);
  system.placement = placement(place, 0);
  const Node motion = node["motion"];
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Node row = motion.entry(i);
    expect_rows(row, 7, 1);
    system.motion.push_back({row.number(0), placement(row, 1)});
  }
  const Node bounds = node["sphere"];
  expect_rows(bounds, 4, 1);
  system.sphere = sphere(bounds, 0);
  system.set = read_set(node["set"]);
  system.hierarchy = read_hierarchy(node["hierarchy"]);
  return system;
}

DefaultView read_view(const Node& node) {
  const Node eye = node["eye"], attitude = node["attitude"];
  expect_rows(eye, 3, 1);
  expect_rows(attitude, 3, 1);
  return {{eye.vector(0), attitude.number(0), attitude.number(1), attitude.number(2)},
          node["fov"].number()};
}

PreparationReport read_report(const Node& node) {
  PreparationReport report;
  const auto count = [&](const char* key) { return node[key].whole<std::uint64_t>(); };
  report.objects = count("objects");
  report.faces = count("faces");
  report.vertices = count("vertices");
  report.convex_objects = count("convex_objects");
  report.unclosed_objects = count("unclosed_objects");
  report.items = count("items");
  report.pieces = count("pieces");
  report.cuts = count("cuts");
  report.planes = count("planes");
  report.groups = count("groups");
  report.depth = count("depth");
  report.pairs = count("pairs");
  if (node.has("choices")) report.choices = count("choices");
  report.seconds = node["seconds"].number();
  const Node notices = node["notices"];
  for (std::size_t i = 0; i < notices.size(); ++i) {
    expect_rows(notices.entry(i), 2, 1);
    report.notices.push_back(
        {notices.entry(i).entry(0).text(), notices.entry(i).whole<std::uint64_t>(1)});
  }
  return report;
}

}  // namespace

Database database_from_json(const Json& value) {
  const Node root(value, "");
  if (!value.is_object() || !value.contains(kDatabaseTag))
    throw DatabaseFault("this is not a prepared database; make one with cigsim prepare");
  if (root[kDatabaseTag].whole<std::uint64_t>() != kDatabaseVersion)
    root[kDatabaseTag].fail(
        "is a version that this program does not read; prepare the scene again");
  Database database;
  database.name = root["name"].text();
  const Node names = root["object_names"];
  database.object_count = static_cast<std::uint32_t>(names.rows(1));
  for (std::size_t i = 0; i < names.size(); ++i)
    database.object_names.push_back(names.entry(i).text());
  const Node background = root["background"];
  database.background = colour(background, background.whole<std::uint32_t>());
  database.view = read_view(root["view"]);
  const Node systems = root["systems"];
  for (std::size_t i = 0; i < systems.size(); ++i)
    database.systems.push_back(read_system(systems.entry(i)));
  database.ground = read_set(root["ground"]);
  database.report = read_report(root["report"]);
  return database;
}

}  // namespace cigsim
