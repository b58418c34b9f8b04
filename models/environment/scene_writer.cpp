// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>

#include "models/environment/detail.hpp"
#include "models/environment/scene_entries.hpp"
#include "models/environment/scene_writers.hpp"

namespace cigsim {
namespace {

class SceneWriter {
 public:
  SceneWriter(const Environment& environment, Emitter& out) : environment_(environment), out_(out) {
    check_references();
    nested_ = objects_follow_models();
  }

  void write() {
    const Environment& e = environment_;
    const bool top_models = nested_ ? has_models(0) : !e.models.empty();
    out_.begin_object(3 + e.view.has_value() + e.sun.has_value() + (e.systems.size() > 1) +
                          top_models + (!nested_ && !e.objects.empty()) + !e.ground.empty() +
                          !e.separation.empty(),
                      Layout::lines);
    out_.key("cigsim");
    out_.whole(1);
    out_.key("name");
    out_.text(e.name);
    out_.key("background");
    colour(e.background);
    if (e.view) view(*e.view);
    if (e.sun) sun(*e.sun);
    if (top_models) models(0);
    if (e.systems.size() > 1) systems();
    if (!nested_ && !e.objects.empty()) all_objects();
    if (!e.ground.empty()) ground();
    if (!e.separation.empty()) separation();
    out_.end();
  }

 private:
  void check_references() const {
    for (const Model& m : environment_.models)
      if (m.system >= environment_.systems.size())
        throw std::invalid_argument("model \"" + m.name + "\" names system " +
                                    std::to_string(m.system) + ", which is not there");
    for (const Object& o : environment_.objects)
      if (o.model >= environment_.models.size())
        throw std::invalid_argument("object \"" + o.name + "\" names model " +
                                    std::to_string(o.model) + ", which is not there");
    check_choices(environment_);
  }

  /// True when systems, models and objects stand in one order, so that each can hold the next.
  bool objects_follow_models() const {
    const auto& [objects, models] = std::tie(environment_.objects, environment_.models);
    return std::is_sorted(objects.begin(), objects.end(),
                          [](const Object& a, const Object& b) { return a.model < b.model; }) &&
           std::is_sorted(models.begin(), models.end(),
                          [](const Model& a, const Model& b) { return a.system < b.system; });
  }

  bool has_models(std::uint32_t system) const {
    return std::any_of(environment_.models.begin(), environment_.models.end(),
                       [&](const Model& m) { return m.system == system; });
  }

  void vec3(const Vec3& v) {
    out_.begin_array(3, Layout::one_line);
    out_.number(v.x);
    out_.number(v.y);
    out_.number(v.z);
    out_.end();
  }

  void colour(const Colour& c) {
    out_.begin_array(3, Layout::one_line);
    out_.whole(c.r);
    out_.whole(c.g);
    out_.whole(c.b);
    out_.end();
  }

  void placement_members(const Placement& p, std::string_view position) {
    out_.key(position);
    vec3(p.position);
    out_.key("attitude");
    vec3({p.heading, p.pitch, p.roll});
  }

  void view(const DefaultView& view) {
    out_.key("view");
    out_.begin_object(3, Layout::one_line);
    placement_members(view.eye, "eye");
    out_.key("fov");
    out_.number(view.fov);
    out_.end();
  }

  void sun(const Sun& sun) {
    out_.key("sun");
    out_.begin_object(2, Layout::one_line);
    out_.key("azimuth");
    out_.number(sun.azimuth);
    out_.key("elevation");
    out_.number(sun.elevation);
    out_.end();
  }

  void systems() {
    out_.key("systems");
    out_.begin_array(environment_.systems.size() - 1, Layout::lines);
    for (std::size_t i = 1; i < environment_.systems.size(); ++i) {
      const CoordinateSystem& s = environment_.systems[i];
      const auto number = static_cast<std::uint32_t>(i);
      const bool holds_models = nested_ && has_models(number);
      out_.begin_object(2 + holds_models, Layout::lines);
      out_.key("name");
      out_.text(s.name);
      if (s.motion.empty()) {
        out_.key("placement");
        out_.begin_object(2, Layout::one_line);
        placement_members(s.placement, "position");
        out_.end();
      } else {
        motion(s.motion);
      }
      if (holds_models) models(number);
      out_.end();
    }
    out_.end();
  }

  void motion(const std::vector<MotionKey>& motion) {
    out_.key("motion");
    out_.begin_array(motion.size(), Layout::lines);
    for (const MotionKey& key : motion) {
      out_.begin_object(3, Layout::one_line);
      out_.key("frame");
      out_.number(key.frame);
      placement_members(key.placement, "position");
      out_.end();
    }
    out_.end();
  }

