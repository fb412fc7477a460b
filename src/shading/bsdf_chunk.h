// Surface points whose reflectance is evaluated and sampled many at once.
#pragma once

#include <cstddef>
#include <cstdint>

namespace dapple {

// As many as stay in the first-level cache with all that belongs to them.
inline constexpr std::size_t kChunk = 256;
// Elements from one array of a chunk to the next: at a power of two the same element of all arrays
// would fall into the same few sets of the cache.
inline constexpr std::size_t kStride = kChunk + 16;

// A structure of arrays: element i of each belongs to one point. What is asked of a point stands
// in LayeredPoint and SurfaceInteraction; beyond the points in use there are numbers left from
// before, or zeros.
struct alignas(64) BsdfChunk {
  using Floats = float[kStride];
  using Vectors = float[3][kStride];

  // The surface.
  Vectors geometric_normal = {}, tangent = {}, wo = {};
  Floats bitangent_sign = {}, from_outside = {};  // 1: true
  // LayeredPoint.
  Vectors base_colour = {}, dielectric_f0 = {}, diffuse_transmission_colour = {};
  Vectors sheen_colour = {}, normal = {}, clearcoat_normal = {};
  Floats metallic = {}, roughness = {}, dielectric_f90 = {}, ior = {}, transmission = {};
  Floats thin = {}, diffuse_transmission = {}, clearcoat = {}, clearcoat_roughness = {};
  Floats sheen_roughness = {}, anisotropy = {}, anisotropy_x = {}, anisotropy_y = {};
  // Where light comes from, and random numbers for what leaves.
  Vectors light_wi = {};
  Floats u_lobe = {}, u_x = {}, u_y = {};

  // Bsdf::evaluate(light_wi).
  Vectors light_f = {};
  Floats light_pdf = {};
  // Bsdf::sample(u_lobe, {u_x, u_y}) and is_specular_only().
  Vectors wi = {}, weight = {};
  Floats pdf = {}, wi_roughness = {};
  std::uint32_t flags[kStride] = {};

  static constexpr std::uint32_t kFound = 1, kSpecular = 2, kTransmitted = 4, kSpecularOnly = 8;
};

}  // namespace dapple
