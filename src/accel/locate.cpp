#include "accel/locate.h"

#include <cmath>

#include "accel/intersect_scalar.h"

namespace dapple {
namespace {

// The normal is taken from the ray as the centre sees it, which keeps the digits that a position
// far from the origin has lost. A ball so small that none are left gets one that faces the ray.
SurfacePoint locate_on_sphere(const Ray& ray, float t, const Vec3f& centre, float radius) {
  const Vec3f radial = (ray.origin - centre) + t * ray.direction;
  const float squared = dot(radial, radial);
  const bool has_digits = squared >= kSmallestNormal;
  const Vec3f normal = has_digits ? radial / std::sqrt(squared) : -normalize(ray.direction);
  const float size = std::fabs(radius);
  SurfacePoint point;
  point.position = centre + size * normal;  // back onto the sphere: t has the error of its root
  point.outward = radius < 0.0f ? -normal : normal;
  point.error = kPositionError * (max_abs_component(centre) + size);
  return point;
}

SurfacePoint locate_on_rectangle(Vec3f position, RectangleAxes axes, float k) {
  SurfacePoint point;
  position[axes.k] = k;
  point.position = position;
  point.outward[axes.k] = 1.0f;
  point.error = kPositionError * max_abs_component(position);
  return point;
}

SurfacePoint locate_on_triangle(const Ray& input, const float* v) {
  const PreparedRay ray = prepare(input);
  const TriangleWeights weights = weigh_triangle(ray, v);
  const float scale = 1.0f / weights.sum;
  const Vec3f a(v[0], v[1], v[2]), b(v[3], v[4], v[5]), c(v[6], v[7], v[8]);
  const Vec3f to_b = b - a, to_c = c - a;
  SurfacePoint point;
  point.u = weights.of[1] * scale;
  point.v = weights.of[2] * scale;
  point.position = (a + point.u * to_b) + point.v * to_c;
  // Of edges of about unit length, so that small triangles keep their digits.
  const float size = 1.0f / larger(max_abs_component(to_b), max_abs_component(to_c));
  const Vec3f normal = cross(size * to_b, size * to_c);
  const float squared = dot(normal, normal);
  const bool has_digits = squared >= kSmallestNormal;
  point.outward = has_digits ? normal / std::sqrt(squared) : -normalize(input.direction);
  point.error = kTrianglePositionError *
                larger(larger(max_abs_component(a), max_abs_component(b)), max_abs_component(c));
  return point;
}

// On the side or an end, whichever is nearer to where the ray is.
SurfacePoint locate_on_cylinder(const Ray& ray, float t, const float* numbers) {
  const Vec3f begin(numbers[0], numbers[1], numbers[2]), end(numbers[3], numbers[4], numbers[5]);
  const double radius = std::fabs(double{numbers[6]});
  const Vec3d from = (Vec3d(ray.origin) - Vec3d(begin)) + double{t} * Vec3d(ray.direction);
  const Vec3d whole = Vec3d(end) - Vec3d(begin);
  const double size = length(whole);
  const Vec3d axis = whole / size;
  const double along = dot(from, axis);
  const Vec3d across = from - along * axis;
  const double off_axis = length(across);
  const double to_side = std::fabs(off_axis - radius);
  Vec3d normal, at;
  if (off_axis > 0 && to_side <= std::fabs(along) && to_side <= std::fabs(along - size)) {
    normal = across / off_axis;
    at = along * axis + radius * normal;
  } else {
    const bool at_begin = std::fabs(along) <= std::fabs(along - size);
    normal = at_begin ? -axis : axis;
    at = (at_begin ? 0.0 : size) * axis + across;
  }
  SurfacePoint point;
  point.position = Vec3f(Vec3d(begin) + at);
  point.outward = Vec3f(normal);
  point.error = kPositionError *
                (larger(max_abs_component(begin), max_abs_component(end)) + std::fabs(numbers[6]));
  return point;
}

// The numbers of a shape as they stand in a whole leaf.
void read_lane(const LeafArrays& leaves, LeafRef lane, float numbers[kMaxLeafRows]) {
  if (lane.kind() == ShapeKind::triangle && leaves.form() == LeafForm::compact) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3f& position = leaves.positions[leaf_word(leaves.rows, lane, i)];
      for (int axis = 0; axis < 3; ++axis) *numbers++ = position[axis];
    }
    return;
  }
  for (std::size_t i = 0; i < leaf_id_row(lane.kind()); ++i) {
    numbers[i] = leaf_float(leaves.rows, lane, i);
  }
}

