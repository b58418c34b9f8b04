// SPDX-License-Identifier: MIT
// Newell, Newell and Sancha 1972, as Sandor 1979 (sec. 5.2) tells it: faces in the order of their
// farthest points, written from the far end, so that nearer faces write over farther ones.
//
// The tests that a face must pass before it is written are those of the 1972 paper: against each
// face whose depth overlaps its own, extents along the line and across, behind the other's plane,
// the other in front of its own plane, elements in common. A face that stands in the way is moved
// before it, once. Where that leads round in a circle (cyclic overlap, or faces that pass through
// each other) a face is divided, as published, by the plane of the one in its way.
//
// Reconstruction: a circle can also close over faces of which neither divides the other, when it
// has more than two members. Some member is then divided by the plane of the face in hand: going
// round, one begins in front of that plane and ends behind it.
#include <algorithm>
#include <list>
#include <stdexcept>
#include <utility>

#include "models/survey/visible_surface/newell_piece.hpp"

namespace cigsim::survey {
namespace {

using Pieces = std::list<Piece>;

class Newell {
 public:
  Newell(const FaceList& list, FacePicture& out, Work& work)
      : list_(list), order_(list), out_(out), work_(work), tests_(list, order_, work) {}

  void run() {
    for (std::uint32_t f = 0; f < list_.faces.size(); ++f)
      if (list_.faces[f].end_element > 0) pieces_.push_back(piece_of(list_, f));
    work_.faces += pieces_.size();
    ++work_.sorts;
    pieces_.sort([this](const Piece& a, const Piece& b) {
      ++work_.comparisons;
      return sorted(a, b);
    });
    while (!pieces_.empty()) {
      const auto q = in_the_way();
      if (q == pieces_.end()) {
        write(pieces_.front());
        pieces_.pop_front();
      } else if (!q->moved &&
                 (tests_.behind(*q, pieces_.front()) || tests_.before(pieces_.front(), *q))) {
        q->moved = true;
        pieces_.splice(pieces_.begin(), pieces_, q);
      } else {
        divide_near(q);
      }
    }
    work_.exact_tests += order_.exact_tests();
  }

 private:
  static bool sorted(const Piece& a, const Piece& b) {
    return a.rank != b.rank ? a.rank > b.rank : a.far < b.far;
  }

  // The first piece that the one in front of the list must not be written before. The ground has
  // its order already.
  Pieces::iterator in_the_way() {
    const Piece& p = pieces_.front();
    if (p.rank != 0) return pieces_.end();
    for (auto q = std::next(pieces_.begin()); q != pieces_.end(); ++q) {
      if (!q->moved && q->far > p.near) break;  // and so are all after it
      if (tests_.blocks(p, *q)) return q;
    }
    return pieces_.end();
  }

  void divide_near(Pieces::iterator q) {
    const auto p = pieces_.begin();
    if (tests_.divides(q->plane, *p)) return replace(p, q->plane);
    if (tests_.divides(p->plane, *q)) return replace(q, p->plane);
    for (auto x = std::next(p); x != pieces_.end(); ++x)
      if (x->moved && tests_.divides(p->plane, *x)) return replace(x, p->plane);
    throw std::logic_error("faces without an order that no plane divides");
  }

  // Divides a piece; its parts and all that were moved find their places by depth again.
  void replace(Pieces::iterator at, std::uint32_t plane) {
    ++work_.subdivisions;
    Pieces loose;
    for (Piece& made : divide(list_, order_, *at, plane)) loose.push_back(std::move(made));
    pieces_.erase(at);
    for (auto x = pieces_.begin(); x != pieces_.end();) {
      const auto moved = x++;
      if (!moved->moved) continue;
      moved->moved = false;
      loose.splice(loose.end(), pieces_, moved);
    }
    const auto counted = [this](const Piece& a, const Piece& b) {
      ++work_.comparisons;
      return sorted(a, b);
    };
    loose.sort(counted);
    pieces_.merge(loose, counted);
  }

  void write(const Piece& piece) {
    for (std::size_t r = 0; r < piece.rows.size(); ++r) {
      const Row& row = piece.rows[r];
      if (row.first == row.end) continue;
      ++work_.segments;
      out_.fill(piece.first_line + static_cast<int>(r), row.first, row.end, piece.face, work_);
    }
  }

  const FaceList& list_;
  const DepthOrder order_;
  FacePicture& out_;
  Work& work_;
  PieceTests tests_;
  Pieces pieces_;
};

}  // namespace

void newell(const FaceList& list, FacePicture& out, Work& work) {
  out.clear(list.raster);
  Newell(list, out, work).run();
}

}  // namespace cigsim::survey
