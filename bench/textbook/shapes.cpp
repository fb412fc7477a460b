#include "textbook/shapes.h"

#include <cmath>

namespace dapple::textbook {

bool SphereObject::hit(const Ray& ray, double t_min, double t_max, HitRecord& record) const {
  const Vec3d from_centre = ray.origin - centre_;
  const double a = dot(ray.direction, ray.direction);
  const double half_b = dot(from_centre, ray.direction);
  const double c = dot(from_centre, from_centre) - radius_ * radius_;
  const double discriminant = half_b * half_b - a * c;
  if (discriminant < 0) return false;
  const double root = std::sqrt(discriminant);
  double t = (-half_b - root) / a;
  if (t < t_min || t > t_max) {
    t = (-half_b + root) / a;
    if (t < t_min || t > t_max) return false;
  }
  record.t = t;
  record.point = ray.at(t);
  record.set_normal(ray, (record.point - centre_) / radius_);
  record.material = material_;
  return true;
}

Box SphereObject::bounding_box() const {
  const double r = std::fabs(radius_);
  return {centre_ - Vec3d(r, r, r), centre_ + Vec3d(r, r, r)};
}

bool RectangleObject::hit(const Ray& ray, double t_min, double t_max, HitRecord& record) const {
  const double t = (rectangle_.k - ray.origin[axes_.k]) * ray.inverse[axes_.k];
  if (!(t >= t_min && t <= t_max)) return false;
  const Vec3d point = ray.at(t);
  const double u = point[axes_.u], v = point[axes_.v];
  if (u < rectangle_.u0 || u > rectangle_.u1 || v < rectangle_.v0 || v > rectangle_.v1) {
    return false;
  }
  Vec3d outward;
  outward[axes_.k] = 1;
  record.t = t;
  record.point = point;
  record.set_normal(ray, outward);
  record.material = material_;
  return true;
}

// A little thicker than nothing, so that no slab is empty.
Box RectangleObject::bounding_box() const {
  constexpr double kPadding = 1e-4;
  Box box;
  box.lo[axes_.u] = rectangle_.u0;
  box.hi[axes_.u] = rectangle_.u1;
  box.lo[axes_.v] = rectangle_.v0;
  box.hi[axes_.v] = rectangle_.v1;
  box.lo[axes_.k] = rectangle_.k - kPadding;
  box.hi[axes_.k] = rectangle_.k + kPadding;
  return box;
}

}  // namespace dapple::textbook
