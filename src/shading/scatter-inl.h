// scatter.h for one encounter a lane, operation for operation.
#include "math/random-inl.h"
#include "math/warps-inl.h"
#include "shading/material_table.h"

#if defined(DAPPLE_SHADING_SCATTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_SHADING_SCATTER_INL_H
#undef DAPPLE_SHADING_SCATTER_INL_H
#else
#define DAPPLE_SHADING_SCATTER_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

struct MaterialVec {
  FloatVec3 albedo;
  FloatVec fuzz, ref_idx;
  FloatMask lambertian, metal, dielectric;
};

struct EncounterVec {
  FloatVec3 direction, normal;
  FloatMask from_outside;
};

// The attenuation is the material's albedo.
struct ScatteredVec {
  FloatVec3 direction;
  FloatMask absorbed;
};

// Materials ids[i] of the records; ids of lanes that do not count are any in range.
HWY_INLINE MaterialVec load_materials(const PackedMaterial* records, WordVec ids) {
  // Records 2^28 and on are out of a gather's reach: 8 GiB of them.
  const auto* words = reinterpret_cast<const std::uint32_t*>(records);
  const WordVec index = hn::ShiftLeft<3>(ids);
  const WordVec kind = gather(words + 5, index);
  const auto is = [](MaterialKind k) { return static_cast<std::uint32_t>(k); };
  return {{floats_of_bits(gather(words + 0, index)), floats_of_bits(gather(words + 1, index)),
           floats_of_bits(gather(words + 2, index))},
          floats_of_bits(gather(words + 3, index)),
          floats_of_bits(gather(words + 4, index)),
          float_mask(hn::Eq(kind, all_words(is(MaterialKind::lambertian)))),
          float_mask(hn::Eq(kind, all_words(is(MaterialKind::metal)))),
          float_mask(hn::Eq(kind, all_words(is(MaterialKind::dielectric))))};
}

HWY_INLINE FloatVec3 reflect(FloatVec3 d, FloatVec3 n) {
  return d - hn::Mul(all(2.0f), dot(d, n)) * n;
}

HWY_INLINE FloatVec schlick_reflectance(FloatVec cosine, FloatVec ref_idx) {
  const FloatVec one = all(1.0f);
  const FloatVec root = hn::Div(hn::Sub(one, ref_idx), hn::Add(one, ref_idx));
  const FloatVec at_normal = hn::Mul(root, root);
  const FloatVec c = hn::Sub(one, cosine);
  const FloatVec c2 = hn::Mul(c, c);
  return hn::Add(at_normal, hn::Mul(hn::Sub(one, at_normal), hn::Mul(hn::Mul(c2, c2), c)));
}

HWY_INLINE FloatVec3 scatter_dielectric(const MaterialVec& material, const EncounterVec& at,
                                        FloatVec u) {
  const FloatVec one = all(1.0f);
  const FloatVec eta =
      hn::IfThenElse(at.from_outside, hn::Div(one, material.ref_idx), material.ref_idx);
  const FloatVec cos_in = smaller(hn::Neg(dot(at.direction, at.normal)), one);
  const FloatVec sin2_out = hn::Mul(hn::Mul(eta, eta), hn::Sub(one, hn::Mul(cos_in, cos_in)));
  const FloatVec cos_out = hn::Sqrt(hn::Sub(one, sin2_out));
  const FloatVec cos_in_thinner = hn::IfThenElse(hn::Lt(eta, one), cos_in, cos_out);
  // Also where sin2_out is not a number.
  const FloatMask refracts =
      hn::And(hn::Le(sin2_out, one),
              hn::Not(hn::Lt(u, schlick_reflectance(cos_in_thinner, material.ref_idx))));
  const FloatVec3 refracted =
      eta * at.direction + hn::Sub(hn::Mul(eta, cos_in), cos_out) * at.normal;
  return select(refracts, refracted, reflect(at.direction, at.normal));
}

// Blurs mirror directions; a perfect mirror's stay as they are.
HWY_INLINE FloatVec3 blur(FloatVec fuzz, FloatVec3 mirrored, FloatVec3 sphere_point,
                          const UniformVec4& u) {
  const FloatVec3 in_ball = cube_root(u.u2) * sphere_point;
  return select(hn::Eq(fuzz, hn::Zero(Floats())), mirrored, mirrored + fuzz * in_ball);
}

// Random numbers are drawn only where a lane needs them.
HWY_INLINE ScatteredVec scatter(const MaterialVec& material, const EncounterVec& at,
                                const RandomCounters& counters) {
  const FloatVec zero = hn::Zero(Floats());
  FloatVec3 direction = reflect(at.direction, at.normal);
  const FloatMask mirror = hn::And(material.metal, hn::Eq(material.fuzz, zero));
  if (!hn::AllTrue(Floats(), mirror)) {
    const UniformVec4 u = uniform4(counters);
    const FloatVec3 sphere_point = sample_uniform_sphere(u.u0, u.u1);
    if (any(material.metal)) {
      direction =
          select(material.metal, blur(material.fuzz, direction, sphere_point, u), direction);
    }
    if (any(material.lambertian)) {
      direction = select(material.lambertian, cosine_direction(at.normal, sphere_point), direction);
    }
    if (any(material.dielectric)) {
      direction = select(material.dielectric, scatter_dielectric(material, at, u.u0), direction);
    }
  }
  const FloatMask leaves = hn::Gt(dot(direction, at.normal), zero);
  return {direction, hn::AndNot(leaves, material.metal)};
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
