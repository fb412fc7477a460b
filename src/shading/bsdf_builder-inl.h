// BsdfBuilder on lanes.
#include "shading/bsdf-inl.h"

#if defined(DAPPLE_SHADING_BSDF_BUILDER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_SHADING_BSDF_BUILDER_INL_H
#undef DAPPLE_SHADING_BSDF_BUILDER_INL_H
#else
#define DAPPLE_SHADING_BSDF_BUILDER_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

HWY_INLINE Real load_real(const BsdfChunk::Floats& array, std::size_t i) {
  return load_floats(array + i);
}
HWY_INLINE Real3 load_real(const BsdfChunk::Vectors& arrays, std::size_t i) {
  return {load_floats(arrays[0] + i), load_floats(arrays[1] + i), load_floats(arrays[2] + i)};
}

HWY_INLINE Real3 valid_shading_normal(const Real3& n, const Real3& geometric, const Real3& wo) {
  const Real3 mirrored = Real(2.0f) * dot(n, wo) * n - wo;
  const Real lowest = min(Real(0.9f) * dot(geometric, wo), 0.01f);
  const Real height = dot(geometric, mirrored);
  const Bool valid = height >= lowest;
  if (HWY_LIKELY(!any(!valid))) return n;
  const Real3 half = wo + normalize(mirrored + (lowest - height) * geometric);
  const Real squared = dot(half, half);
  return select(valid, n, select(squared > 1e-8f, half / sqrt(squared), geometric));
}

HWY_INLINE Real3 multiple_scattering(const Real3& f0, Real total) {
  return grey(1.0f) + (Real(1.0f) / total - 1.0f) * f0;
}

// What is made on the way from a point to its Bsdf.
struct BsdfBuild {
  const BsdfChunk& chunk;
  const AlbedosReal albedos;
  const std::size_t i;
  BsdfReal bsdf{};
  Bool from_outside;
  Real side;
  Real3 world_wo;
  Real roughness;
  Bool uneven = BsdfReal::never();
  bool any_uneven = false;
  ReflectionAlbedoReal facets;
  Real glass_albedo = 1.0f, coat_albedo = 0.0f, sheen_albedo = 0.0f;

  HWY_INLINE BsdfBuild(const BsdfChunk& c, const AlbedoPairs& tables, std::size_t first)
      : chunk(c), albedos(tables), i(first) {
    from_outside = real(c.from_outside) > 0.0f;
    side = select(from_outside, 1.0f, -1.0f);
    world_wo = real(c.wo);
    bsdf.geometric_normal = side * real(c.geometric_normal);
  }

  HWY_INLINE Real real(const BsdfChunk::Floats& array) const { return load_real(array, i); }
  HWY_INLINE Real3 real(const BsdfChunk::Vectors& arrays) const { return load_real(arrays, i); }

  HWY_INLINE void set_shape() {
    const Real3 normal = real(chunk.normal), tangent = real(chunk.tangent);
    const Real3 bitangent = real(chunk.bitangent_sign) * cross(normal, tangent);
    const Real3 along = real(chunk.anisotropy_x) * tangent + real(chunk.anisotropy_y) * bitangent;
    const Real3 n = valid_shading_normal(side * normal, bsdf.geometric_normal, world_wo);
    bsdf.frame = frame_along(n, along);
    bsdf.wo = bsdf.frame.to_local(world_wo);
    bsdf.wo.z = max(bsdf.wo.z, 1e-4f);

    roughness = real(chunk.roughness);
    const Real alpha = roughness * roughness;
    bsdf.facets = {alpha, alpha};
    const Real anisotropy = real(chunk.anisotropy);
    const Bool anisotropic = anisotropy > 0.0f;
    if (HWY_UNLIKELY(any(anisotropic))) {
      const Real wide = mix(alpha, 1.0f, anisotropy * anisotropy);
      bsdf.facets = {select(anisotropic, wide, alpha),
                     select(anisotropic, max(alpha, 1e-3f), alpha)};
      const Real x = bsdf.facets.alpha_x, y = bsdf.facets.alpha_y;
      const Real both = sqrt(sqrt(Real(0.5f) * (x * x + y * y)));
      uneven = (x < y) || (y < x);
      any_uneven = any(uneven);
      roughness = select(anisotropic, both, roughness);
    }
    bsdf.mirror = bsdf.facets.alpha_x < kMirrorAlpha;
  }

