// Light from all around, infinitely far away.
#pragma once

#include <vector>

#include "math/vec2.h"
#include "math/vec3.h"
#include "scene/scene_view.h"
#include "shading/piecewise_constant_2d.h"
#include "shading/texture_set.h"

namespace dapple {

struct EnvironmentSample {
  Vec3f direction;
  Vec3f radiance;
  float pdf = 0;  // over solid angle
};

class EnvironmentLight {
 public:
  EnvironmentLight() = default;  // black
  EnvironmentLight(const SceneView& scene, const TextureSet& textures);

  // `direction` is a unit vector away from the scene.
  Vec3f radiance(const Vec3f& direction) const;
  EnvironmentSample sample(Vec2f u) const;
  float pdf(const Vec3f& direction) const;

  bool is_black() const { return black_; }
  Vec3f mean_radiance() const { return mean_; }  // over the sphere

 private:
  Vec3f texel(int x, int y) const { return pixels_[static_cast<std::size_t>(y) * width_ + x]; }
  Vec3f lookup(Vec2f uv) const;
  void build_distribution();

  bool black_ = true;
  float turn_ = 0;  // rotation in turns
  Vec3f colour_{1, 1, 1};
  Vec3f mean_;
  int width_ = 0, height_ = 0;
  std::vector<Vec3f> pixels_;  // top row first; empty: uniform
  PiecewiseConstant2d distribution_;
};

}  // namespace dapple
