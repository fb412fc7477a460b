#include "import/scene_extent.h"

namespace dapple {

void Extent::include(const Vec3d& p) {
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = p[axis] < low[axis] ? p[axis] : low[axis];
    high[axis] = p[axis] > high[axis] ? p[axis] : high[axis];
  }
}

double Extent::diagonal() const { return low.x <= high.x ? length(high - low) : 0; }

Extent extent_of(const Scene& scene, const std::vector<Triangle>& prototype_triangles) {
  Extent extent;
  const auto& positions = scene.vertices.positions;
  for (const Triangle& triangle : scene.triangles) {
    for (const std::uint32_t i : triangle.vertices) extent.include(Vec3d(positions[i]));
  }
  std::vector<Extent> boxes;
  for (const Prototype& prototype : scene.prototypes) {
    Extent& box = boxes.emplace_back();
    for (std::uint32_t t = 0; t < prototype.triangle_count; ++t) {
      const Triangle& triangle = prototype_triangles[prototype.first_triangle + t];
      for (const std::uint32_t i : triangle.vertices) box.include(Vec3d(positions[i]));
    }
  }
  for (const Instance& instance : scene.instances) {
    for (int corner = 0; corner < 8; ++corner) {
      const Extent& box = boxes[instance.prototype];
      const Vec3d p(corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                    corner & 4 ? box.high.z : box.low.z);
      extent.include(instance.to_world.point(p));
    }
  }
  for (const Sphere& sphere : scene.spheres) {
    const double r = std::fabs(sphere.radius);
    extent.include(sphere.centre - Vec3d(r, r, r));
    extent.include(sphere.centre + Vec3d(r, r, r));
  }
  for (const Cylinder& cylinder : scene.cylinders) {
    extent.include(cylinder.begin);
    extent.include(cylinder.end);
  }
  return extent;
}

}  // namespace dapple
