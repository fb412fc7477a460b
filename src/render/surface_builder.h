// From what a ray hit to what shading needs to know of the place.
#pragma once

#include <array>

#include "accel/accel.h"
#include "render/kernels/surface_chunk.h"
#include "scene/scene_view.h"
#include "shading/light_set.h"
#include "shading/surface_interaction.h"

namespace dapple {

// A place on a surface: how shading sees it, what it is made of and which emitter it may be.
struct Surface {
  SurfaceInteraction at;
  MaterialId material{};
  EmitterId emitter;
  float error = 0;  // bound on the distance of at.position from the exact surface
};

class SurfaceBuilder {
 public:
  explicit SurfaceBuilder(const SceneView& scene);

  // `hit` was found by `accel` for `ray`; `cone_width` is the width of the ray cone there.
  Surface build(const Accel& accel, const Ray& ray, const Hit& hit, float cone_width) const;

  MaterialId material_of(const Hit& hit) const;

  // The same by way of a chunk, for triangles that stand in the world themselves.
  bool fits_chunk(const Hit& hit) const {
    return fits_chunks_ && hit.found() && hit.lane.kind() == ShapeKind::triangle &&
           !hit.lane.in_instance();
  }
  MeshView mesh(const Accel& accel) const;
  void put(const Ray& ray, const Hit& hit, std::size_t i, SurfaceChunk& chunk) const;
  Surface from_chunk(const SurfaceChunk& chunk, std::size_t i, const Ray& ray,
                     float cone_width) const;

 private:
  using Weights = std::array<float, 3>;  // of a triangle's corners

  // Seen through an instance when there is a map to the world.
  void describe_triangle(std::uint32_t index, const SurfacePoint& point, const Transformf* to_world,
                         Surface& surface) const;
  Vec3f set_uvs(std::uint32_t index, const Weights& weights, const Transformf* to_world,
                SurfaceInteraction& at) const;
  void describe_sphere(std::uint32_t index, Surface& surface) const;
  void describe_rectangle(ShapeKind kind, std::uint32_t index, Surface& surface) const;
  std::uint32_t index_of(const Hit& hit) const;

  SceneView scene_;
  bool fits_chunks_;  // all indices are small enough for gathers
  std::array<std::size_t, kShapeKindCount> first_ids_;
};

}  // namespace dapple
