// The definition of a hit, one primitive at a time. Every kernel of every width computes exactly
// these operations in this order, so that all ways of finding hits agree to the last bit.
//
// Own-box rule: a hit counts only if the slab test passes on the primitive's own box, and not
// before the ray enters that box. Rounding is monotone, so the ray then passes the box of every
// ancestor too, no later than the hit: which tree was built, or none, makes no difference.
#pragma once

#include <cmath>
#include <limits>

#include "accel/hit.h"
#include "accel/intersect_cylinder.h"
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

// The same for boxes of trees and of triangles: a ray leaves them a little later.
inline Slab padded_interval(const PreparedRay& ray, const float lo[3], const float hi[3]) {
  float near = ray.t_min, far = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const bool up = ray.inverse[axis] >= 0.0f;
    near = larger(near, ((up ? lo : hi)[axis] - ray.origin[axis]) * ray.inverse[axis]);
    far = smaller(far, ((up ? hi : lo)[axis] - ray.origin[axis]) * ray.inverse_far[axis]);
  }
  return {near, far};
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

// Where a ray meets the plane of a triangle, by the areas on its three sides as the ray sees them.
struct TriangleWeights {
  float of[3];     // of the vertices; not yet divided by their sum
  float ahead[3];  // how far along the ray's own z each vertex is
  float sum;
};

// In the ray's own frame, sheared so that the ray is its z axis, the vertices are points of a
// plane, and the same points for every triangle that shares them. The sign of each area is that of
// the exact area of the rounded points, or zero, which counts as inside: so no ray slips through
// between triangles that share an edge or a vertex [WoopBW13].
inline TriangleWeights weigh_triangle(const PreparedRay& ray, const float v[9]) {
  const std::uint32_t kz = ray.axis, kx = next_axis(kz), ky = next_axis(kx);
  TriangleWeights result;
  float x[3], y[3];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const float z = v[3 * i + kz] - ray.origin[kz];
    x[i] = (v[3 * i + kx] - ray.origin[kx]) - ray.shear[0] * z;
    y[i] = (v[3 * i + ky] - ray.origin[ky]) - ray.shear[1] * z;
    result.ahead[i] = z;
  }
  result.of[0] = x[2] * y[1] - y[2] * x[1];
  result.of[1] = x[0] * y[2] - y[0] * x[2];
  result.of[2] = x[1] * y[0] - y[1] * x[0];
  result.sum = (result.of[0] + result.of[1]) + result.of[2];
  return result;
}

inline float intersect_triangle(const PreparedRay& ray, const float v[9], float t_max) {
  const TriangleWeights weights = weigh_triangle(ray, v);
  const float u0 = weights.of[0], u1 = weights.of[1], u2 = weights.of[2];
  const bool inside = smaller(smaller(u0, u1), u2) >= 0.0f || larger(larger(u0, u1), u2) <= 0.0f;
  if (!inside || !(std::fabs(weights.sum) > 0.0f)) return kMiss;
  const float scale = 1.0f / weights.sum;
  const float* ahead = weights.ahead;
  const float z = ((u0 * scale) * ahead[0] + (u1 * scale) * ahead[1]) + (u2 * scale) * ahead[2];
  const float t = z * ray.inverse[ray.axis];
  if (!(t >= ray.t_min)) return kMiss;
  float lo[3], hi[3];
  for (int axis = 0; axis < 3; ++axis) {
    lo[axis] = smaller(smaller(v[axis], v[3 + axis]), v[6 + axis]);
    hi[axis] = larger(larger(v[axis], v[3 + axis]), v[6 + axis]);
  }
  // Where a long thin triangle is seen from its edge, its box knows the distance better.
  const Slab box = padded_interval(ray, lo, hi);
  const float clamped = smaller(larger(t, box.near), box.far);
  return box.near <= box.far && clamped <= t_max ? clamped : kMiss;
}

// Where a ray enters the box of an instance, or kMiss.
inline float enter_instance_box(const PreparedRay& ray, const float numbers[6], float t_max) {
  const Slab box = padded_interval(ray, numbers, numbers + 3);
  return box.near <= smaller(box.far, t_max) ? box.near : kMiss;
}

// Whether `a` counts before `b` at the same distance: what stands in the world, then what is seen
// through instances, by the order of these; then the lower id.
inline bool precedes(const Hit& a, const Hit& b) {
  if (!b.found()) return true;
  const std::uint32_t through_a = a.lane.seen_through(), through_b = b.lane.seen_through();
  return through_a != through_b ? through_a < through_b : a.prim < b.prim;
}

// A hit inside an instance as the world sees it: not before the ray enters the instance's own box.
// What is nearest inside was decided before, without regard to that box.
inline void keep_seen_through(std::size_t instance, float entry, Hit inside, Hit& best) {
  if (!inside.found()) return;
  inside.t = larger(inside.t, entry);
  inside.lane = inside.lane.through(instance);
  if (inside.t < best.t || (inside.t == best.t && precedes(inside, best))) best = inside;
}

// Primitive `lane` of a leaf, whatever its kind but an instance.
inline float intersect_lane(const PreparedRay& ray, const LeafRow* rows, LeafRef lane,
                            float t_max) {
  const auto number = [&](std::size_t k) { return leaf_float(rows, lane, k); };
  if (lane.kind() == ShapeKind::sphere) {
    return intersect_sphere(ray, number(0), number(1), number(2), number(3), t_max);
  }
  if (!is_rectangle(lane.kind())) {
    float numbers[9];
    for (std::size_t i = 0; i < leaf_id_row(lane.kind()); ++i) numbers[i] = number(i);
    return lane.kind() == ShapeKind::triangle ? intersect_triangle(ray, numbers, t_max)
                                              : intersect_cylinder(ray, numbers, t_max);
  }
  return intersect_rectangle(ray, rectangle_axes(lane.kind()), number(0), number(1), number(2),
                             number(3), number(4), t_max);
}

}  // namespace dapple