  // What reaches the layers below, each.
  HWY_INLINE Real add_coat(Bool there) {
    const Real clearcoat_roughness = real(chunk.clearcoat_roughness);
    const Real3 normal =
        valid_shading_normal(side * real(chunk.clearcoat_normal), bsdf.geometric_normal, world_wo);
    bsdf.coat_normal = bsdf.frame.to_local(normal);
    bsdf.coat_alpha = clearcoat_roughness * clearcoat_roughness;
    bsdf.coat_mirror = there && (bsdf.coat_alpha < kMirrorAlpha);
    const Real f0 = f0_of_ior(1.5f);
    const ReflectionAlbedoReal albedo =
        albedos.reflection(dot(bsdf.wo, bsdf.coat_normal), clearcoat_roughness);
    bsdf.coat =
        where(there, real(chunk.clearcoat) * multiple_scattering(grey(f0), albedo.total()).x);
    coat_albedo = where(there, bsdf.coat * (f0 * albedo.scale + albedo.bias));
    return Real(1.0f) - coat_albedo;
  }
  HWY_INLINE Real add_sheen(Bool there) {
    const Real given = real(chunk.sheen_roughness);
    sheen_albedo = where(there, albedos.sheen(bsdf.wo.z, given));
    bsdf.sheen = where(there, (Real(1.0f) / max(sheen_albedo, 1.0f)) * real(chunk.sheen_colour));
    bsdf.sheen_roughness = where(there, max(given, 1e-3f));
    return Real(1.0f) - sheen_albedo * max_component(bsdf.sheen);
  }

  HWY_INLINE void add_reflection(const Real3& f0, const Real3& f90, Real weight) {
    bsdf.f0 = bsdf.f0 + weight * f0;
    bsdf.f90_minus_f0 = bsdf.f90_minus_f0 + weight * (f90 - f0);
  }

  // Returns what the dielectric lets through.
  HWY_INLINE Real add_interface(const Real3& base_colour, Real metallic, Bool thin,
                                Real transmission, Real below_layers) {
    facets = albedos.reflection(bsdf.wo.z, roughness);
    if (HWY_UNLIKELY(any_uneven)) {
      const ReflectionAlbedoReal brushed =
          albedos.brushed(bsdf.wo, bsdf.facets.alpha_x, bsdf.facets.alpha_y);
      facets = {select(uneven, brushed.scale, facets.scale),
                select(uneven, brushed.bias, facets.bias)};
    }
    const Real total = facets.total();
    const Real3 metal = multiple_scattering(base_colour, total);
    add_reflection(metal * base_colour, metal, below_layers * metallic);
    const Real3 f0 = real(chunk.dielectric_f0), f90 = grey(real(chunk.dielectric_f90));
    const Real3 factor = multiple_scattering(f0, total);
    const Real opaque = select(thin, 1.0f, Real(1.0f) - transmission);
    add_reflection(factor * f0, factor * f90, below_layers * (Real(1.0f) - metallic) * opaque);
    const Real3 dielectric = factor * (facets.scale * f0 + facets.bias * f90);
    return max(Real(1.0f) - max_component(dielectric), 0.0f);
  }

  HWY_INLINE void add_glass(Bool there, const Real3& tint, Real weight) {
    const Real ior = max(real(chunk.ior), 1.001f);
    bsdf.eta = select(there, select(from_outside, ior, Real(1.0f) / ior), 1.0f);
    glass_albedo = select(there, albedos.refraction(bsdf.wo.z, roughness, bsdf.eta), 1.0f);
    bsdf.glass = where(there, weight / glass_albedo);
    bsdf.glass_f0 = real(chunk.dielectric_f0);
    bsdf.glass_f90 = real(chunk.dielectric_f90);
    bsdf.glass_tint = tint;
  }

