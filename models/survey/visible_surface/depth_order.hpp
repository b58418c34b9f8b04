// SPDX-License-Identifier: MIT
// Which of two faces is nearer: in double with an error bound, and in rational arithmetic where
// that leaves a doubt.
#pragma once

#include "models/survey/visible_surface/face_list.hpp"

namespace cigsim::survey {

class DepthOrder {
 public:
  explicit DepthOrder(const FaceList& list) : list_(list) {}

  /// Face `a` is seen in front of face `b` at element (x, y), where both cover it.
  bool nearer(std::uint32_t a, std::uint32_t b, int x, int y) const {
    const SurveyFace &fa = list_.faces[a], &fb = list_.faces[b];
    if (fa.rank != fb.rank) return fa.rank < fb.rank;
    if (fa.plane == fb.plane) return a < b;
    return sign(fa.plane, fb.plane, x, y) > 0;
  }

  /// Sign of the depth of plane `p` less that of plane `q` at element (x, y), the sample moved a
  /// little right and much less down; not 0 when the planes differ.
  int sign(std::uint32_t p, std::uint32_t q, int x, int y) const {
    const RoundedPlane &a = list_.rounded[p], &b = list_.rounded[q];
    const double difference = (a.a * x + a.b * y + a.c) - (b.a * x + b.b * y + b.c);
    const double slack = a.slack + b.slack;
    if (difference > slack) return 1;
    if (difference < -slack) return -1;
    return exact_sign(p, q, x, y);
  }

  /// The same at a place, without the move: 0 when they meet there.
  int sign(std::uint32_t p, std::uint32_t q, const RasterPlace& at) const;

  /// Decisions that needed rational arithmetic.
  std::uint64_t exact_tests() const { return exact_tests_; }

 private:
  int exact_sign(std::uint32_t p, std::uint32_t q, int x, int y) const;

  const FaceList& list_;
  mutable std::uint64_t exact_tests_ = 0;
};

}  // namespace cigsim::survey
