// SPDX-License-Identifier: MIT
// The project's own scene format (docs/scene-format.md): JSON, or the same document as CBOR.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "models/environment/detail.hpp"
#include "models/environment/document_value.hpp"
#include "models/environment/read.hpp"
#include "models/environment/text_file.hpp"

namespace cigsim {
namespace {

using Kind = Document::Kind;
using Value = DocumentValue;
using Members = DocumentMembers;

Vec3 read_vec3(const Value& value, std::string_view what) {
  double c[3] = {};
  std::size_t n = 0;
  value.for_each_element(what, [&](const Value& v) {
    const double number = v.number(what);
    if (n < 3) c[n] = number;
    ++n;
  });
  if (n != 3) value.fail(std::string(what) + " must have 3 numbers, not " + std::to_string(n));
  return {c[0], c[1], c[2]};
}

Colour read_colour(const Value& value, std::string_view what) {
  std::uint8_t c[3] = {};
  std::size_t n = 0;
  value.for_each_element(what, [&](const Value& v) {
    const auto number = static_cast<std::uint8_t>(v.whole(what, 256));
    if (n < 3) c[n] = number;
    ++n;
  });
  if (n != 3) value.fail(std::string(what) + " must have 3 numbers, not " + std::to_string(n));
  return {c[0], c[1], c[2]};
}

/// Position and attitude, either of which may be missing (then zero).
Placement read_placement(const Members& members) {
  Placement placement;
  if (const auto v = members.find("position")) placement.position = read_vec3(*v, "a position");
  if (const auto v = members.find("attitude")) {
    const Vec3 angles = read_vec3(*v, "an attitude");
    placement.heading = angles.x;
    placement.pitch = angles.y;
    placement.roll = angles.z;
  }
  return placement;
}

std::vector<MotionKey> read_motion(const Value& value) {
  std::vector<MotionKey> motion;
  value.for_each_element("a motion", [&](const Value& v) {
    const Members members(v, "a motion key", {"frame", "position", "attitude"});
    const Value frame = members.get("frame");
    motion.push_back({frame.number("a frame"), read_placement(members)});
    if (motion.size() > 1 && !(motion[motion.size() - 2].frame < motion.back().frame))
      frame.fail("frames of a motion must ascend; put the keys in order and each frame once");
  });
  if (motion.empty()) value.fail("a motion needs at least one key; leave it out to stand still");
  return motion;
}

DefaultView read_view(const Value& value) {
  const Members members(value, "the view", {"eye", "look_at", "attitude", "fov"});
  DefaultView view;
  view.eye = read_placement(members);
  view.eye.position = read_vec3(members.get("eye"), "the eye");
  if (const auto look_at = members.find("look_at")) {
    if (members.find("attitude"))
      look_at->fail("the view has both look_at and attitude; keep one of them");
    const Vec3 d = read_vec3(*look_at, "look_at") - view.eye.position;
    const double ground = std::hypot(d.x, d.y);
    if (ground == 0 && d.z == 0) look_at->fail("look_at is the eye itself; move one of them");
    constexpr double kDegrees = 180 / std::numbers::pi;
    view.eye.heading = std::atan2(d.x, d.y) * kDegrees;
    view.eye.pitch = std::atan2(d.z, ground) * kDegrees;
  }
  if (const auto fov = members.find("fov")) {
    view.fov = fov->number("fov");
    if (!(view.fov > 0 && view.fov < 180))
      fov->fail("fov must lie between 0 and 180 degrees, both excluded");
  }
  return view;
}

Sun read_sun(const Value& value) {
  const Members members(value, "the sun", {"azimuth", "elevation"});
  Sun sun;
  if (const auto v = members.find("azimuth")) sun.azimuth = v->number("an azimuth");
  if (const auto v = members.find("elevation")) sun.elevation = v->number("an elevation");
  return sun;
}

std::size_t distinct(std::vector<std::uint32_t> indices) {
  std::sort(indices.begin(), indices.end());
  return static_cast<std::size_t>(std::unique(indices.begin(), indices.end()) - indices.begin());
}

Face read_face(const Value& value, std::size_t vertices) {
  Face face;
  Value indices = value;
  if (value.kind() == Kind::object) {
    const Members members(value, "a face", {"vertices", "colour"});
    indices = members.get("vertices");
    if (const auto v = members.find("colour")) face.colour = read_colour(*v, "a colour");
  }
  indices.require(Kind::array, "a face's list of vertices");
  face.vertices.reserve(indices.count());
  indices.for_each_element("a face", [&](const Value& v) {
    if (vertices == 0) v.fail("a face names a vertex, but its object has none");
    face.vertices.push_back(static_cast<std::uint32_t>(v.whole("a vertex of a face", vertices)));
  });
  const std::size_t n = distinct(face.vertices);
  if (n < 3)
    indices.fail("a face needs at least 3 different vertices, not " + std::to_string(n) +
                 "; correct or remove it");
  return face;
}

/// What the objects and models refer to by number; checked when the whole scene is read.
struct Reference {
  Value value;
  std::uint64_t index;
};

struct PlacedPair {
  Value value;
  ObjectPair pair;
};

class SceneReader {
 public:
  explicit SceneReader(const Document& document) : root_(document, 0) {}

