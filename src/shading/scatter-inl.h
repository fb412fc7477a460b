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

// A word of each of the first kLanes records as one vector, or only where the records are.
class MaterialTable {
 public:
  HWY_INLINE MaterialTable(const PackedMaterial* records, std::size_t count)
      : words_(reinterpret_cast<const std::uint32_t*>(records)), few_(count <= kLanes) {
    if (!few_) return;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t word = 0; word < kWords; ++word) rows_[word][i] = words_[8 * i + word];
    }
  }

  // Of materials ids[i]; ids of lanes that do not count are any in range.
  HWY_INLINE MaterialVec operator[](WordVec ids) const {
    const WordVec kind = word(5, ids);
    const auto is = [&](MaterialKind k) HWY_ATTR -> FloatMask {
      return float_mask(hn::Eq(kind, all_words(static_cast<std::uint32_t>(k))));
    };
    return {{number(0, ids), number(1, ids), number(2, ids)},
            number(3, ids),
            number(4, ids),
            is(MaterialKind::lambertian),
            is(MaterialKind::metal),
            is(MaterialKind::dielectric)};
  }

 private:
  static constexpr std::size_t kWords = 6;

  HWY_INLINE WordVec word(std::size_t i, WordVec ids) const {
    if (HWY_LIKELY(few_)) {
      return hn::TableLookupLanes(hn::Load(Words(), rows_[i]), hn::IndicesFromVec(Words(), ids));
    }
    // Records 2^28 and on are out of a gather's reach: 8 GiB of them.
    return gather(words_ + i, hn::ShiftLeft<3>(ids));
  }
  HWY_INLINE FloatVec number(std::size_t i, WordVec ids) const {
    return floats_of_bits(word(i, ids));
  }

  const std::uint32_t* words_;
  bool few_;
  HWY_ALIGN std::uint32_t rows_[kWords][kLanes] = {};
};

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
