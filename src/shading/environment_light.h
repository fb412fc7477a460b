// Light from all around, infinitely far away.
#pragma once

#include <cstring>
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

// Reads images of floats where they lie, so the arrays behind the view must outlive this. Between
// texels radiance is interpolated; the density of sampling is constant in each cell of a grid that
// is no finer than the image.
class EnvironmentLight {
 public:
  EnvironmentLight() = default;  // black
  EnvironmentLight(const SceneView& scene, const TextureSet& textures);
  EnvironmentLight(const EnvironmentLight&) = delete;
  EnvironmentLight& operator=(const EnvironmentLight&) = delete;

  // `direction` is a unit vector away from the scene.
  Vec3f radiance(const Vec3f& direction) const;
  EnvironmentSample sample(Vec2f u) const;
  float pdf(const Vec3f& direction) const;

  bool is_black() const { return black_; }
  Vec3f mean_radiance() const { return mean_; }  // over the sphere

 private:
  Vec3f texel(int x, int y) const {
    float t[3];
    std::memcpy(t,
                texels_ + 12 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                static_cast<std::size_t>(x)),
                sizeof(t));
    return {t[0], t[1], t[2]};
  }
  bool is_uniform() const { return texels_ == nullptr; }
  void use_own_pixels(int width, int height);
  void use_image(const SceneView& scene, const TextureSet& textures);
  Vec3f lookup(Vec2f uv) const;
  void build_distribution();

  bool black_ = true;
  float turn_ = 0;  // rotation in turns
  Vec3f colour_{1, 1, 1};
  Vec3f mean_;
  int width_ = 0, height_ = 0;
  const std::uint8_t* texels_ = nullptr;  // three floats each, top row first
  std::vector<Vec3f> own_pixels_;
  PiecewiseConstant2d distribution_;
};

}  // namespace dapple
