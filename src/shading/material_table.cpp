#include "shading/material_table.h"

namespace dapple {
namespace {

PackedMaterial record_of(const Lambertian& m) {
  return {.albedo = Vec3f(m.albedo), .kind = MaterialKind::lambertian};
}
PackedMaterial record_of(const Metal& m) {
  return {
      .albedo = Vec3f(m.albedo), .fuzz = static_cast<float>(m.fuzz), .kind = MaterialKind::metal};
}
PackedMaterial record_of(const Dielectric& m) {
  return {.ref_idx = static_cast<float>(m.ref_idx), .kind = MaterialKind::dielectric};
}
// The classic transport, which reads this table, absorbs what it does not know.
PackedMaterial record_of(const Layered&) {
  return {.albedo = Vec3f(0, 0, 0), .kind = MaterialKind::lambertian};
}

}  // namespace

std::vector<PackedMaterial> material_records(std::span<const Material> materials) {
  std::vector<PackedMaterial> records;
  records.reserve(materials.size());
  for (const Material& material : materials) {
    records.push_back(std::visit([](const auto& m) { return record_of(m); }, material));
  }
  return records;
}

}  // namespace dapple
