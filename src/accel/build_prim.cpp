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

HugeArray<BuildPrim> make_build_prims(const SceneView& scene, const PrototypeBoxes& prototypes) {
  HugeArray<BuildPrim> prims(scene.object_count());
  const auto first_ids = first_prim_ids(scene);
  BuildPrim* to = prims.data();
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    const std::size_t count = scene.object_count(kind);
    parallel_for_chunks(count, kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        to[i] = make_prim(shape_bounds(scene, prototypes, kind, i), first_ids[k] + i);
      }
    });
    to += count;
  }
  return prims;
}

HugeArray<BuildPrim> make_prototype_prims(const SceneView& scene, const Prototype& prototype) {
  HugeArray<BuildPrim> prims(prototype.triangle_count);
  const std::size_t first_id = first_prim_ids(scene)[static_cast<std::size_t>(ShapeKind::triangle)];
  parallel_for_chunks(prims.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t index = prototype.first_triangle + i;
      prims[i] = make_prim(triangle_bounds(scene, scene.triangles[index]), first_id + index);
    }
  });
  return prims;
}

}  // namespace dapple