  /// The models of one system with their objects or, when the order forbids that, all models.
  void models(std::uint32_t system) {
    const auto& all = environment_.models;
    out_.key("models");
    out_.begin_array(static_cast<std::uint64_t>(std::count_if(
                         all.begin(), all.end(),
                         [&](const Model& m) { return !nested_ || m.system == system; })),
                     Layout::lines);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (nested_ && all[i].system != system) continue;
      out_.begin_object(2, Layout::lines);
      out_.key("name");
      out_.text(all[i].name);
      if (nested_) {
        objects_of(static_cast<std::uint32_t>(i));
      } else {
        out_.key("system");
        out_.whole(all[i].system);
      }
      out_.end();
    }
    out_.end();
  }

  void objects_of(std::uint32_t model) {
    const auto& all = environment_.objects;
    const auto first =
        std::partition_point(all.begin(), all.end(), [&](auto& o) { return o.model < model; });
    const auto last =
        std::partition_point(first, all.end(), [&](auto& o) { return o.model == model; });
    entries(scene_entries(environment_, static_cast<std::size_t>(first - all.begin()),
                          static_cast<std::size_t>(last - all.begin())),
            true);
  }

  void all_objects() {
    entries(scene_entries(environment_, 0, environment_.objects.size()), nested_);
  }

  /// `known_model`: the entries stand within their model, or within a choice that names it.
  void entries(const std::vector<SceneEntry>& list, bool known_model) {
    out_.key("objects");
    out_.begin_array(list.size(), Layout::lines);
    for (const SceneEntry& entry : list)
      if (entry.is_choice)
        choice(entry, known_model);
      else
        object(environment_.objects[entry.index], known_model);
    out_.end();
  }

  void choice(const SceneEntry& entry, bool known_model) {
    const Choice& choice = environment_.choices[entry.index];
    out_.begin_object(2 + !known_model, Layout::lines);
    name_and_model(choice.name, choice.model, known_model);
    out_.key("descriptions");
    out_.begin_array(entry.descriptions.size(), Layout::lines);
    for (std::size_t d = 0; d < entry.descriptions.size(); ++d) {
      const bool last = d == choice.thresholds.size();
      out_.begin_object(1 + !last, Layout::lines);
      if (!last) {
        out_.key("up_to");
        out_.number(choice.thresholds[d]);
      }
      entries(entry.descriptions[d], true);
      out_.end();
    }
    out_.end();
    out_.end();
  }

  void name_and_model(const std::string& name, std::uint32_t model, bool known_model) {
    out_.key("name");
    out_.text(name);
    if (known_model) return;
    out_.key("model");
    out_.whole(model);
  }

  void object(const Object& object, bool known_model) {
    const auto& faces = object.faces;
    const bool one_colour = std::all_of(faces.begin(), faces.end(), [&](const Face& f) {
      return f.colour == faces.front().colour;
    });
    const bool object_colour = one_colour && !faces.empty() && faces.front().colour;
    out_.begin_object(3 + !known_model + object_colour, Layout::lines);
    name_and_model(object.name, object.model, known_model);
    if (object_colour) {
      out_.key("colour");
      colour(*faces.front().colour);
    }
    vertices(object.vertices, Layout::lines);
    out_.key("faces");
    out_.begin_array(faces.size(), Layout::lines);
    for (const Face& f : faces) face(f, !one_colour && f.colour);
    out_.end();
    out_.end();
  }

  void vertices(const std::vector<Vec3>& vertices, Layout layout) {
    out_.key("vertices");
    out_.begin_array(vertices.size(), layout);
    for (const Vec3& v : vertices) vec3(v);
    out_.end();
  }

  void face(const Face& face, bool with_colour) {
    if (with_colour) {
      out_.begin_object(2, Layout::one_line);
      out_.key("vertices");
    }
    out_.begin_array(face.vertices.size(), Layout::one_line);
    for (const std::uint32_t v : face.vertices) out_.whole(v);
    out_.end();
    if (with_colour) {
      out_.key("colour");
      colour(*face.colour);
      out_.end();
    }
  }

  void ground() {
    out_.key("ground");
    out_.begin_array(environment_.ground.size(), Layout::lines);
    for (const GroundFace& face : environment_.ground) {
      out_.begin_object(2, Layout::one_line);
      vertices(face.vertices, Layout::one_line);
      out_.key("colour");
      colour(face.colour);
      out_.end();
    }
    out_.end();
  }

  void separation() {
    out_.key("separation");
    out_.begin_array(environment_.separation.size(), Layout::lines);
    for (const SeparationPlane& plane : environment_.separation) {
      out_.begin_object(3, Layout::one_line);
      out_.key("normal");
      vec3(plane.normal);
      out_.key("distance");
      out_.number(plane.distance);
      out_.key("pairs");
      out_.begin_array(plane.pairs.size(), Layout::one_line);
      for (const ObjectPair& pair : plane.pairs) {
        out_.begin_array(2, Layout::one_line);
        out_.whole(pair.true_object);
        out_.whole(pair.false_object);
        out_.end();
      }
      out_.end();
      out_.end();
    }
    out_.end();
  }

  const Environment& environment_;
  Emitter& out_;
  bool nested_ = true;
};

}  // namespace

void write_scene(const Environment& environment, Emitter& out) {
  SceneWriter(environment, out).write();
}

}  // namespace cigsim