  ReadResult read() {
    root_.require(Kind::object, "the scene");
    check_version();
    const Members members(root_, "the scene",
                          {"cigsim", "name", "background", "view", "sun", "systems", "models",
                           "objects", "ground", "separation"});
    members.for_each([&](std::string_view key, const Value& value) { member(key, value); });
    check_references();
    check_pairs();
    if (environment_.objects.empty() && environment_.ground.empty())
      root_.fail("holds no object and no ground; add \"objects\" or \"ground\"");
    if (empty_objects_ > 0) result_.notices.push_back({"objects without faces", empty_objects_});
    return std::move(result_);
  }

 private:
  void check_version() const {
    std::optional<Value> version;
    root_.for_each_member("the scene", [&](const std::string& key, const Value&, const Value& v) {
      if (key == "cigsim") version = v;
    });
    if (!version)
      root_.fail("is no cigsim scene: key \"cigsim\" is missing; begin with {\"cigsim\": 1, ...");
    if (version->kind() != Kind::whole || version->whole("cigsim", UINT64_MAX) != 1)
      version->fail(
          "this version of the scene format is unknown; this program reads \"cigsim\": 1");
  }

  void member(std::string_view key, const Value& value) {
    if (key == "name") environment_.name = value.text("a name");
    if (key == "background") environment_.background = read_colour(value, "the background");
    if (key == "view") environment_.view = read_view(value);
    if (key == "sun") environment_.sun = read_sun(value);
    if (key == "ground") read_ground(value);
    if (key == "separation") read_separation(value);
    if (key == "systems")
      value.for_each_element("systems", [&](const Value& v) { read_system(v); });
    if (key == "models")
      value.for_each_element("models", [&](const Value& v) { read_model(v, std::nullopt); });
    if (key == "objects") read_top_objects(value);
  }

  void read_ground(const Value& value) {
    value.for_each_element("the ground", [&](const Value& v) {
      const Members members(v, "a ground face", {"vertices", "colour"});
      GroundFace face;
      const Value vertices = members.get("vertices");
      vertices.for_each_element("vertices", [&](const Value& vertex) {
        face.vertices.push_back(read_vec3(vertex, "a vertex"));
      });
      if (face.vertices.size() < 3)
        vertices.fail("a ground face needs at least 3 vertices, not " +
                      std::to_string(face.vertices.size()));
      face.colour = read_colour(members.get("colour"), "a colour");
      environment_.ground.push_back(std::move(face));
    });
  }

  void read_separation(const Value& value) {
    value.for_each_element("the separation", [&](const Value& v) {
      const Members members(v, "a separation plane", {"normal", "distance", "pairs"});
      SeparationPlane plane;
      plane.normal = read_vec3(members.get("normal"), "a normal");
      if (plane.normal == Vec3{}) v.fail("the normal of a separation plane is zero; correct it");
      plane.distance = members.get("distance").number("a distance");
      const Value pairs = members.get("pairs");
      pairs.for_each_element("pairs", [&](const Value& pair) {
        plane.pairs.push_back(read_pair(pair));
        pairs_.push_back({pair, plane.pairs.back()});
      });
      if (plane.pairs.empty())
        pairs.fail(
            "a separation plane has no pairs; give it [TRUE object, FALSE object] or "
            "remove it");
      environment_.separation.push_back(std::move(plane));
    });
    if (environment_.separation.empty())
      value.fail("the separation has no plane; remove \"separation\" to have planes found");
  }

  static ObjectPair read_pair(const Value& value) {
    std::uint32_t numbers[2] = {};
    std::size_t n = 0;
    value.for_each_element("a pair", [&](const Value& v) {
      const auto number = static_cast<std::uint32_t>(v.whole("an object's number", kMost));
      if (n < 2) numbers[n] = number;
      ++n;
    });
    if (n != 2)
      value.fail("a pair must be [TRUE object, FALSE object], not " + std::to_string(n) +
                 " numbers");
    return {numbers[0], numbers[1]};
  }

