// SPDX-License-Identifier: MIT
// Levine's hidden-line algorithm (Levine 1975, ch. VI.F; counters of app. III).
//
// For a frame: the SO matrix tells for each pair of objects who may hide whom; edges are back,
// front or extreme; an object has a window on the raster. The invisibility of one vertex of an
// object is the number of objects that cover it, found by the parity of crossings of a ray with
// extreme edges; from there it is carried along the edges, where each crossing of an extreme edge
// of an object that may hide changes it by one, to the other vertices.
//
// All tests on projections are exact on the given coordinates, eyepoint and view (eye.hpp). Where a
// test of the source has no answer (a vertex on an edge, edges in line, objects that reach behind
// the eye, pairs that no plane parts) the pair is decided by shadows (cover.hpp). An object with
// the eye inside, or on its surface, is not seen and hides nothing, as in the rest of the machine.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "models/hidden_line/cover.hpp"
#include "models/hidden_line/part.hpp"
#include "models/hidden_line/sepl.hpp"

namespace cigsim::hidden_line {

/// Levine 1975, app. III: A to K of a frame. `inv` is for the invisibility calculation.
struct Counters {
  std::uint64_t front_faces = 0;                 ///< FF
  std::uint64_t objects_considered_inv = 0;      ///< OC/I
  std::uint64_t objects_in_window_inv = 0;       ///< OW/I
  std::uint64_t edges_considered_inv = 0;        ///< EEC/I
  std::uint64_t intersections_computed_inv = 0;  ///< IC/I
  std::uint64_t edges_displayed = 0;             ///< ED
  std::uint64_t objects_considered = 0;          ///< OC/HL
  std::uint64_t objects_in_window = 0;           ///< OW/HL
  std::uint64_t edges_considered = 0;            ///< EEC/HL
  std::uint64_t intersections_computed = 0;      ///< IC/HL
  std::uint64_t actual_intersections = 0;        ///< AI/HL
  // Ours.
  std::uint64_t decided_by_shadow = 0;  ///< pairs of an edge or vertex and an object
  std::uint64_t exact = 0;              ///< questions that needed whole numbers
  friend bool operator==(const Counters&, const Counters&) = default;
};

/// A piece of an edge that is visible, or hidden, throughout. 0 <= from < to <= 1 from the edge's a
/// to its b in space.
struct Piece {
  std::uint32_t part = 0, edge = 0;
  double from = 0, to = 1;
  bool visible = true;
};

class HiddenLines {
 public:
  /// Vertices that no displayed edge reaches.
  static constexpr int kUnknown = -1;

  /// `candidates` are separation planes to try first. Throws std::invalid_argument for a part
  /// without vertices or edges, and for more than kMostParts parts.
  explicit HiddenLines(PartSet set, std::span<const Plane> candidates = {},
                       const SeplLimits& limits = {});
  static constexpr std::size_t kMostParts = 20000;

  const std::vector<Part>& parts() const { return set_.parts; }
  const Sepl& sepl() const { return sepl_; }

  /// Works out a frame. `with_hidden`: hidden pieces and back edges too.
  void compute(const ViewTransform& view, bool with_hidden = false);

  const std::vector<Piece>& pieces() const { return pieces_; }
  const Counters& counters() const { return counters_; }
  /// By how many objects the vertex is covered, or kUnknown.
  int invisibility(std::size_t part, std::size_t vertex) const {
    return seen_[part].invisibility[vertex];
  }
  /// Vertices that two edges reach with different counts: 0, or the method is broken.
  std::uint64_t disagreements() const { return disagreements_; }

 private:
  struct Window {
    double left = 0, right = 0, low = 0, high = 0;
    bool meets(const Window& o) const {
      return left <= o.right && o.left <= right && low <= o.high && o.low <= high;
    }
  };
  enum class EdgeKind : std::uint8_t { kBack, kFront, kExtreme };

  struct SeenPart {
    bool active = false, ahead = false;
    std::vector<SeenPoint> points;
    std::vector<std::int8_t> front;  ///< a face each: 1 seen from its front, -1 from its back
    std::vector<EdgeKind> kind;      ///< an edge each
    std::vector<char> display;       ///< an edge each
    std::vector<int> invisibility;   ///< a vertex each
    Window window;
    std::vector<Shadow> cells;
    std::vector<OutlinePlane> concave;  ///< the outline, when cells are several
    std::vector<Window> rectangles;     ///< of the outline's edges
    const std::vector<OutlinePlane>& outline() const {
      return cells.size() == 1 ? cells.front().outline : concave;
    }
  };
  struct Hider {
    const SeenPart* part = nullptr;
    bool by_depth = false;
  };
  struct Event {
    Crossing at;
    int change = 0;
  };

  void see(std::size_t index);
  void classify_faces(const Part& part, SeenPart& seen);
  void classify_solid(const Part& part, SeenPart& seen);
  void classify_figure(std::size_t index);
  void resolve_seams();
  void make_cells(std::size_t index);
  void make_windows(std::size_t index);
  void find_hiders(std::size_t index);
  void process(std::size_t index);
  int invisibility_of(const SeenPoint& vertex);
  bool covered_by(const Hider& hider, const SeenPoint& vertex);
  void process_edge(std::size_t index, std::uint32_t edge, std::uint32_t from);
  void meet(const Hider& hider, const SeenPoint& a, const SeenPoint& b, const Window& rectangle);
  bool meet_regularly(const Hider& hider, const SeenPoint& a, const SeenPoint& b,
                      const Window& rectangle);
  void meet_shadow(const Hider& hider, const SeenPoint& a, const SeenPoint& b);
  int walk(std::size_t index, std::uint32_t edge, bool reversed, int count);
  static Window window_of(const SeenPoint& a, const SeenPoint& b);

  PartSet set_;
  Sepl sepl_;
  std::vector<std::vector<std::vector<std::uint32_t>>> edges_at_;  ///< by part and vertex
  std::vector<SeenPart> seen_;
  std::vector<char> seam_closed_;
  Eye eye_;
  bool with_hidden_ = false;
  Counters counters_;
  std::vector<Piece> pieces_;
  std::uint64_t disagreements_ = 0;
  std::vector<Hider> hiders_;  ///< of the part at work, those whose window meets its own
  std::uint64_t hider_count_ = 0;
  std::vector<Event> events_;
  std::vector<Interval> intervals_;
  std::vector<std::uint32_t> stack_;
  std::vector<char> done_;
};

}  // namespace cigsim::hidden_line
