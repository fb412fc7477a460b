// What rough interfaces and sheen send back of uniform light, from tables (tools/albedo_tables).
// `roughness` is the square root of the microfacet distribution's width; both arguments in [0, 1].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "math/vec3.h"

namespace dapple {

// The albedo of a reflecting interface without multiple scattering is
// f0 * scale + f90 * bias for Schlick's Fresnel term.
struct ReflectionAlbedo {
  float scale = 1, bias = 0;
  float total() const { return scale + bias; }  // of a perfect reflector
};
[[nodiscard]] ReflectionAlbedo reflection_albedo(float cosine, float roughness);

// Of a refracting interface, reflected and transmitted together; `eta` is the index of the far
// side over that of the near one.
[[nodiscard]] float refraction_albedo(float cosine, float roughness, float eta);

// Of a white sheen; above 1 where the model gains energy, narrow and grazing.
[[nodiscard]] float sheen_albedo(float cosine, float roughness);

// The same of an interface of these widths along x and y, for the direction wo (local, the normal
// is z).
[[nodiscard]] ReflectionAlbedo brushed_albedo(const Vec3f& wo, float alpha_x, float alpha_y);

// Layout of the tables: 16-bit fractions at nodes that are equally spaced in roughness, in the
// square root of the cosine, and in that of |eta - 1| / (eta + 1) up to kLargestEta: near an index
// of 1 a rough interface changes fast. Cosines vary fastest.
inline constexpr std::size_t kAlbedoCosines = 32, kAlbedoRoughnesses = 32;
inline constexpr std::size_t kRefractionCosines = 16, kRefractionRoughnesses = 16;
inline constexpr std::size_t kRefractionInEtas = 12, kRefractionOutEtas = 24;
inline constexpr std::size_t kSheenCosines = 32, kSheenRoughnesses = 16;
// Of the roughness across, of how far that along is from it towards 1, and of the azimuth's cosine.
inline constexpr std::size_t kBrushedNodes = 7, kBrushedCosines = 16;
inline constexpr std::size_t kBrushedSize =
    kBrushedNodes * kBrushedNodes * kBrushedNodes * kBrushedCosines;
inline constexpr float kLeastBrushedAlpha = 1e-3f;
inline constexpr float kLargestEta = 3.0f;
inline constexpr float kSheenScale = 4.0f;          // what 65535 stands for: narrow sheen exceeds 1
inline constexpr float kLeastAlbedoCosine = 1e-3f;  // that of the nodes at 0

extern const std::uint16_t kReflectionScaleData[kAlbedoRoughnesses * kAlbedoCosines];
extern const std::uint16_t kReflectionBiasData[kAlbedoRoughnesses * kAlbedoCosines];
extern const std::uint16_t kBrushedScaleData[kBrushedSize];
extern const std::uint16_t kBrushedBiasData[kBrushedSize];
extern const std::uint16_t kSheenData[kSheenRoughnesses * kSheenCosines];
// Into the denser side, and out of it.
extern const std::uint16_t
    kRefractionInData[kRefractionInEtas * kRefractionRoughnesses * kRefractionCosines];
extern const std::uint16_t
    kRefractionOutData[kRefractionOutEtas * kRefractionRoughnesses * kRefractionCosines];

// The same for vector code: each element with the next one in its upper half.
struct AlbedoPairs {
  std::array<std::uint32_t, kAlbedoRoughnesses * kAlbedoCosines> reflection_scale, reflection_bias;
  std::array<std::uint32_t, kBrushedSize> brushed_scale, brushed_bias;
  std::array<std::uint32_t, kSheenRoughnesses * kSheenCosines> sheen;
  std::array<std::uint32_t, kRefractionInEtas * kRefractionRoughnesses * kRefractionCosines>
      refraction_in;
  std::array<std::uint32_t, kRefractionOutEtas * kRefractionRoughnesses * kRefractionCosines>
      refraction_out;
};
[[nodiscard]] const AlbedoPairs& albedo_pairs();

}  // namespace dapple
