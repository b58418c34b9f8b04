// SPDX-License-Identifier: MIT
#include "models/survey/clipping/observer.hpp"

#include <cmath>
#include <numbers>

namespace cigsim::survey {
namespace {

struct Turn {
  double s, c;
  explicit Turn(double degrees)
      : s(std::sin(degrees * std::numbers::pi / 180)),
        c(std::cos(degrees * std::numbers::pi / 180)) {}
};

Mat3 product(const Mat3& a, const Mat3& b) {
  Mat3 out;
  for (int r = 0; r < 3; ++r)
    out.row[r] = b.row[0] * a.row[r].x + b.row[1] * a.row[r].y + b.row[2] * a.row[r].z;
  return out;
}

}  // namespace

Mat3 observer_rotation(const ObserverAngles& angles) {
  const Turn y(angles.theta1), x(angles.theta2), z(angles.theta3);
  const Mat3 about_y{{{y.c, 0, -y.s}, {0, 1, 0}, {y.s, 0, y.c}}};
  const Mat3 about_x{{{1, 0, 0}, {0, x.c, x.s}, {0, -x.s, x.c}}};
  const Mat3 about_z{{{z.c, z.s, 0}, {-z.s, z.c, 0}, {0, 0, 1}}};
  return product(about_z, product(about_x, about_y));
}

std::array<std::array<double, 4>, 4> observer_matrix(const Vec3& o, const ObserverAngles& angles) {
  const Turn t1(angles.theta1), t2(angles.theta2), t3(angles.theta3);
  const double s1 = t1.s, c1 = t1.c, s2 = t2.s, c2 = t2.c, s3 = t3.s, c3 = t3.c;
  return {{{s3 * s2 * s1 + c3 * c1, s3 * c2, s3 * c1 * s2 - c3 * s1,
            -o.x * (c3 * c1 + s3 * s2 * s1) - o.y * s3 * c2 - o.z * (s3 * c1 * s2 - c3 * s1)},
           {c3 * s2 * s1 - c1 * s3, c3 * c2, c3 * c1 * s2 + s3 * s1,
            o.x * (c1 * s3 - c3 * s2 * s1) - o.y * c3 * c2 - o.z * (s3 * s1 + c3 * c1 * s2)},
           {s1 * c2, -s2, c2 * c1, -o.x * s1 * c2 + o.y * s2 - o.z * c2 * c1},
           {0, 0, 0, 1}}};
}

}  // namespace cigsim::survey
