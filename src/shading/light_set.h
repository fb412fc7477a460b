// All light sources of a scene, and which of them to ask at a point.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "math/vec2.h"
#include "math/vec3.h"
#include "scene/scene_view.h"
#include "shading/emitter_shapes.h"
#include "shading/environment_light.h"
#include "shading/lamp.h"
#include "shading/light_tree.h"
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

// A point's light is asked of three: what is near (a tree over emitters and lamps chooses by power,
// distance and direction), the directional lights, and the environment, by what each may give.
//
// The scene, the textures and the evaluator must outlive this.
class LightSet {
 public:
  LightSet(const SceneView& scene, const TextureSet& textures, const MaterialEvaluator& materials);

  // Probabilities of asking each group; they sum to 1, or to 0 when there is no light.
  struct Groups {
    float near = 0, directional = 0, environment = 0;
  };
  // `normal` is the surface's, on either side, or zero in a medium.
  Groups groups(const Vec3f& position, const Vec3f& normal) const;

  // Chooses a light for a point and a direction to it, where groups(position, normal) and
  // environment().sample(u) are known. No value when the choice has nothing to give.
  std::optional<LightSample> sample(const Groups& p, const Vec3f& position, const Vec3f& normal,
                                    float u_choose, Vec2f u,
                                    const EnvironmentSample& of_environment) const;
  std::optional<LightSample> sample(const Vec3f& position, const Vec3f& normal, float u_choose,
                                    Vec2f u) const {
    return sample(groups(position, normal), position, normal, u_choose, u, environment_.sample(u));
  }

  // Density with which sample(position, normal, ...) finds the point of an emitter that lies
  // `distance` along `wi`; `light_normal` is that point's geometric normal, on either side.
  float pdf_of_hit(const EmitterId& emitter, const Vec3f& position, const Vec3f& normal,
                   const Vec3f& wi, float distance, const Vec3f& light_normal) const;
  // The same for the environment.
  float pdf_of_environment(const Vec3f& position, const Vec3f& normal, const Vec3f& wi) const;

  const EnvironmentLight& environment() const { return environment_; }
  std::size_t near_count() const { return near_.size(); }
  bool empty() const { return tree_.empty() && directional_.empty() && environment_.is_black(); }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  // One light of the tree: an emitter, or entry `lamp` of the lamps.
  struct Near {
    EmitterId emitter;
    std::uint32_t lamp = kNone;
  };
  void add_emitters(std::vector<LightBounds>& bounds);
  bool triangle_shines(std::uint32_t index) const;
  void add_triangles(std::vector<LightBounds>& bounds);
  void add_emitter(const EmitterId& emitter, std::vector<LightBounds>& bounds);
  std::uint32_t near_index(const EmitterId& emitter) const;
  std::optional<LightSample> sample_near(const Vec3f& position, const Vec3f& normal, float u_choose,
                                         Vec2f u) const;
  std::optional<LightSample> sample_directional(const Vec3f& position, float u_choose) const;

  SceneView scene_;
  const MaterialEvaluator* materials_;
  EmitterShapes shapes_;
  EnvironmentLight environment_;
  std::vector<Near> near_;
  std::vector<Lamp> lamps_;
  LightTree tree_;
  std::vector<Lamp> directional_;
  float directional_total_ = 0;  // luminance
  float environment_total_ = 0;  // irradiance of its mean, luminance

  // From emitters to near_: by kind and index in the scene's arrays, empty for kinds that do not
  // shine; and for triangles of instances by instance, then by place in the prototype.
  std::array<std::vector<std::uint32_t>, kEmitterKindCount> near_of_;
  std::vector<std::uint32_t> first_of_instance_;
  std::vector<std::uint32_t> near_of_instanced_;
};

}  // namespace dapple
