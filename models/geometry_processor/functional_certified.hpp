// SPDX-License-Identifier: MIT
// Geometry processor of certified frames, functional level: doubles with error bounds. Each
// decision (which vertices lie outside a side of the pyramid, on which lines an edge begins and
// ends) is certain, or made again in rational arithmetic: for the one vertex where that will do, or
// for the face. The columns of edges come with their bounds, for whoever steps them to decide with.
// The lists are those of Functional<Exact>, edge by edge and line by line.
//
// The bounds are derived in functional_certified.cpp. Filters of this manner: Shewchuk 1997.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "models/boundary/certified_edges.hpp"
#include "models/geometry_processor/functional.hpp"
#include "models/numeric/dyadic.hpp"

namespace cigsim::geometry_processor {

template <>
class Functional<Certified> {
 public:
  /// What all error bounds are multiplied by: 1. Tests take more, so that more is redone, or 0, so
  /// that rounded decisions are trusted and the frame is not certified at all.
  explicit Functional(double caution = 1) : caution_(caution) {}

  /// Faces come out in the order of `items` and, within an item, in its own order. `out` refers to
  /// the sets.
  void compute(const ViewTransform& view, const FrameSets& sets, std::span<const ItemRef> items,
               EdgeList<Certified>& out);

 private:
  // A vertex in the viewpoint system, each coordinate off by less than `error`.
  struct Point {
    double u = 0, v = 0, w = 0, error = 0;
  };
  // A point of the raster, each coordinate off by less than `error`, and the first line whose
  // sample is not above it, which is certain.
  struct Place {
    double x = 0, y = 0, error = 0;
    int line = 0;
  };
  // The line on which an edge of a loop lies: through two vertices of the item, or with a == kNone
  // the side b of the pyramid.
  struct Line {
    std::uint32_t a = kNone, b = 0;
  };
  // A corner of a loop that is being clipped, and the edge from it to the next.
  struct Corner {
    Point at;
    Line edge;
    std::uint32_t vertex = kNone;  // of the item, if it is one
    std::uint8_t outside = 0;      // a bit a side
    std::uint8_t unknown = 0;      // sides of which `outside` is not yet known
  };

  void start(const ViewTransform& view);
  void transform(const FaceSet& set, const Item& item);
  Point viewpoint_position(const Vec3& vertex) const;
  void classify(const FaceSet& set, const Item& item, std::uint32_t i);
  void classify_exactly(const FaceSet& set, std::uint32_t vertex, std::uint32_t i);
  int first_line(const Dyadic& u, const Dyadic& w) const;
  double distance(int side, const Point& p) const;
  Place project(const Point& p) const;
  bool find_line(Place& place) const;

  void process(const FaceSet& set, const Item& item, std::uint32_t face, EdgeList<Certified>& out);
  void process_exactly(const FaceSet& set, const Item& item, const PreparedFace& face,
                       EdgeList<Certified>& out);
  bool clip(const FaceSet& set, const PreparedFace& face, std::uint8_t sides);
  bool clip_side(int side);
  Corner cut(const Corner& a, const Corner& b, int side) const;
  bool place_loop();
  void begin_face(const PreparedFace& face, const EdgeList<Certified>& out);
  void add_edge(const Place& a, const Place& b, const Line& line, const Item& item, bool front,
                EdgeList<Certified>& out);
  void end_face(EdgeList<Certified>& out);

  const double caution_;
  const ViewTransform* view_ = nullptr;
  SetId set_id_ = SetId::kStatic;
  double half_width_ = 0, half_height_ = 0;
  double unit_ = 0;       // error of a coordinate for each unit of the vertex's distance
  double cut_unit_ = 0;   // and of its position, in a set where cuts have been rounded
  double least_ = 0;      // what underflow may add to it
  double spread_ = 0;     // error of a distance from a side for each unit of a coordinate's
  double projected_ = 0;  // and of a place on the raster, where the scale is 1
  double rounding_ = 0;   // of what is computed on the raster, in elements

  std::vector<Point> points_;  // by vertex of the item
  std::vector<Place> places_;  // where codes_ is 0
  std::vector<std::uint8_t> codes_;
  std::uint8_t all_codes_ = 0;
  std::vector<Corner> loop_, scratch_;
  std::vector<Place> loop_places_;
  RasterFace made_;
  double twice_area_ = 0;
  GeometryRedone redone_;

  Functional<Exact> exact_;
  EdgeList<Exact> exact_edges_;
  FaceSet one_face_;  // for exact_
};

}  // namespace cigsim::geometry_processor
