// Where a ray met a shape, computed from the scene alone.
#pragma once

#include "kernels/tracer.h"
#include "math/bounds3.h"

namespace dapple::bench {

struct Surface {
  Vec3f position;  // moved off the shape by the error of single precision, to the ray's side
  Vec3f normal;    // unit, on the side the ray came from
};

// A primitive id split into its shape array and the index in it.
struct ShapeRef {
  ShapeKind kind = ShapeKind::sphere;
  std::size_t index = 0;
};
[[nodiscard]] ShapeRef shape_of(const SceneView& scene, PrimId prim);

// `found` must be a hit.
[[nodiscard]] Surface surface_at(const SceneView& scene, const Ray& ray, const Found& found);

[[nodiscard]] Bounds3f scene_bounds(const SceneView& scene);

}  // namespace dapple::bench
