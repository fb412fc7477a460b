// BsdfBuilder and Bsdf on lanes, operation for operation, without iridescence and dispersion.
#include "shading/bsdf_chunk.h"
#include "shading/microfacet-inl.h"

#if defined(DAPPLE_SHADING_BSDF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_SHADING_BSDF_INL_H
#undef DAPPLE_SHADING_BSDF_INL_H
#else
#define DAPPLE_SHADING_BSDF_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

inline constexpr float kCoatF0 = 0.04f;
inline constexpr float kMirrorAlpha = 1e-4f;

HWY_INLINE Real3 below(const Real3& w) { return {w.x, w.y, -w.z}; }

HWY_INLINE Real3 cosine_hemisphere(const Real2& u) {
  return cosine_direction({all(0.0f), all(0.0f), all(1.0f)}, sample_uniform_sphere(u.x.v, u.y.v));
}

struct BsdfValueReal {
  Real3 f;
  Real pdf;
};

HWY_INLINE BsdfValueReal where(Bool mask, const BsdfValueReal& value) {
  return {where(mask, value.f), where(mask, value.pdf)};
}
HWY_INLINE BsdfValueReal select(Bool mask, const BsdfValueReal& yes, const BsdfValueReal& no) {
  return {select(mask, yes.f, no.f), select(mask, yes.pdf, no.pdf)};
}

// Lanes in which nothing is `found` hold rubbish.
struct BsdfSampleReal {
  Real3 wi, weight;
  Real pdf, roughness;
  Bool found, specular, transmitted;
};

struct BsdfReal {
  RealFrame frame;
  Real3 geometric_normal, wo;
  Real p_coat, p_interface, p_diffuse, p_through;
  Real3 diffuse, through, sheen;
  Real sheen_roughness;
  FacetsReal facets;
  Real3 f0, f90_minus_f0, glass_f0, glass_tint;
  Real glass, glass_f90, eta;
  Real3 straight, coat_normal;
  Real coat, coat_alpha;
  Bool mirror, coat_mirror, specular_only;
  bool any_coat, any_sheen, any_glass, any_straight, any_through;

  struct Facet {
    Real3 reflected, transmitted;
    Real p_reflect;
  };

  HWY_INLINE Facet glass_facet(Real cosine) const {
    const Real exact = fresnel_dielectric(cosine, eta);
    const Bool all_reflected = exact >= 1.0f;
    const Real ior_f0 = f0_of_ior(eta);
    const Real3 reflected =
        mix(glass_f0, grey(glass_f90), (exact - ior_f0) / (Real(1.0f) - ior_f0));
    const Real3 through_it = (glass * (Real(1.0f) - max_component(reflected))) * glass_tint;
    return {select(all_reflected, grey(glass), glass * reflected),
            where(!all_reflected, through_it), 1.0f};
  }

  HWY_INLINE Facet facet(Real cosine) const {
    Facet result = {f0 + schlick_weight(cosine) * f90_minus_f0, straight, 1.0f};
    if (any_glass) {
      const Facet of_glass = glass_facet(cosine);
      const Bool is_glass = glass > 0.0f;
      result.reflected = select(is_glass, result.reflected + of_glass.reflected, result.reflected);
      result.transmitted = select(is_glass, of_glass.transmitted, result.transmitted);
    }
    if (any_glass || any_straight) {
      const Real r = luminance(result.reflected), t = luminance(result.transmitted);
      result.p_reflect = select(t > 0.0f, r / (r + t), result.p_reflect);
    }
    return result;
  }

  HWY_INLINE void add(Bool mask, const BsdfValueReal& part, BsdfValueReal& value) const {
    value.f = select(mask, value.f + part.f, value.f);
    value.pdf = select(mask, value.pdf + part.pdf, value.pdf);
  }

  HWY_INLINE void add_coat(const Real3& wi, BsdfValueReal& value) const {
    const Real cos_i = dot(wi, coat_normal), cos_o = dot(wo, coat_normal);
    const Bool counts = (coat > 0.0f) && !coat_mirror && (cos_i > 0.0f) && (cos_o > 0.0f);
    const Real3 h = normalize(wo + wi);
    const Real3 sine = cross(h, coat_normal);
    const IsotropicReal coat_facets = {coat_alpha * coat_alpha};
    const Real common = coat_facets.d(dot(sine, sine)) / (Real(4.0f) * cos_o);
    const Real lambda_o = coat_facets.lambda(cos_o);
    const Real fresnel = Real(kCoatF0) + Real(1.0f - kCoatF0) * schlick_weight(dot(wi, h));
    const Real f = coat * fresnel * common / (Real(1.0f) + lambda_o + coat_facets.lambda(cos_i));
    add(counts, {grey(f), p_coat * common / (Real(1.0f) + lambda_o)}, value);
  }

