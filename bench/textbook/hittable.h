// The classes of a textbook ray tracer: everything a ray can hit has a virtual hit().
#pragma once

#include <optional>

#include "math/vec3.h"
#include "scene/material.h"

namespace dapple::textbook {

struct Ray {
  Vec3d origin;
  Vec3d direction;
  Vec3d inverse;  // 1 / direction, once for all boxes

  Ray(const Vec3d& o, const Vec3d& d)
      : origin(o), direction(d), inverse(1 / d.x, 1 / d.y, 1 / d.z) {}
  Vec3d at(double t) const { return origin + t * direction; }
};

struct HitRecord {
  double t = 0;
  Vec3d point;
  Vec3d normal;  // unit, on the side the ray came from
  bool from_outside = true;
  const Material* material = nullptr;

  void set_normal(const Ray& ray, const Vec3d& outward) {
    from_outside = dot(ray.direction, outward) < 0;
    normal = from_outside ? outward : -outward;
  }
};

struct Box {
  Vec3d lo, hi;

  bool hit(const Ray& ray, double t_min, double t_max) const;
};
[[nodiscard]] Box surrounding(const Box& a, const Box& b);

class Hittable {
 public:
  virtual ~Hittable() = default;
  // Fills the record with the nearest hit in [t_min, t_max], if there is one.
  virtual bool hit(const Ray& ray, double t_min, double t_max, HitRecord& record) const = 0;
  virtual Box bounding_box() const = 0;
};

// One axis at a time, leaving at the first that shows a miss.
inline bool Box::hit(const Ray& ray, double t_min, double t_max) const {
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = ray.inverse[axis];
    double t0 = (lo[axis] - ray.origin[axis]) * inverse;
    double t1 = (hi[axis] - ray.origin[axis]) * inverse;
    if (inverse < 0) {
      const double t = t0;
      t0 = t1;
      t1 = t;
    }
    t_min = t0 > t_min ? t0 : t_min;
    t_max = t1 < t_max ? t1 : t_max;
    if (t_max < t_min) return false;
  }
  return true;
}

}  // namespace dapple::textbook
