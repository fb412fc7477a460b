#include "accel/build_prim.h"

#include "parallel/tasks.h"
#include "scene/prims.h"

namespace dapple {
namespace {

constexpr std::size_t kGrain = 1 << 15;

BuildPrim make_prim(const Bounds3f& box, std::size_t id) {
  return {{box.lo.x, box.lo.y, box.lo.z},
          static_cast<PrimId>(id),
          {box.hi.x, box.hi.y, box.hi.z},
          0.0f};
}

}  // namespace

HugeArray<BuildPrim> make_build_prims(const SceneView& scene) {
  HugeArray<BuildPrim> prims(scene.object_count());
  const auto first_ids = first_prim_ids(scene);
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    const std::size_t first = first_ids[k];
    parallel_for_chunks(scene.count(kind), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Bounds3f box =
            kind == ShapeKind::sphere
                ? sphere_bounds(scene.spheres[i])
                : rectangle_bounds(kind, scene.rectangles[rectangle_index(kind)][i]);
        prims[first + i] = make_prim(box, first + i);
      }
    });
  }
  return prims;
}

}  // namespace dapple
