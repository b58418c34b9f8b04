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
#include "models/geometry_processor/certified_clip.hpp"
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
  // A point of the raster, each coordinate off by less than `error`, and the first line whose
  // sample is not above it, which is certain.
  struct Place {
    double x = 0, y = 0, error = 0;
    int line = 0;
  };

  void start(const ViewTransform& view);
  void transform(const FaceSet& set, const Item& item);
  CertifiedPoint viewpoint_position(const Vec3& vertex) const;
  void classify(const FaceSet& set, const Item& item, std::uint32_t i);
  void classify_exactly(const FaceSet& set, std::uint32_t vertex, std::uint32_t i);
  int first_line(const Place& place, const Dyadic& u, const Dyadic& w) const;
  Place project(const CertifiedPoint& p) const;
  bool find_line(Place& place) const;

  void process(const FaceSet& set, const Item& item, std::uint32_t face, EdgeList<Certified>& out);
  void process_exactly(const FaceSet& set, const Item& item, const PreparedFace& face,
                       EdgeList<Certified>& out);
  bool clip(const FaceSet& set, const Item& item, const PreparedFace& face, std::uint8_t sides);
  bool place_loop();
  void begin_face(const PreparedFace& face, const EdgeList<Certified>& out);
  void add_edge(const Place& a, const Place& b, const LoopLine& line, const Item& item, bool front,
                EdgeList<Certified>& out);
  void end_face(EdgeList<Certified>& out);

  const double caution_;
  const ViewTransform* view_ = nullptr;
  SetId set_id_ = SetId::kStatic;
  double half_width_ = 0, half_height_ = 0;
  double unit_ = 0;       // error of a coordinate for each unit of the vertex's distance
  double cut_unit_ = 0;   // and of its position, in a set where cuts have been rounded
  double least_ = 0;      // what underflow may add to it
  double projected_ = 0;  // error of a place for each unit of a coordinate's, at scale 1
  double rounding_ = 0;   // of what is computed on the raster, in elements

  CertifiedClip clip_;
  std::vector<CertifiedPoint> points_;  // by vertex of the item
  std::vector<Place> places_;           // where codes_ is 0
  std::vector<std::uint8_t> codes_;
  std::uint8_t all_codes_ = 0;
  std::vector<LoopCorner> loop_;
  std::vector<Place> loop_places_;
  RasterFace made_;
  double twice_area_ = 0;
  GeometryRedone redone_;

  Functional<Exact> exact_;
  EdgeList<Exact> exact_edges_;
  FaceSet one_face_;  // for exact_
};

}  // namespace cigsim::geometry_processor
