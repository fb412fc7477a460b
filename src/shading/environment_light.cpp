#include "shading/environment_light.h"

#include <algorithm>

#include "math/fast_functions.h"
#include "math/warps.h"

namespace dapple {
namespace {

constexpr float kUniformPdf = 0.25f * kInvPi;

float luminance(const Vec3f& c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

float fraction(float x) { return x - static_cast<float>(floor_to_int(x)); }

Vec2f uv_of(const Vec3f& d, float turn) {
  const float u = fast_atan2(d.z, d.x) * (0.5f * kInvPi) + 0.5f + turn;
  return {fraction(u), fast_acos(d.y) * kInvPi};
}

Vec3f direction_of(Vec2f uv, float turn) {
  const SinCos<float> polar = sin_cos_turns(0.5f * uv.y);
  const SinCos<float> around = sin_cos_turns(uv.x - 0.5f - turn);
  return {polar.sin * around.cos, polar.cos, polar.sin * around.sin};
}

// Density over solid angle of a density over the unit square.
float per_solid_angle(float pdf, float sin_polar) {
  return sin_polar > 0.0f ? pdf / (2.0f * kPi * kPi * sin_polar) : 0.0f;
}

float sine_from(float cosine) {
  const float squared = (1.0f - cosine) * (1.0f + cosine);
  return squared > 0.0f ? std::sqrt(squared) : 0.0f;
}

}  // namespace

EnvironmentLight::EnvironmentLight(const SceneView& scene, const TextureSet& textures)
    : turn_(scene.environment.rotation / 360.0f), colour_(scene.environment.colour) {
  const Environment& environment = scene.environment;
  black_ = environment.kind == EnvironmentKind::none || luminance(colour_) <= 0;
  if (black_) return;
  mean_ = colour_;
  if (environment.kind != EnvironmentKind::image || environment.image == kNoImage) return;
  const TextureImage& image = scene.images[static_cast<std::size_t>(environment.image)];
  width_ = static_cast<int>(image.width), height_ = static_cast<int>(image.height);
  pixels_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      pixels_[std::size_t{y} * image.width + x] =
          colour_ * textures.texel(environment.image, true, x, y).xyz();
    }
  }
  build_distribution();
}

void EnvironmentLight::build_distribution() {
  std::vector<float> weights(pixels_.size());
  Vec3d sum;
  double total = 0;
  for (int y = 0; y < height_; ++y) {
    const float sine = sin_cos_turns(0.5f * (static_cast<float>(y) + 0.5f) / float(height_)).sin;
    for (int x = 0; x < width_; ++x) {
      const int left = x > 0 ? x - 1 : width_ - 1, right = x + 1 < width_ ? x + 1 : 0;
      const int above = std::max(y - 1, 0), below = std::min(y + 1, height_ - 1);
      // Bilinear lookups reach into the neighbours' cells.
      const float near = 0.25f * (luminance(texel(left, y)) + luminance(texel(right, y)) +
                                  luminance(texel(x, above)) + luminance(texel(x, below)));
      weights[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
              static_cast<std::size_t>(x)] =
          std::max(0.0f, 0.75f * luminance(texel(x, y)) + 0.25f * near) * sine;
      sum = sum + double(sine) * Vec3d(texel(x, y));
      total += sine;
    }
  }
  mean_ = Vec3f(sum / total);
  distribution_ = PiecewiseConstant2d(std::move(weights), static_cast<std::size_t>(width_),
                                      static_cast<std::size_t>(height_));
}

Vec3f EnvironmentLight::lookup(Vec2f uv) const {
  const float x = uv.x * static_cast<float>(width_) - 0.5f;
  const float y = uv.y * static_cast<float>(height_) - 0.5f;
  const int i = floor_to_int(x), j = floor_to_int(y);
  const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
  const int x0 = i < 0 ? width_ - 1 : i, x1 = i + 1 < width_ ? i + 1 : 0;
  const int y0 = std::max(j, 0), y1 = std::min(j + 1, height_ - 1);
  return (1 - fy) * ((1 - fx) * texel(x0, y0) + fx * texel(x1, y0)) +
         fy * ((1 - fx) * texel(x0, y1) + fx * texel(x1, y1));
}

Vec3f EnvironmentLight::radiance(const Vec3f& direction) const {
  if (black_) return {};
  return pixels_.empty() ? colour_ : lookup(uv_of(direction, turn_));
}

EnvironmentSample EnvironmentLight::sample(Vec2f u) const {
  if (black_) return {};
  if (pixels_.empty()) return {sample_uniform_sphere(u.x, u.y), colour_, kUniformPdf};
  const auto found = distribution_.sample(u);
  const Vec3f direction = direction_of(found.point, turn_);
  return {direction, lookup(found.point), per_solid_angle(found.pdf, sine_from(direction.y))};
}

float EnvironmentLight::pdf(const Vec3f& direction) const {
  if (black_) return 0;
  if (pixels_.empty()) return kUniformPdf;
  return per_solid_angle(distribution_.pdf(uv_of(direction, turn_)), sine_from(direction.y));
}

}  // namespace dapple
