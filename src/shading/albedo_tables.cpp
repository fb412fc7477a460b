#include "shading/albedo_tables.h"

#include <algorithm>
#include <cmath>

namespace dapple {
namespace {

constexpr float kUnit = 1.0f / 65535;

// The cell of a grid of nodes that x in [0, 1] lies in, and how far.
struct Place {
  std::size_t index;
  float t;
};
Place place(float x, std::size_t nodes) {
  const float scaled = std::clamp(x, 0.0f, 1.0f) * static_cast<float>(nodes - 1);
  const auto index = std::min(static_cast<std::size_t>(scaled), nodes - 2);
  return {index, scaled - static_cast<float>(index)};
}

float bilinear(const std::uint16_t* table, std::size_t columns, Place row, Place column) {
  const std::uint16_t* a = table + row.index * columns + column.index;
  const std::uint16_t* b = a + columns;
  const float first = (1.0f - column.t) * a[0] + column.t * a[1];
  const float second = (1.0f - column.t) * b[0] + column.t * b[1];
  return kUnit * ((1.0f - row.t) * first + row.t * second);
}

template <std::size_t kCount>
void set_pairs(const std::uint16_t (&data)[kCount], std::array<std::uint32_t, kCount>& pairs) {
  for (std::size_t i = 0; i < kCount; ++i) {
    const std::uint32_t next = data[i + 1 < kCount ? i + 1 : i];
    pairs[i] = data[i] | next << 16;
  }
}

float root_of_cosine(float cosine) { return std::sqrt(std::clamp(cosine, 0.0f, 1.0f)); }

}  // namespace

ReflectionAlbedo reflection_albedo(float cosine, float roughness) {
  const Place row = place(roughness, kAlbedoRoughnesses);
  const Place column = place(root_of_cosine(cosine), kAlbedoCosines);
  return {bilinear(kReflectionScaleData, kAlbedoCosines, row, column),
          bilinear(kReflectionBiasData, kAlbedoCosines, row, column)};
}

ReflectionAlbedo brushed_albedo(const Vec3f& wo, float alpha_x, float alpha_y) {
  const bool along_x = alpha_x > alpha_y;
  const float wide = std::sqrt(along_x ? alpha_x : alpha_y);
  const float narrow = std::sqrt(along_x ? alpha_y : alpha_x);
  const float level = std::sqrt(wo.x * wo.x + wo.y * wo.y);
  const Place across = place(narrow, kBrushedNodes);
  const Place spread = place(narrow < 1.0f ? (wide - narrow) / (1.0f - narrow) : 0, kBrushedNodes);
  const Place azimuth =
      place(level > 0.0f ? std::fabs(along_x ? wo.x : wo.y) / level : 1, kBrushedNodes);
  const Place column = place(root_of_cosine(wo.z), kBrushedCosines);
  ReflectionAlbedo sum{0, 0};
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const std::size_t i = corner & 1, j = corner >> 1;
    const std::size_t sheet =
        ((across.index + i) * kBrushedNodes + spread.index + j) * (kBrushedNodes * kBrushedCosines);
    const float weight =
        (i == 1 ? across.t : 1.0f - across.t) * (j == 1 ? spread.t : 1.0f - spread.t);
    sum.scale += weight * bilinear(kBrushedScaleData + sheet, kBrushedCosines, azimuth, column);
    sum.bias += weight * bilinear(kBrushedBiasData + sheet, kBrushedCosines, azimuth, column);
  }
  return sum;
}

float refraction_albedo(float cosine, float roughness, float eta) {
  const Place row = place(roughness, kRefractionRoughnesses);
  const Place column = place(root_of_cosine(cosine), kRefractionCosines);
  constexpr float kScale = (kLargestEta + 1) / (kLargestEta - 1);
  const Place sheet = place(std::sqrt(kScale * std::fabs(eta - 1.0f) / (eta + 1.0f)),
                            eta > 1.0f ? kRefractionInEtas : kRefractionOutEtas);
  const std::uint16_t* data = eta > 1.0f ? kRefractionInData : kRefractionOutData;
  constexpr std::size_t kSheet = kRefractionRoughnesses * kRefractionCosines;
  const std::uint16_t* near = data + sheet.index * kSheet;
  return (1.0f - sheet.t) * bilinear(near, kRefractionCosines, row, column) +
         sheet.t * bilinear(near + kSheet, kRefractionCosines, row, column);
}

float sheen_albedo(float cosine, float roughness) {
  return kSheenScale * bilinear(kSheenData, kSheenCosines, place(roughness, kSheenRoughnesses),
                                place(root_of_cosine(cosine), kSheenCosines));
}

const AlbedoPairs& albedo_pairs() {
  static const AlbedoPairs pairs = [] {
    AlbedoPairs p;
    set_pairs(kReflectionScaleData, p.reflection_scale);
    set_pairs(kReflectionBiasData, p.reflection_bias);
    set_pairs(kBrushedScaleData, p.brushed_scale);
    set_pairs(kBrushedBiasData, p.brushed_bias);
    set_pairs(kSheenData, p.sheen);
    set_pairs(kRefractionInData, p.refraction_in);
    set_pairs(kRefractionOutData, p.refraction_out);
    return p;
  }();
  return pairs;
}

}  // namespace dapple
