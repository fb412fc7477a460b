// Materials as the vector code reads them: single precision, one record of eight words each.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/material.h"

namespace dapple {

// In the order of Material's alternatives.
enum class MaterialKind : std::uint32_t { lambertian, metal, dielectric };

struct PackedMaterial {
  Vec3f albedo{1, 1, 1};  // white for a dielectric
  float fuzz = 0;
  float ref_idx = 1;
  MaterialKind kind = MaterialKind::lambertian;
  std::uint32_t unused[2] = {};
};
static_assert(sizeof(PackedMaterial) == 32, "gathers count in words of a record");

[[nodiscard]] std::vector<PackedMaterial> material_records(std::span<const Material> materials);

}  // namespace dapple