SurfacePoint locate_in_world(const LeafArrays& leaves, const Ray& ray, float t, LeafRef lane) {
  const ShapeKind kind = lane.kind();
  float numbers[kMaxLeafRows];
  read_lane(leaves, lane, numbers);
  if (kind == ShapeKind::sphere) {
    return locate_on_sphere(ray, t, {numbers[0], numbers[1], numbers[2]}, numbers[3]);
  }
  if (kind == ShapeKind::triangle) return locate_on_triangle(ray, numbers);
  if (kind == ShapeKind::cylinder) return locate_on_cylinder(ray, t, numbers);
  return locate_on_rectangle(ray.at(t), rectangle_axes(kind), numbers[4]);
}

// A point of the prototype's space as the world has it. What is round stays exact to the rounding
// of the map, and errors grow by no more than its norm.
SurfacePoint leave_instance(const PlacedInstance& instance, const Ray& ray, SurfacePoint point) {
  const auto& m = instance.to_world.rows;
  const Vec3f p = point.position;
  float squares = 0, largest = 0;
  for (int i = 0; i < 3; ++i) {
    squares += m[i][0] * m[i][0] + m[i][1] * m[i][1] + m[i][2] * m[i][2];
    largest = larger(largest, (std::fabs(m[i][0] * p.x) + std::fabs(m[i][1] * p.y)) +
                                  (std::fabs(m[i][2] * p.z) + std::fabs(m[i][3])));
  }
  point.position = instance.to_world.point(p);
  point.error = std::sqrt(squares) * point.error + kPositionError * largest;
  const Vec3f turned = instance.to_object.transposed_vector(point.outward);
  const float size = max_abs_component(turned);
  const bool has_digits = size >= kSmallestNormal && size <= std::numeric_limits<float>::max();
  point.outward = has_digits ? normalize(turned / size) : -normalize(ray.direction);
  return point;
}

}  // namespace

SurfacePoint locate_hit(const LeafArrays& leaves, const PlacedInstance* instances, const Ray& ray,
                        float t, LeafRef lane) {
  if (!lane.in_instance()) return locate_in_world(leaves, ray, t, lane);
  const PlacedInstance& instance = instances[lane.instance_index()];
  const Ray inside = enter_instance(instance, &ray.origin.x, &ray.direction.x);
  return leave_instance(instance, ray, locate_in_world(leaves, inside, t, lane));
}

void locate_lane(const LeafArrays& leaves, const PlacedInstance* instances, float* numbers,
                 std::size_t stride, std::uint64_t lane) {
  Ray ray;
  for (int axis = 0; axis < 3; ++axis) {
    ray.origin[axis] = numbers[static_cast<std::size_t>(axis) * stride];
    ray.direction[axis] = numbers[static_cast<std::size_t>(3 + axis) * stride];
  }
  LeafRef ref;
  ref.bits = lane;
  const SurfacePoint at = locate_hit(leaves, instances, ray, numbers[6 * stride], ref);
  for (int axis = 0; axis < 3; ++axis) {
    numbers[static_cast<std::size_t>(axis) * stride] = at.position[axis];
    numbers[static_cast<std::size_t>(3 + axis) * stride] = at.outward[axis];
  }
  numbers[6 * stride] = at.error;
}

}  // namespace dapple
