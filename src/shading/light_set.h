// All light sources of a scene, and which of them to ask at a point.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "math/vec2.h"
#include "math/vec3.h"
#include "scene/scene_view.h"
#include "shading/environment_light.h"
#include "shading/material_evaluator.h"
#include "shading/texture_set.h"

namespace dapple {

struct LightSample {
  Vec3f wi;            // unit, towards the light
  float distance = 0;  // infinite for directional lights and the environment
  Vec3f radiance;      // for a light without size: what arrives, per pdf 1
  float pdf = 0;       // over solid angle, the choice of the light included
  bool delta = false;  // no other strategy finds this light
};

// A surface that shines, as a ray finds it.
enum class EmitterKind : std::uint32_t {
  triangle,
  sphere,
  xy_rectangle,
  xz_rectangle,
  yz_rectangle,
  cylinder
};
inline constexpr std::size_t kEmitterKindCount = 6;
inline constexpr std::uint32_t kNoInstance = 0xffffffffu;
struct EmitterId {
  EmitterKind kind = EmitterKind::triangle;
  std::uint32_t index = 0;               // in the scene's array of the kind
  std::uint32_t instance = kNoInstance;  // of triangles that are seen through one
};

// The scene, the textures and the evaluator must outlive this.
class LightSet {
 public:
  LightSet(const SceneView& scene, const TextureSet& textures, const MaterialEvaluator& materials);

  // Chooses a light for a point and a direction to it. `normal` is the surface's, on either side,
  // or zero in a medium. No value when the choice has nothing to give.
  std::optional<LightSample> sample(const Vec3f& position, const Vec3f& normal, float u_choose,
                                    Vec2f u) const;

  // Density with which sample(position, normal, ...) finds the point of an emitter that lies
  // `distance` along `wi`; `light_normal` is that point's geometric normal, on either side.
  float pdf_of_hit(const EmitterId& emitter, const Vec3f& position, const Vec3f& normal,
                   const Vec3f& wi, float distance, const Vec3f& light_normal) const;
  // The same for the environment.
  float pdf_of_environment(const Vec3f& position, const Vec3f& normal, const Vec3f& wi) const;

  const EnvironmentLight& environment() const { return environment_; }
  bool empty() const { return lights_.empty() && environment_.is_black(); }

 private:
  enum class Kind : std::uint32_t { emitter, lamp };
  struct Entry {
    Kind kind = Kind::emitter;
    EmitterId emitter;  // of a lamp: index in the scene's lights
  };

  void add_triangles(const MaterialEvaluator& materials);
  float environment_probability() const;
  float light_probability() const;
  std::optional<LightSample> sample_triangle(const EmitterId& emitter, const Vec3f& position,
                                             Vec2f u) const;
  std::optional<LightSample> sample_lamp(const Light& light, const Vec3f& position) const;
  std::array<Vec3f, 3> corners(const EmitterId& emitter) const;

  SceneView scene_;
  const MaterialEvaluator* materials_;
  EnvironmentLight environment_;
  std::vector<Entry> lights_;
};

}  // namespace dapple
