// The same scene seen through spans, wherever its arrays live: in a Scene or in a mapped file.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "scene/scene.h"
#include "scene/wide_bvh.h"

namespace dapple {

// Index of a primitive in the concatenation of the shape arrays in the order of ShapeKind. At
// equal distance along a ray the primitive with the lower id is the one that is hit; what is seen
// through an instance counts as the instance there.
using PrimId = std::uint32_t;
inline constexpr PrimId kNoPrim = 0xffffffffu;

struct SceneView {
  Camera camera;
  std::span<const Material> materials;
  std::span<const ObjectRun> runs;
  std::span<const Sphere> spheres;
  std::span<const MaterialId> sphere_materials;
  std::array<std::span<const Rectangle>, kRectangleKindCount> rectangles;
  std::array<std::span<const MaterialId>, kRectangleKindCount> rectangle_materials;
  VertexView vertices;
  std::span<const Triangle> triangles;
  std::span<const MaterialId> triangle_materials;
  std::span<const Cylinder> cylinders;
  std::span<const MaterialId> cylinder_materials;
  std::span<const Prototype> prototypes;
  std::span<const Instance> instances;
  std::span<const LayeredMaterial> layered_materials;
  std::span<const Texture> textures;
  std::span<const TextureImage> images;
  std::span<const std::uint8_t> texels;
  std::span<const Light> lights;
  Environment environment;
  std::span<const NamedCamera> cameras;
  WideBvhView bvh;  // finished BVH of exactly these shapes, or empty

  SceneView() = default;
  SceneView(const Scene& scene);  // implicit: a Scene can be passed wherever a view is read

  // What stands in the world itself: all shapes but the triangles of prototypes.
  std::size_t object_count() const;
  std::size_t object_count(ShapeKind kind) const;
  // All shapes of a kind: as many as it has ids.
  std::size_t count(ShapeKind kind) const;
  // As many as there are shapes; none for instances, whose triangles have their own.
  std::span<const MaterialId> materials_of(ShapeKind kind) const;
};

// How many ids there are.
[[nodiscard]] std::size_t prim_count(const SceneView& scene);

// Where the shapes of one kind begin in the numbering of primitives.
[[nodiscard]] std::array<std::size_t, kShapeKindCount> first_prim_ids(const SceneView& scene);

// Calls visit(kind, index in that kind's array) for each object in stored order.
template <class Visit>
void for_each_object(const SceneView& scene, Visit&& visit) {
  std::array<std::size_t, kShapeKindCount> next{};
  for (const ObjectRun& run : scene.runs) {
    for (std::uint64_t i = 0; i < run.count; ++i) {
      visit(run.kind, next[static_cast<std::size_t>(run.kind)]++);
    }
  }
}

}  // namespace dapple
