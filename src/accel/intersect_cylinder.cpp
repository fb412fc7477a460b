#include "accel/intersect_cylinder.h"

#include "accel/intersect_scalar.h"
#include "math/vec3.h"

namespace dapple {
namespace {

struct Interval {
  double near = -std::numeric_limits<double>::infinity();
  double far = std::numeric_limits<double>::infinity();

  bool empty() const { return !(near <= far); }
  void cut(double from, double to) {
    if (from > near) near = from;
    if (to < far) far = to;
  }
};

constexpr Interval kNever = {1, 0};

// Where a ray from `from`, measured from the first end, is between the planes of both ends.
Interval between_ends(const Vec3d& from, const Vec3d& direction, const Vec3d& axis) {
  const double along = dot(direction, axis), at = dot(from, axis), length = dot(axis, axis);
  if (along == 0) return at >= 0 && at <= length ? Interval{} : kNever;
  const double begin = -at / along, end = (length - at) / along;
  return along > 0 ? Interval{begin, end} : Interval{end, begin};
}

// Where it is within the endless cylinder, from the point of the ray nearest the axis.
Interval within_side(const Vec3d& from, const Vec3d& direction, const Vec3d& axis, double radius) {
  const double length = dot(axis, axis);
  const Vec3d d = direction - (dot(direction, axis) / length) * axis;
  const Vec3d o = from - (dot(from, axis) / length) * axis;
  const double a = dot(d, d);
  if (!(a > 1e-28 * dot(direction, direction))) {
    return dot(o, o) <= radius * radius ? Interval{} : kNever;
  }
  const double middle = -dot(o, d) / a;
  const Vec3d nearest = o + middle * d;
  const double squared = radius * radius - dot(nearest, nearest);
  if (!(squared >= 0)) return kNever;
  const double half_chord = std::sqrt(squared / a);
  return {middle - half_chord, middle + half_chord};
}

}  // namespace

float intersect_cylinder(const PreparedRay& ray, const float numbers[7], float t_max) {
  const Vec3d begin(Vec3f(numbers[0], numbers[1], numbers[2]));
  const Vec3d axis = Vec3d(Vec3f(numbers[3], numbers[4], numbers[5])) - begin;
  const double radius = std::fabs(double{numbers[6]});
  if (!(radius > 0 && dot(axis, axis) > 0)) return kMiss;
  const Vec3d from = Vec3d(Vec3f(ray.origin[0], ray.origin[1], ray.origin[2])) - begin;
  const Vec3d direction(Vec3f(ray.direction[0], ray.direction[1], ray.direction[2]));
  Interval inside = between_ends(from, direction, axis);
  const Interval side = within_side(from, direction, axis, radius);
  inside.cut(side.near, side.far);
  if (inside.empty()) return kMiss;
  const auto first = static_cast<float>(inside.near), last = static_cast<float>(inside.far);
  const float t = first >= ray.t_min ? first : last;
  if (!(t >= ray.t_min && t <= t_max)) return kMiss;
  float lo[3], hi[3];
  for (int axis_index = 0; axis_index < 3; ++axis_index) {
    const float a = numbers[axis_index], b = numbers[3 + axis_index];
    lo[axis_index] = smaller(a, b) - std::fabs(numbers[6]);
    hi[axis_index] = larger(a, b) + std::fabs(numbers[6]);
  }
  const Slab box = padded_interval(ray, lo, hi);
  const float clamped = larger(t, box.near);
  return box.near <= box.far && clamped <= t_max ? clamped : kMiss;
}

}  // namespace dapple