  HWY_INLINE void add_layers() {
    const Bool thin = real(chunk.thin) > 0.0f;
    const Bool has_top = from_outside || thin;
    Real reaches = 1.0f;
    bsdf.coat_mirror = BsdfReal::never();
    const Bool has_coat = has_top && (real(chunk.clearcoat) > 0.0f);
    bsdf.any_coat = any(has_coat);
    if (bsdf.any_coat) reaches = reaches * add_coat(has_coat);
    const Bool has_sheen = has_top && (max_component(real(chunk.sheen_colour)) > 0.0f);
    bsdf.any_sheen = any(has_sheen);
    if (bsdf.any_sheen) {
      const Real under = add_sheen(has_sheen);
      bsdf.sheen = reaches * bsdf.sheen;
      reaches = reaches * under;
    }

    const Real3 base_colour = real(chunk.base_colour);
    const Real metallic = real(chunk.metallic), transmission = real(chunk.transmission);
    const Real attenuation = add_interface(base_colour, metallic, thin, transmission, reaches);
    const Real dielectric = reaches * (Real(1.0f) - metallic);
    const Real transmitted = dielectric * transmission;
    const Bool straight = (transmitted > 0.0f) && thin, glass = (transmitted > 0.0f) && !thin;
    bsdf.any_straight = any(straight);
    bsdf.any_glass = any(glass);
    if (bsdf.any_straight) {
      bsdf.straight = where(straight, (transmitted * attenuation / facets.total()) * base_colour);
    }
    if (bsdf.any_glass) add_glass(glass, base_colour, transmitted);
    const Real diffuse = (dielectric - transmitted) * attenuation;
    const Real passing = real(chunk.diffuse_transmission);
    bsdf.diffuse = (diffuse * (Real(1.0f) - passing)) * base_colour;
    bsdf.through = (diffuse * passing) * real(chunk.diffuse_transmission_colour);
    bsdf.any_through = any(passing > 0.0f);
  }

  HWY_INLINE void choose_lobes() {
    const Real3 reflection =
        facets.total() * (bsdf.f0 + bsdf.straight) + facets.bias * bsdf.f90_minus_f0;
    Real3 glass{};
    if (bsdf.any_glass) {
      const BsdfReal::Facet at = bsdf.glass_facet(bsdf.wo.z);
      glass = where(bsdf.glass > 0.0f, glass_albedo * (at.reflected + at.transmitted));
    }
    const Real interface = luminance(reflection + glass);
    const Real diffuse = luminance(bsdf.diffuse + sheen_albedo * bsdf.sheen);
    const Real through = luminance(bsdf.through);
    const Real total = interface + diffuse + through + coat_albedo;
    const Bool some = total > 0.0f;
    bsdf.p_interface = where(some, interface / total);
    bsdf.p_diffuse = where(some, diffuse / total);
    bsdf.p_through = where(some, through / total);
    bsdf.p_coat = where(some, coat_albedo / total);
    bsdf.specular_only = (diffuse + through <= 0.0f) && (bsdf.mirror || (interface <= 0.0f)) &&
                         (bsdf.coat_mirror || (coat_albedo <= 0.0f));
  }
};

// Lanes from i on: makes the Bsdf of each point, evaluates it for its light and samples it.
HWY_INLINE void shade_lanes(const AlbedoPairs& tables, std::size_t i, BsdfChunk& chunk) {
  BsdfBuild build(chunk, tables, i);
  build.set_shape();
  build.add_layers();
  build.choose_lobes();
  const BsdfReal& bsdf = build.bsdf;
  const auto put = [&](const Real3& v, BsdfChunk::Vectors& arrays) HWY_ATTR {
    hn::Store(v.x.v, Floats(), arrays[0] + i);
    hn::Store(v.y.v, Floats(), arrays[1] + i);
    hn::Store(v.z.v, Floats(), arrays[2] + i);
  };
  const BsdfValueReal lit = bsdf.evaluate(build.real(chunk.light_wi));
  put(lit.f, chunk.light_f);
  hn::Store(lit.pdf.v, Floats(), chunk.light_pdf + i);
  const BsdfSampleReal next =
      bsdf.sample(build.real(chunk.u_lobe), {build.real(chunk.u_x), build.real(chunk.u_y)});
  put(next.wi, chunk.wi);
  put(next.weight, chunk.weight);
  hn::Store(next.pdf.v, Floats(), chunk.pdf + i);
  hn::Store(next.roughness.v, Floats(), chunk.wi_roughness + i);
  const auto flag = [](Bool is_set, std::uint32_t bit) HWY_ATTR {
    return hn::IfThenElseZero(word_mask(is_set.m), all_words(bit));
  };
  const WordVec flags =
      hn::Or(hn::Or(flag(next.found, BsdfChunk::kFound), flag(next.specular, BsdfChunk::kSpecular)),
             hn::Or(flag(next.transmitted, BsdfChunk::kTransmitted),
                    flag(bsdf.specular_only, BsdfChunk::kSpecularOnly)));
  hn::Store(flags, Words(), chunk.flags + i);
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
