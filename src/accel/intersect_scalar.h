// The definition of a hit, one primitive at a time. Every kernel of every width computes exactly
// these operations in this order, so that all ways of finding hits agree to the last bit.
//
// Own-box rule: a hit counts only if the slab test passes on the primitive's own box, and not
// before the ray enters that box. Rounding is monotone, so the ray then passes the box of every
// ancestor too, no later than the hit: which tree was built, or none, makes no difference.
#pragma once

#include <cmath>

#include "accel/prepared_ray.h"
#include "scene/leaf.h"

namespace dapple {

// Distances at which a ray enters and leaves the slab [lo, hi] of one axis.
struct Slab {
  float near, far;
};

inline Slab slab(float lo, float hi, float origin, float inverse) {
  const float to_lo = (lo - origin) * inverse;
  const float to_hi = (hi - origin) * inverse;
  return inverse >= 0.0f ? Slab{to_lo, to_hi} : Slab{to_hi, to_lo};
}

inline float larger(float a, float b) { return a > b ? a : b; }
inline float smaller(float a, float b) { return a < b ? a : b; }

// Entry and exit of a box for t >= t_min; a miss when near > far.
inline Slab box_interval(const PreparedRay& ray, const float lo[3], const float hi[3]) {
  const Slab x = slab(lo[0], hi[0], ray.origin[0], ray.inverse[0]);
  const Slab y = slab(lo[1], hi[1], ray.origin[1], ray.inverse[1]);
  const Slab z = slab(lo[2], hi[2], ray.origin[2], ray.inverse[2]);
  return {larger(larger(x.near, y.near), larger(z.near, ray.t_min)),
          smaller(smaller(x.far, y.far), z.far)};
}

inline constexpr float kMiss = -1.0f;

// The distance of the hit in [t_min, t_max], or kMiss. The discriminant is taken from the point of
// the ray nearest the centre, which keeps its digits for small and distant spheres [HaineGA19].
inline float intersect_sphere(const PreparedRay& ray, float cx, float cy, float cz, float radius,
                              float t_max) {
  const float ox = ray.origin[0] - cx, oy = ray.origin[1] - cy, oz = ray.origin[2] - cz;
  const float* d = ray.direction;
  const float t_mid = -((ox * d[0] + oy * d[1] + oz * d[2]) * ray.inverse_dot);
  const float px = ox + t_mid * d[0], py = oy + t_mid * d[1], pz = oz + t_mid * d[2];
  const float discriminant = radius * radius - (px * px + py * py + pz * pz);
  if (!(discriminant > 0.0f)) return kMiss;
  const float half_chord = std::sqrt(discriminant * ray.inverse_dot);
  const float first = t_mid - half_chord;
  const float t = first >= ray.t_min ? first : t_mid + half_chord;
  if (!(t >= ray.t_min && t <= t_max)) return kMiss;
  const float r = std::fabs(radius);
  const float lo[3] = {cx - r, cy - r, cz - r};
  const float hi[3] = {cx + r, cy + r, cz + r};
  const Slab box = box_interval(ray, lo, hi);
  const float clamped = larger(t, box.near);
  return box.near <= box.far && clamped <= t_max ? clamped : kMiss;
}

// A rectangle is its own box, so the slab test is the whole test.
inline float intersect_rectangle(const PreparedRay& ray, RectangleAxes axes, float u0, float u1,
                                 float v0, float v1, float k, float t_max) {
  if (std::fabs(ray.direction[axes.k]) < kSmallestDirection) return kMiss;
  const float t = (k - ray.origin[axes.k]) * ray.inverse[axes.k];
  const Slab u = slab(u0, u1, ray.origin[axes.u], ray.inverse[axes.u]);
  const Slab v = slab(v0, v1, ray.origin[axes.v], ray.inverse[axes.v]);
  const float near = larger(larger(u.near, v.near), ray.t_min);
  const float far = smaller(smaller(u.far, v.far), t_max);
  return t >= near && t <= far ? t : kMiss;
}

// Primitive `lane` of a leaf, whatever its kind.
inline float intersect_lane(const PreparedRay& ray, const LeafRow* rows, LeafRef lane,
                            float t_max) {
  const auto number = [&](std::size_t k) { return leaf_float(rows, lane, k); };
  if (lane.kind() == ShapeKind::sphere) {
    return intersect_sphere(ray, number(0), number(1), number(2), number(3), t_max);
  }
  return intersect_rectangle(ray, rectangle_axes(lane.kind()), number(0), number(1), number(2),
                             number(3), number(4), t_max);
}

}  // namespace dapple