  void read_system(const Value& value) {
    const Members members(value, "a system", {"name", "placement", "motion", "models"});
    CoordinateSystem system;
    if (const auto v = members.find("name")) system.name = v->text("a name");
    const auto placement = members.find("placement");
    if (placement)
      system.placement =
          read_placement(Members(*placement, "a placement", {"position", "attitude"}));
    if (const auto v = members.find("motion")) {
      if (placement) v->fail("a system has both placement and motion; keep one of them");
      system.motion = read_motion(*v);
    }
    environment_.systems.push_back(std::move(system));
    const std::size_t number = environment_.systems.size() - 1;
    if (const auto v = members.find("models"))
      v->for_each_element("models", [&](const Value& m) { read_model(m, number); });
  }

  /// A model of the given system, or one of the top that may name its system by number.
  void read_model(const Value& value, std::optional<std::size_t> system) {
    const Members members = system ? Members(value, "a model of a system", {"name", "objects"})
                                   : Members(value, "a model", {"name", "objects", "system"});
    Model model;
    if (const auto v = members.find("name")) model.name = v->text("a name");
    model.system = static_cast<std::uint32_t>(system.value_or(0));
    if (const auto v = members.find("system"); v && !system) {
      model.system = static_cast<std::uint32_t>(v->whole("a system's number", kMost));
      system_references_.push_back({*v, model.system});
    }
    environment_.models.push_back(std::move(model));
    const std::size_t number = environment_.models.size() - 1;
    if (const auto v = members.find("objects"))
      v->for_each_element("objects", [&](const Value& o) { read_entry(o, number, std::nullopt); });
  }

  /// Objects of the top that name no model belong to a nameless model of system 0.
  void read_top_objects(const Value& value) {
    std::optional<std::size_t> nameless;
    value.for_each_element("objects", [&](const Value& v) {
      bool names_model = false;
      v.for_each_member("an object", [&](const std::string& key, const Value&, const Value&) {
        names_model = names_model || key == "model";
      });
      if (!names_model && !nameless) {
        nameless = environment_.models.size();
        environment_.models.push_back({});
      }
      read_entry(v, names_model ? std::nullopt : nameless, std::nullopt);
    });
  }

  /// A list of objects may hold choices too.
  void read_entry(const Value& value, std::optional<std::size_t> model,
                  const std::optional<DescriptionRef>& within) {
    bool choice = false;
    value.for_each_member("an object", [&](const std::string& key, const Value&, const Value&) {
      choice = choice || key == "descriptions";
    });
    choice ? read_choice(value, model, within) : read_object(value, model, within);
  }

  /// The model given, or the one that the entry names.
  std::uint32_t model_of(const Members& members, std::optional<std::size_t> model) {
    if (model) return static_cast<std::uint32_t>(*model);
    const Value v = members.get("model");
    const auto number = static_cast<std::uint32_t>(v.whole("a model's number", kMost));
    model_references_.push_back({v, number});
    return number;
  }

  void read_choice(const Value& value, std::optional<std::size_t> model,
                   const std::optional<DescriptionRef>& within) {
    const Members members = model ? Members(value, "a choice", {"name", "descriptions"})
                                  : Members(value, "a choice", {"name", "model", "descriptions"});
    const auto number = static_cast<std::uint32_t>(environment_.choices.size());
    if (++choices_open_ > kDeepestChoice)
      value.fail("choices stand more than " + std::to_string(kDeepestChoice) +
                 " deep within one another; make fewer levels");
    Choice& choice = environment_.choices.emplace_back();
    if (const auto v = members.find("name")) choice.name = v->text("a name");
    choice.model = model_of(members, model);
    choice.within = within;
    const std::size_t in_model = choice.model;
    const Value list = members.get("descriptions");
    list.require(Kind::array, "descriptions");
    const std::size_t count = list.count();
    if (count == 0 || count > kMostDescriptions)
      list.fail("a choice has 1 to " + std::to_string(kMostDescriptions) + " descriptions, not " +
                std::to_string(count));
    std::uint32_t description = 0;
    list.for_each_element("descriptions", [&](const Value& v) {
      read_description(v, {number, description}, description + 1 == count, in_model);
      ++description;
    });
    --choices_open_;
  }

