// The definition of a hit (accel/intersect_scalar.h), applied to every object in turn, without
// any structure or SIMD: what every way of finding hits must return bit for bit.
#pragma once

#include <vector>

#include "accel/hit.h"
#include "accel/intersect_scalar.h"
#include "scene/scene_view.h"

namespace dapple::test {

class ScalarOracle {
 public:
  explicit ScalarOracle(const SceneView& scene) {
    for (const Sphere& s : scene.spheres) {
      const Vec3f c(s.centre);
      prims_.push_back({ShapeKind::sphere, {c.x, c.y, c.z, static_cast<float>(s.radius), 0}});
    }
    for (std::size_t kind = 0; kind < kRectangleKindCount; ++kind) {
      for (const Rectangle& r : scene.rectangles[kind]) {
        prims_.push_back(
            {rectangle_kind(kind),
             {static_cast<float>(r.u0), static_cast<float>(r.u1), static_cast<float>(r.v0),
              static_cast<float>(r.v1), static_cast<float>(r.k)}});
      }
    }
    for (const Triangle& t : scene.triangles) {
      Prim prim{ShapeKind::triangle, {}};
      for (std::size_t i = 0; i < 9; ++i) {
        prim.numbers[i] = scene.vertices.positions[t.vertices[i / 3]][static_cast<int>(i % 3)];
      }
      prims_.push_back(prim);
    }
  }

  // All but the hit's lane, which only a structure has.
  Hit intersect(const Ray& input) const {
    const PreparedRay ray = prepare(input);
    Hit best;
    best.t = ray.t_max;
    for (PrimId id = 0; id < prims_.size(); ++id) {
      const float t = intersect(ray, prims_[id], best.t);
      // In ascending order of ids an equal distance never replaces the first.
      if (t >= 0 && (t < best.t || !best.found())) best = {t, id, {}};
    }
    return best.found() ? best : Hit{};
  }

 private:
  struct Prim {
    ShapeKind kind;
    float numbers[9];
  };

  static float intersect(const PreparedRay& ray, const Prim& prim, float t_max) {
    const float* n = prim.numbers;
    if (prim.kind == ShapeKind::sphere) return intersect_sphere(ray, n[0], n[1], n[2], n[3], t_max);
    if (prim.kind == ShapeKind::triangle) return intersect_triangle(ray, n, t_max);
    return intersect_rectangle(ray, rectangle_axes(prim.kind), n[0], n[1], n[2], n[3], n[4], t_max);
  }

  std::vector<Prim> prims_;
};

}  // namespace dapple::test
