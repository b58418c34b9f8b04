// SPDX-License-Identifier: MIT
// The z-buffer: a depth for each element, and each face against it. Sutherland, Sproull and
// Schumacker 1974 set it beside the algorithms that sort, as the plain way.
#include <algorithm>
#include <vector>

#include "models/survey/visible_surface/algorithm.hpp"
#include "models/survey/visible_surface/depth_order.hpp"

namespace cigsim::survey {

void z_buffer(const FaceList& list, FacePicture& out, Work& work) {
  out.clear(list.raster);
  const DepthOrder order(list);
  std::vector<double> depths(out.faces.size());
  const std::size_t width = static_cast<std::size_t>(list.raster.width);
  for (std::uint32_t f = 0; f < list.faces.size(); ++f) {
    const SurveyFace& face = list.faces[f];
    const RoundedPlane& plane = list.rounded[face.plane];
    ++work.faces;
    for (int r = face.first_line; r < face.end_line; ++r) {
      const Row& row = list.row(face, r);
      work.segments += row.first < row.end;
      double* const depth = depths.data() + static_cast<std::size_t>(r) * width;
      std::uint32_t* const seen = out.line(r);
      for (int x = row.first; x < row.end; ++x) {
        const double z = plane.a * x + plane.b * r + plane.c;
        bool nearer = true;
        if (seen[x] != kNone) {
          ++work.depths;
          const SurveyFace& other = list.faces[seen[x]];
          const double slack = plane.slack + list.rounded[other.plane].slack;
          if (other.rank == face.rank && z - depth[x] > slack)
            nearer = true;
          else if (other.rank == face.rank && z - depth[x] < -slack)
            nearer = false;
          else
            nearer = order.nearer(f, seen[x], x, r);
        }
        if (!nearer) continue;
        depth[x] = z;
        seen[x] = f;
        ++work.writes;
      }
    }
  }
  work.exact_tests += order.exact_tests();
}

}  // namespace cigsim::survey
