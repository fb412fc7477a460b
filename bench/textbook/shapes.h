// Spheres and axis-aligned rectangles, each an object of its own.
#pragma once

#include "scene/shapes.h"
#include "textbook/hittable.h"

namespace dapple::textbook {

class SphereObject final : public Hittable {
 public:
  SphereObject(const Sphere& sphere, const Material& material)
      : centre_(sphere.centre), radius_(sphere.radius), material_(&material) {}
  bool hit(const Ray& ray, double t_min, double t_max, HitRecord& record) const override;
  Box bounding_box() const override;

 private:
  Vec3d centre_;
  double radius_;
  const Material* material_;
};

class RectangleObject final : public Hittable {
 public:
  RectangleObject(ShapeKind kind, const Rectangle& rectangle, const Material& material)
      : axes_(rectangle_axes(kind)), rectangle_(rectangle), material_(&material) {}
  bool hit(const Ray& ray, double t_min, double t_max, HitRecord& record) const override;
  Box bounding_box() const override;

 private:
  RectangleAxes axes_;
  Rectangle rectangle_;
  const Material* material_;
};

}  // namespace dapple::textbook
