// SPDX-License-Identifier: MIT
// The environment: what a scene file says, before any preparation.
//
// Hierarchy after Stump 1986 (ch. II): environment, coordinate system, model, object, face. The
// environment's axes are right-handed: x east, y north, z up, in any unit of length. Coordinates
// are doubles and are taken as exact.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "models/numeric/vec3.hpp"

namespace cigsim {

struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// Position and attitude: heading clockwise from north, pitch up, roll right, in degrees.
struct Placement {
  Vec3 position;
  double heading = 0, pitch = 0, roll = 0;
  friend bool operator==(const Placement&, const Placement&) = default;
};

/// A polygon over its object's vertices, anticlockwise as seen from outside when the object is
/// closed (preparation repairs windings). At least three vertex indices, from 0.
struct Face {
  std::vector<std::uint32_t> vertices;
  std::optional<Colour> colour;  ///< none: the object's colour in the default palette
  friend bool operator==(const Face&, const Face&) = default;
};

/// One of the descriptions of a choice.
struct DescriptionRef {
  std::uint32_t choice = 0;       ///< index into Environment::choices
  std::uint32_t description = 0;  ///< from 0, the least detailed
  friend bool operator==(const DescriptionRef&, const DescriptionRef&) = default;
};

/// A thing that is described several times, from the least to the most detailed: objects and
/// further choices refer to the description that they belong to, and one description is shown at a
/// time (Levine 1975, ch. II.G: the choose-one level of his COCA tree; a description's members are
/// the consider-all level below it).
struct Choice {
  std::string name;
  std::uint32_t model = 0;               ///< index into Environment::models
  std::optional<DescriptionRef> within;  ///< none: it stands in its model itself
  /// Of each description but the most detailed one: the largest projected radius of the choice's
  /// sphere, in elements, at which it is shown. Above 0, ascending strictly.
  std::vector<double> thresholds;
  friend bool operator==(const Choice&, const Choice&) = default;
};

/// A body or surface. Its number is its place in Environment::objects, from 1.
struct Object {
  std::string name;
  std::uint32_t model = 0;  ///< index into Environment::models
  std::vector<Vec3> vertices;
  std::vector<Face> faces;
  std::optional<DescriptionRef> within = {};  ///< none: it is always shown
  friend bool operator==(const Object&, const Object&) = default;
};

/// A named collection of objects that share a coordinate system.
struct Model {
  std::string name;
  std::uint32_t system = 0;  ///< index into Environment::systems
  friend bool operator==(const Model&, const Model&) = default;
};

/// Where a moving system stands at one frame. Between keys position and attitude are interpolated
/// linearly (angles the short way round); before the first and after the last they are held.
struct MotionKey {
  double frame = 0;
  Placement placement;
  friend bool operator==(const MotionKey&, const MotionKey&) = default;
};

/// A coordinate system. System 0 is the environment's own and never moves. A system without motion
/// stands at its placement. A model's axes at attitude 0: x right (east), y ahead (north), z up.
struct CoordinateSystem {
  std::string name;
  Placement placement;
  std::vector<MotionKey> motion;  ///< strictly ascending frames; empty: fixed
  friend bool operator==(const CoordinateSystem&, const CoordinateSystem&) = default;
};

/// A face of the ground. Ground faces have lower priority than every object (Stump 1986, ch. II)
/// and are drawn in their order, later over earlier. Seen from both sides. In pictures of object
/// numbers, ground faces follow the objects: number = objects + place, from 1.
struct GroundFace {
  std::vector<Vec3> vertices;
  Colour colour;
  friend bool operator==(const GroundFace&, const GroundFace&) = default;
};

/// A viewpoint that the scene proposes when the command names none.
struct DefaultView {
  Placement eye;
  double fov = 60;  ///< vertical field of view, degrees
  friend bool operator==(const DefaultView&, const DefaultView&) = default;
};

/// Direction to the sun, for flat shades fixed at preparation (Sandor 1979: the sun's angle changes
/// 60 % of a face's shade). Azimuth clockwise from north, elevation up, degrees.
struct Sun {
  double azimuth = 225, elevation = 45;
  friend bool operator==(const Sun&, const Sun&) = default;
};

/// Two objects that a separation plane parts, by their numbers.
struct ObjectPair {
  std::uint32_t true_object = 0, false_object = 0;
  friend bool operator==(const ObjectPair&, const ObjectPair&) = default;
};

/// A separation plane of a table made by hand, with its TRUE/FALSE pairs (Stump 1986, ch. III): a
/// point p is on the TRUE side where normal . p >= distance. The normal need not be of unit length.
struct SeparationPlane {
  Vec3 normal;
  double distance = 0;
  std::vector<ObjectPair> pairs;
  friend bool operator==(const SeparationPlane&, const SeparationPlane&) = default;
};

struct Environment {
  std::string name;
  std::vector<CoordinateSystem> systems{CoordinateSystem{"environment", {}, {}}};
  std::vector<Model> models;
  std::vector<Object> objects;
  std::vector<Choice> choices;  ///< each after the one that it stands in
  std::vector<GroundFace> ground;
  Colour background{112, 160, 208};
  std::optional<DefaultView> view;
  std::optional<Sun> sun;  ///< none: colours as given
  /// Priority data made by hand; empty: preparation finds its own.
  std::vector<SeparationPlane> separation;
  friend bool operator==(const Environment&, const Environment&) = default;
};

}  // namespace cigsim