  void read_description(const Value& value, const DescriptionRef& at, bool last,
                        std::size_t model) {
    const Members members(value, "a description", {"up_to", "objects"});
    const auto up_to = members.find("up_to");
    if (last && up_to)
      up_to->fail(
          "the last description is the most detailed one and has no \"up_to\"; remove it, or add a "
          "description");
    if (!last) add_threshold(up_to, value, environment_.choices[at.choice].thresholds);
    const std::size_t before = environment_.objects.size();
    members.get("objects").for_each_element("objects",
                                            [&](const Value& o) { read_entry(o, model, at); });
    if (last && environment_.objects.size() == before)
      value.fail("the most detailed description holds no object; give it one");
  }

  /// `value` is the description, for what a missing threshold would be.
  static void add_threshold(const std::optional<Value>& up_to, const Value& value,
                            std::vector<double>& thresholds) {
    const double before = thresholds.empty() ? 0 : thresholds.back();
    const double threshold = up_to                ? up_to->number("up_to")
                             : thresholds.empty() ? kFirstThreshold
                                                  : kThresholdStep * before;
    if (!std::isfinite(threshold)) value.fail("the default of \"up_to\" is too large; state it");
    if (!(threshold > before))
      up_to->fail(std::string("up_to must be above ") +
                  (thresholds.empty() ? "0" : "that of the description before") +
                  "; descriptions go from the least detailed to the most detailed");
    thresholds.push_back(threshold);
  }

  void read_object(const Value& value, std::optional<std::size_t> model,
                   const std::optional<DescriptionRef>& within) {
    const Members members =
        model ? Members(value, "an object", {"name", "colour", "vertices", "faces"})
              : Members(value, "an object", {"name", "model", "colour", "vertices", "faces"});
    Object object;
    if (const auto v = members.find("name")) object.name = v->text("a name");
    object.model = model_of(members, model);
    object.within = within;
    std::optional<Colour> colour;
    if (const auto v = members.find("colour")) colour = read_colour(*v, "a colour");
    const Value vertices = members.get("vertices");
    vertices.require(Kind::array, "vertices");
    object.vertices.reserve(vertices.count());
    vertices.for_each_element(
        "vertices", [&](const Value& v) { object.vertices.push_back(read_vec3(v, "a vertex")); });
    const Value faces = members.get("faces");
    faces.require(Kind::array, "faces");
    object.faces.reserve(faces.count());
    faces.for_each_element("faces", [&](const Value& v) {
      Face face = read_face(v, object.vertices.size());
      if (!face.colour) face.colour = colour;
      object.faces.push_back(std::move(face));
    });
    empty_objects_ += object.faces.empty();
    environment_.objects.push_back(std::move(object));
  }

  void check_references() const {
    for (const Reference& r : system_references_)
      if (r.index >= environment_.systems.size())
        r.value.fail("there is no system " + std::to_string(r.index) + "; the last is " +
                     std::to_string(environment_.systems.size() - 1) +
                     " (0 is the environment itself)");
    for (const Reference& r : model_references_)
      if (r.index >= environment_.models.size())
        r.value.fail("there is no model " + std::to_string(r.index) + "; the scene has " +
                     std::to_string(environment_.models.size()) + ", counted from 0");
  }

  void check_pairs() const {
    std::set<std::pair<std::uint32_t, std::uint32_t>> met;
    for (const PlacedPair& p : pairs_) {
      const auto [a, b] = p.pair;
      const std::string name = std::to_string(a) + ", " + std::to_string(b);
      if (a < 1 || b < 1 || std::max(a, b) > environment_.objects.size())
        p.value.fail("pair " + name + " names an object that is not there; objects are numbered " +
                     "from 1 to " + std::to_string(environment_.objects.size()));
      if (a == b) p.value.fail("pair " + name + " is one object; name two");
      if (!met.insert(std::minmax(a, b)).second)
        p.value.fail("pair " + name + " stands twice in the separation; keep one of them");
    }
  }

  static constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();

  Value root_;
  ReadResult result_;
  Environment& environment_ = result_.environment;
  std::vector<Reference> system_references_, model_references_;
  std::vector<PlacedPair> pairs_;
  std::uint64_t empty_objects_ = 0;
  std::size_t choices_open_ = 0;
};

}  // namespace

ReadResult parse_json(std::string_view text, const std::string& name) {
  const Document document = Document::from_json(text, name);
  return SceneReader(document).read();
}

ReadResult read_json(const std::filesystem::path& file) {
  const std::string bytes = read_whole_file(file);
  if (lower_ending(file) != "cbor") return parse_json(bytes, file.string());
  const Document document = Document::from_cbor(bytes, file.string());
  return SceneReader(document).read();
}

}  // namespace cigsim
