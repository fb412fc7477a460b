// Light from all around, infinitely far away.
#pragma once

#include <cstring>
#include <optional>
#include <vector>

#include "math/vec2.h"
#include "math/vec3.h"
#include "scene/scene_view.h"
#include "shading/environment_view.h"
#include "shading/piecewise_constant_2d.h"
#include "shading/texture_set.h"
#include "util/huge_array.h"

namespace dapple {

struct EnvironmentSample {
  Vec3f direction;
  Vec3f radiance;
  float pdf = 0;  // over solid angle
};

// Reads images of floats where they lie, so the arrays behind the view must outlive this, unless
// RGBE can hold them as well. Between texels radiance is interpolated; the density of sampling is
// constant in each cell of a grid that is no finer than the image.
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

  // No value without a picture, or for one too large for vector code.
  std::optional<EnvironmentView> view() const;

 private:
  Vec3f texel(int x, int y) const;
  bool is_uniform() const { return rgb_ == nullptr && rgbe_.size() == 0; }
  void use_own_pixels(int width, int height);
  void use_image(const SceneView& scene, const TextureSet& textures);
  void pack();
  Vec3f lookup(Vec2f uv) const;
  void build_distribution();

  bool black_ = true;
  float turn_ = 0;  // rotation in turns
  Vec3f colour_{1, 1, 1};
  Vec3f mean_;
  int width_ = 0, height_ = 0;
  // See EnvironmentView: one of the two.
  const std::uint8_t* rgb_ = nullptr;
  HugeArray<std::uint32_t> rgbe_;
  std::vector<Vec3f> own_pixels_;
  PiecewiseConstant2d distribution_;
};

}  // namespace dapple