  // Reflection by the interface at facets between wo and wi, or what goes straight through them.
  HWY_INLINE BsdfValueReal of_facets(const Real3& wi, bool reflected) const {
    const Real3 h = normalize(wo + wi);
    const Facet at = facet(dot(wi, h));
    const Real common = facets.d(h) / (Real(4.0f) * wo.z);
    const Real lambda_o = facets.lambda(wo);
    const Real p = reflected ? at.p_reflect : Real(1.0f) - at.p_reflect;
    return {(common / (Real(1.0f) + lambda_o + facets.lambda(wi))) *
                (reflected ? at.reflected : at.transmitted),
            p_interface * p * common / (Real(1.0f) + lambda_o)};
  }

  HWY_INLINE BsdfValueReal evaluate_reflection(const Real3& wi) const {
    BsdfValueReal value{};
    if (any_coat) add_coat(wi, value);
    const Bool above = wi.z > 0.0f;
    const Bool diffuses = above && (p_diffuse > 0.0f);
    add(diffuses, {(wi.z * Real(kInvPi)) * diffuse, p_diffuse * wi.z * Real(kInvPi)}, value);
    if (any_sheen) {
      const Real3 f = SheenReal(sheen_roughness).evaluate(wo, wi) * sheen;
      add(diffuses && (sheen_roughness > 0.0f), {f, 0.0f}, value);
    }
    const Bool rough = (p_interface > 0.0f) && !mirror;
    if (any(rough)) add(above && rough, of_facets(wi, true), value);
    return value;
  }

  HWY_INLINE BsdfValueReal of_refraction(const Real3& wi) const {
    Real3 h = normalize(wo + eta * wi);
    h = select(h.z < 0.0f, -h, h);
    const Real cos_o = dot(wo, h), cos_i = dot(wi, h);
    const Facet at = facet(cos_o);
    const Real root = cos_o + eta * cos_i;
    const Real common =
        facets.d(h) * cos_o / wo.z * (eta * eta * -cos_i) / max(root * root, 1e-18f);
    const Real lambda_o = facets.lambda(wo);
    const BsdfValueReal value = {
        (common / (Real(1.0f) + lambda_o + facets.lambda(wi))) * at.transmitted,
        p_interface * (Real(1.0f) - at.p_reflect) * common / (Real(1.0f) + lambda_o)};
    return where((cos_o > 0.0f) && (cos_i < 0.0f), value);
  }

  HWY_INLINE BsdfValueReal evaluate_transmission(const Real3& wi) const {
    BsdfValueReal value{};
    if (any_through) {
      add(p_through > 0.0f, {(-wi.z * Real(kInvPi)) * through, p_through * -wi.z * Real(kInvPi)},
          value);
    }
    const Bool rough = (p_interface > 0.0f) && !mirror;
    if (any_glass) add(rough && (glass > 0.0f), of_refraction(wi), value);
    if (any_straight) {
      const Bool counts = !(glass > 0.0f) && (max_component(straight) > 0.0f);
      add(rough && counts, of_facets(below(wi), false), value);
    }
    return value;
  }

  HWY_INLINE bool transmits() const { return any_glass || any_straight || any_through; }

  HWY_INLINE BsdfValueReal evaluate(const Real3& wi_world) const {
    const Real3 wi = frame.to_local(wi_world);
    const Bool above = dot(wi_world, geometric_normal) > 0.0f;
    BsdfValueReal value = where(above, evaluate_reflection(wi));
    const Bool under = !above && (wi.z < 0.0f);
    if (transmits() && any(under)) value = select(under, evaluate_transmission(wi), value);
    return value;
  }

  // A direction and what came with its choice; `weight` where it is specular.
  struct Proposal {
    Real3 wi, weight;
    Real roughness;
    Bool found, specular, transmitted;
  };

