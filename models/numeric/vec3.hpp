// SPDX-License-Identifier: MIT
// Vectors of three coordinates over any number type of the project.
#pragma once

namespace cigsim {

template <class N>
struct Vec3T {
  N x{}, y{}, z{};

  friend Vec3T operator+(const Vec3T& a, const Vec3T& b) {
    return {N(a.x + b.x), N(a.y + b.y), N(a.z + b.z)};
  }
  friend Vec3T operator-(const Vec3T& a, const Vec3T& b) {
    return {N(a.x - b.x), N(a.y - b.y), N(a.z - b.z)};
  }
  friend Vec3T operator*(const Vec3T& a, const N& s) {
    return {N(a.x * s), N(a.y * s), N(a.z * s)};
  }
  friend bool operator==(const Vec3T& a, const Vec3T& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }
};

template <class N>
N dot(const Vec3T<N>& a, const Vec3T<N>& b) {
  return N(a.x * b.x + a.y * b.y + a.z * b.z);
}

template <class N>
Vec3T<N> cross(const Vec3T<N>& a, const Vec3T<N>& b) {
  return {N(a.y * b.z - a.z * b.y), N(a.z * b.x - a.x * b.z), N(a.x * b.y - a.y * b.x)};
}

using Vec3 = Vec3T<double>;

/// Rows of a 3 × 3 matrix; `m * p` takes the three dot products.
template <class N>
struct Mat3T {
  Vec3T<N> row[3];

  friend Vec3T<N> operator*(const Mat3T& m, const Vec3T<N>& p) {
    return {dot(m.row[0], p), dot(m.row[1], p), dot(m.row[2], p)};
  }
};

using Mat3 = Mat3T<double>;

}  // namespace cigsim
