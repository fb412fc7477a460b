// Surfaces that shine, as shapes: points on them and the densities of finding those.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "math/vec2.h"
#include "math/vec3.h"
#include "scene/scene_view.h"
#include "shading/light_bounds.h"
#include "shading/surface_interaction.h"

namespace dapple {

// A surface that shines, as a ray finds it.
enum class EmitterKind : std::uint32_t {
  triangle,
  sphere,
  xy_rectangle,
  xz_rectangle,
  yz_rectangle,
  cylinder
};
constexpr bool is_rectangle(EmitterKind kind) {
  return kind == EmitterKind::xy_rectangle || kind == EmitterKind::xz_rectangle ||
         kind == EmitterKind::yz_rectangle;
}
inline constexpr std::size_t kEmitterKindCount = 6;
inline constexpr std::uint32_t kNoInstance = 0xffffffffu;
struct EmitterId {
  EmitterKind kind = EmitterKind::triangle;
  std::uint32_t index = 0;               // in the scene's array of the kind
  std::uint32_t instance = kNoInstance;  // of triangles that are seen through one
};

// A point of a shape, seen from elsewhere.
struct EmitterPoint {
  Vec3f wi;  // unit, towards the point
  float distance = 0;
  float pdf = 0;               // over solid angle
  SurfaceInteraction surface;  // position, normal and texture coordinates only
};

class EmitterShapes {
 public:
  explicit EmitterShapes(const SceneView& scene) : scene_(scene) {}

  MaterialId material(const EmitterId& emitter) const;

  // Spheres are sampled by the cone they fill, near triangles and rectangles by the solid angle,
  // all else by area.
  std::optional<EmitterPoint> sample(const EmitterId& emitter, const Vec3f& position,
                                     Vec2f u) const;
  // Density with which sample(emitter, position, u) finds the point `distance` along `wi`, where
  // the shape's normal, on either side, is `normal`.
  float pdf(const EmitterId& emitter, const Vec3f& position, const Vec3f& wi, float distance,
            const Vec3f& normal) const;

  // A point in the middle, with a ray cone as wide as the shape.
  SurfaceInteraction middle(const EmitterId& emitter) const;
  // With its area as power.
  LightBounds bounds(const EmitterId& emitter) const;

 private:
  struct Corners {
    Vec3f origin, edge1, edge2;  // a triangle, or half a parallelogram
  };
  Corners triangle_corners(const EmitterId& emitter) const;
  Corners rectangle_corners(const EmitterId& emitter) const;
  void set_triangle_uvs(const EmitterId& emitter, float b1, float b2, SurfaceInteraction& at) const;
  SurfaceInteraction flat_point(const EmitterId& emitter, const Corners& c, Vec2f along) const;
  bool sample_seen(const EmitterId& emitter, const Vec3f& position, Vec2f u,
                   EmitterPoint& result) const;
  // 0 where points are chosen by area.
  float solid_angle(const EmitterId& emitter, const Vec3f& position) const;
  float area_pdf(const EmitterId& emitter, const Vec3f& wi, float distance,
                 const Vec3f& normal) const;
  SurfaceInteraction point_of(const EmitterId& emitter, Vec2f u) const;
  std::optional<EmitterPoint> sample_sphere(const EmitterId& emitter, const Vec3f& position,
                                            Vec2f u) const;
  float area(const EmitterId& emitter) const;

  SceneView scene_;
};

}  // namespace dapple
