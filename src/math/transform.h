// Affine maps: three rows of four numbers, the last column the translation.
#pragma once

#include "math/vec3.h"

namespace dapple {

template <class T>
struct Transform {
  T rows[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

  template <class U>
  constexpr Vec3<U> point(const Vec3<U>& p) const {
    return vector(p) + Vec3<U>(U(rows[0][3]), U(rows[1][3]), U(rows[2][3]));
  }
  // A direction or difference of points: not translated.
  template <class U>
  constexpr Vec3<U> vector(const Vec3<U>& v) const {
    return {U(rows[0][0]) * v.x + U(rows[0][1]) * v.y + U(rows[0][2]) * v.z,
            U(rows[1][0]) * v.x + U(rows[1][1]) * v.y + U(rows[1][2]) * v.z,
            U(rows[2][0]) * v.x + U(rows[2][1]) * v.y + U(rows[2][2]) * v.z};
  }
  // By the transposed linear part: what turns normals when this is the inverse of their map.
  template <class U>
  constexpr Vec3<U> transposed_vector(const Vec3<U>& v) const {
    return {U(rows[0][0]) * v.x + U(rows[1][0]) * v.y + U(rows[2][0]) * v.z,
            U(rows[0][1]) * v.x + U(rows[1][1]) * v.y + U(rows[2][1]) * v.z,
            U(rows[0][2]) * v.x + U(rows[1][2]) * v.y + U(rows[2][2]) * v.z};
  }
  friend constexpr bool operator==(const Transform&, const Transform&) = default;
};

using Transformf = Transform<float>;
using Transformd = Transform<double>;

constexpr Transformd to_double(const Transformf& m) {
  Transformd result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) result.rows[i][j] = double{m.rows[i][j]};
  }
  return result;
}

// a after b.
template <class T>
constexpr Transform<T> operator*(const Transform<T>& a, const Transform<T>& b) {
  Transform<T> c;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      c.rows[i][j] = a.rows[i][0] * b.rows[0][j] + a.rows[i][1] * b.rows[1][j] +
                     a.rows[i][2] * b.rows[2][j] + (j == 3 ? a.rows[i][3] : T(0));
    }
  }
  return c;
}

// Of the linear part; negative when the map mirrors, zero when it has no inverse.
template <class T>
constexpr T determinant(const Transform<T>& m) {
  const auto& r = m.rows;
  return r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) -
         r[0][1] * (r[1][0] * r[2][2] - r[1][2] * r[2][0]) +
         r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
}

// The determinant must not be zero.
template <class T>
constexpr Transform<T> inverse(const Transform<T>& m) {
  const auto& r = m.rows;
  const T scale = T(1) / determinant(m);
  Transform<T> inv;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      inv.rows[i][j] = (r[a][c] * r[b][d] - r[a][d] * r[b][c]) * scale;
    }
  }
  for (int i = 0; i < 3; ++i) {
    inv.rows[i][3] =
        -(inv.rows[i][0] * r[0][3] + inv.rows[i][1] * r[1][3] + inv.rows[i][2] * r[2][3]);
  }
  return inv;
}

}  // namespace dapple
