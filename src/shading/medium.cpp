#include "shading/medium.h"

#include "math/fast_functions.h"
#include "math/frame.h"

namespace dapple {
namespace {

float attenuate(float extinction, float distance) {
  return extinction > 0.0f ? fast_exp(-extinction * distance) : 1.0f;
}

int choose_channel(const Vec3f& weights, float u) {
  const float target = u * (weights.x + weights.y + weights.z);
  return target < weights.x ? 0 : target < weights.x + weights.y ? 1 : 2;
}

}  // namespace

Vec3f transmittance(const Medium& medium, float distance) {
  const Vec3f extinction = medium.absorption + medium.scattering;
  return {attenuate(extinction.x, distance), attenuate(extinction.y, distance),
          attenuate(extinction.z, distance)};
}

MediumSample sample_distance(const Medium& medium, float distance, Vec3f throughput,
                             float u_channel, float u) {
  if (!medium.scatters()) return {false, distance, transmittance(medium, distance)};
  const Vec3f extinction = medium.absorption + medium.scattering;
  if (!(throughput.x + throughput.y + throughput.z > 0.0f)) throughput = {1, 1, 1};
  const float total = throughput.x + throughput.y + throughput.z;
  const int channel = choose_channel(throughput, u_channel);
  const float free_path =
      extinction[channel] > 0.0f && u < 1.0f ? -fast_log(1.0f - u) / extinction[channel] : distance;
  const bool scattered = free_path < distance;
  const Vec3f through = transmittance(medium, scattered ? free_path : distance);
  const Vec3f densities = scattered ? extinction * through : through;
  const float density = dot(throughput, densities) / total;
  if (!(density > 0.0f)) return {false, distance, Vec3f()};
  const Vec3f value = scattered ? medium.scattering * through : through;
  return {scattered, scattered ? free_path : distance, value / density};
}

float phase(float cosine, float g) {
  const float squared = 1.0f + g * g - 2.0f * g * cosine;
  return (0.25f * kInvPi) * (1.0f - g * g) / (squared * std::sqrt(squared));
}

Vec3f sample_phase(const Vec3f& direction, float g, Vec2f u) {
  float cosine = 1.0f - 2.0f * u.x;
  if (std::fabs(g) > 1e-3f) {
    const float s = (1.0f - g * g) / (1.0f + g - 2.0f * g * u.x);
    cosine = (1.0f + g * g - s * s) / (2.0f * g);
    cosine = cosine < -1.0f ? -1.0f : cosine > 1.0f ? 1.0f : cosine;
  }
  const float sine = std::sqrt((1.0f - cosine) * (1.0f + cosine));
  const SinCos<float> angle = sin_cos_turns(u.y);
  return frame_around(direction).to_world({sine * angle.cos, sine * angle.sin, cosine});
}

}  // namespace dapple