  HWY_INLINE Proposal propose_coat(const Real2& u) const {
    const RealFrame around = frame_around(coat_normal);
    const FacetsReal coat_facets = {coat_alpha, coat_alpha};
    const Real3 h = around.to_world(coat_facets.sample(around.to_local(wo), u));
    const Real3 rough = reflect_about(wo, h);
    const Real fresnel =
        Real(kCoatF0) + Real(1.0f - kCoatF0) * schlick_weight(dot(wo, coat_normal));
    return {select(coat_mirror, reflect_about(wo, coat_normal), rough),
            grey(coat * fresnel / p_coat),
            select(coat_mirror, 0.0f, sqrt(coat_alpha)),
            coat_mirror || (dot(rough, coat_normal) > 0.0f),
            coat_mirror,
            never()};
  }

  HWY_INLINE Proposal propose_interface(Real u_choice, const Real2& u) const {
    Real3 h = {0.0f, 0.0f, 1.0f};
    if (any(!mirror)) h = select(mirror, h, facets.sample(wo, u));
    const Facet at = facet(dot(wo, h));
    const Bool reflects = u_choice < at.p_reflect;
    const Real3 reflected = reflect_about(wo, h);
    Proposal result = {reflected, {}, 0.0f, always(), mirror, !reflects};
    if (any(!reflects)) {
      result.wi = select(reflects, reflected, below(reflected));
      if (any_glass) {
        Real3 refracted{};
        const Bool gets_through = refract(wo, h, eta, refracted);
        const Bool in_glass = !reflects && (glass > 0.0f);
        result.wi = select(in_glass, refracted, result.wi);
        result.found = !in_glass || gets_through;
      }
    }
    const Bool up = result.wi.z > 0.0f;
    result.found = result.found && ((up && reflects) || (!up && !reflects));
    const Real p = p_interface * select(reflects, at.p_reflect, Real(1.0f) - at.p_reflect);
    result.weight = select(reflects, at.reflected, at.transmitted) / p;
    result.roughness = where(!mirror, sqrt(max(facets.alpha_x, facets.alpha_y)));
    return result;
  }

  HWY_INLINE static Bool always() { return Real(0.0f) <= 0.0f; }
  HWY_INLINE static Bool never() { return Real(0.0f) < 0.0f; }

  HWY_INLINE static Proposal choose(Bool mask, const Proposal& yes, const Proposal& no) {
    const auto pick = [&](Bool a, Bool b) HWY_ATTR { return (mask && a) || (!mask && b); };
    return {select(mask, yes.wi, no.wi),
            select(mask, yes.weight, no.weight),
            select(mask, yes.roughness, no.roughness),
            pick(yes.found, no.found),
            pick(yes.specular, no.specular),
            pick(yes.transmitted, no.transmitted)};
  }

  HWY_INLINE Proposal propose(Real u_lobe, const Real2& u) const {
    const Bool to_interface = u_lobe < p_interface;
    const Real after_interface = u_lobe - p_interface;
    const Bool to_diffuse = !to_interface && (after_interface < p_diffuse);
    const Real after_diffuse = after_interface - p_diffuse;
    const Bool to_coat = !to_interface && !to_diffuse && (after_diffuse < p_coat);
    const Bool to_through = !to_interface && !to_diffuse && !to_coat;

    const Real3 hemisphere = cosine_hemisphere(u);
    Proposal result = {hemisphere, {}, 1.0f, always(), never(), never()};
    if (any(to_interface)) {
      result = choose(to_interface, propose_interface(u_lobe / p_interface, u), result);
    }
    if (any_coat && any(to_coat)) result = choose(to_coat, propose_coat(u), result);
    if (any(to_through)) {
      const Proposal through_it = {below(hemisphere), {},      1.0f,
                                   p_through > 0.0f,  never(), always()};
      result = choose(to_through, through_it, result);
    }
    return result;
  }

  HWY_INLINE BsdfSampleReal sample(Real u_lobe, const Real2& u) const {
    const Proposal chosen = propose(u_lobe, u);
    BsdfSampleReal result{};
    result.wi = frame.to_world(chosen.wi);
    const Bool above = dot(result.wi, geometric_normal) > 0.0f;
    // Not on the wrong side of the geometric surface.
    result.found =
        chosen.found && ((above && !chosen.transmitted) || (!above && chosen.transmitted));
    result.specular = chosen.specular;
    result.transmitted = chosen.transmitted;
    result.roughness = chosen.roughness;
    BsdfValueReal value = evaluate_reflection(chosen.wi);
    if (transmits() && any(result.transmitted)) {
      value = select(result.transmitted, evaluate_transmission(chosen.wi), value);
    }
    result.found = result.found && (result.specular || (value.pdf > 0.0f));
    result.weight = select(result.specular, chosen.weight, value.f / value.pdf);
    result.pdf = where(!result.specular, value.pdf);
    return result;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
