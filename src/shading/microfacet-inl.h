// microfacet.h, sheen.h, fresnel.h, refraction.h and albedo_tables.h on lanes.
#include "math/fast_functions-inl.h"
#include "math/real-inl.h"
#include "shading/albedo_tables.h"

#if defined(DAPPLE_SHADING_MICROFACET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_SHADING_MICROFACET_INL_H
#undef DAPPLE_SHADING_MICROFACET_INL_H
#else
#define DAPPLE_SHADING_MICROFACET_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

struct FacetsReal {
  Real alpha_x, alpha_y;

  HWY_INLINE Real d(const Real3& h) const {
    const Real x = h.x / alpha_x, y = h.y / alpha_y;
    const Real s = x * x + y * y + h.z * h.z;
    return Real(kInvPi) / (alpha_x * alpha_y * s * s);
  }
  HWY_INLINE Real lambda(const Real3& w) const {
    const Real x = alpha_x * w.x, y = alpha_y * w.y;
    const Real z2 = max(w.z * w.z, 1e-18f);
    return Real(0.5f) * (sqrt(Real(1.0f) + (x * x + y * y) / z2) - 1.0f);
  }
  HWY_INLINE Real3 sample(const Real3& w, const Real2& u) const {
    const Real3 stretched = normalize(Real3(alpha_x * w.x, alpha_y * w.y, w.z));
    const Real z = (Real(1.0f) - u.y) * (Real(1.0f) + stretched.z) - stretched.z;
    const Real squared = (Real(1.0f) - z) * (Real(1.0f) + z);
    const Real r = where(squared > 0.0f, sqrt(squared));
    const SinCosVec angle = sin_cos_turns(u.x.v);
    const Real3 h = Real3(r * Real(angle.cos), r * Real(angle.sin), z) + stretched;
    return normalize(Real3(alpha_x * h.x, alpha_y * h.y, max(h.z, 1e-7f)));
  }
};

// By angles to the normal alone.
struct IsotropicReal {
  Real alpha2;

  HWY_INLINE Real d(Real sin2) const {
    const Real s = sin2 + alpha2 * (Real(1.0f) - sin2);
    return Real(kInvPi) * alpha2 / (s * s);
  }
  HWY_INLINE Real lambda(Real cosine) const {
    const Real z2 = max(cosine * cosine, 1e-18f);
    return Real(0.5f) * (sqrt(Real(1.0f) + alpha2 * max(Real(1.0f) - z2, 0.0f) / z2) - 1.0f);
  }
};

class SheenReal {
 public:
  HWY_INLINE explicit SheenReal(Real roughness) {
    const Real r = max(roughness, 0.1f);
    const Real alpha = r * r;
    inverse_alpha_ = Real(1.0f) / alpha;
    const Real t = (Real(1.0f) - alpha) * (Real(1.0f) - alpha);
    a_ = mix(21.5473f, 25.3245f, t);
    b_ = mix(3.82987f, 3.32435f, t);
    c_ = mix(0.19823f, 0.16801f, t);
    d_ = mix(-1.97760f, -1.27393f, t);
    e_ = mix(-4.32054f, -4.85967f, t);
  }

  HWY_INLINE Real evaluate(const Real3& wo, const Real3& wi) const {
    const Real3 h = normalize(wo + wi);
    const Real sin2 = max(Real(1.0f) - h.z * h.z, 0.0f);
    const Real power = fast_pow(sin2.v, (Real(0.5f) * inverse_alpha_).v);
    const Real d = (Real(2.0f) + inverse_alpha_) * power * (0.5f * kInvPi);
    const Real shadowing = Real(1.0f) / (Real(1.0f) + lambda(wo.z) + lambda(wi.z));
    return d * shadowing / (Real(4.0f) * max(wo.z, 1e-4f));
  }

 private:
  HWY_INLINE Real fit(Real x) const {
    return a_ / (Real(1.0f) + b_ * Real(fast_pow(x.v, c_.v))) + d_ * x + e_;
  }
  HWY_INLINE Real lambda(Real cosine) const {
    const Bool grazing = cosine < 0.5f;
    const Real at = fit(select(grazing, cosine, Real(1.0f) - cosine));
    return fast_exp(select(grazing, at, Real(2.0f) * fit(0.5f) - at).v);
  }

  Real inverse_alpha_, a_, b_, c_, d_, e_;
};

HWY_INLINE Real schlick_weight(Real cosine) {
  const Real c = where(cosine < 1.0f, Real(1.0f) - cosine);
  const Real c2 = c * c;
  return c2 * c2 * c;
}

HWY_INLINE Real f0_of_ior(Real ior) {
  const Real root = (ior - 1.0f) / (ior + 1.0f);
  return root * root;
}

HWY_INLINE Real fresnel_dielectric(Real cosine, Real eta) {
  const Real g2 = eta * eta - 1.0f + cosine * cosine;
  const Real g = sqrt(g2);
  const Real a = (g - cosine) / (g + cosine);
  const Real b = ((g + cosine) * cosine - 1.0f) / ((g - cosine) * cosine + 1.0f);
  return select(g2 > 0.0f, Real(0.5f) * a * a * (Real(1.0f) + b * b), 1.0f);
}

HWY_INLINE Real3 reflect_about(const Real3& w, const Real3& h) {
  return Real(2.0f) * dot(w, h) * h - w;
}

// Lanes in which something gets through.
HWY_INLINE Bool refract(const Real3& w, const Real3& h, Real eta, Real3& result) {
  const Real inverse = Real(1.0f) / eta;
  const Real cosine = dot(w, h);
  const Real squared = Real(1.0f) - inverse * inverse * (Real(1.0f) - cosine * cosine);
  result = (inverse * cosine - sqrt(squared)) * h - inverse * w;
  return squared > 0.0f;
}

struct TablePlace {
  WordVec index;
  Real t;
};
HWY_INLINE TablePlace table_place(Real x, std::uint32_t nodes) {
  const Real scaled = clamp(x, 0.0f, 1.0f) * static_cast<float>(nodes - 1);
  const WordVec index = hn::Min(to_words(scaled.v), all_words(nodes - 2));
  return {index, scaled - Real(to_floats(index))};
}

// Elements `index` and the next of a table of AlbedoPairs, mixed by t.
HWY_INLINE Real mixed_neighbours(const std::uint32_t* table, WordVec index, Real t) {
  const WordVec both = gather(table, index);
  const Real first = to_floats(hn::And(both, all_words(0xffffu)));
  const Real second = to_floats(hn::ShiftRight<16>(both));
  return (Real(1.0f) - t) * first + t * second;
}

HWY_INLINE Real bilinear(const std::uint32_t* table, std::uint32_t columns, const TablePlace& row,
                         const TablePlace& column, WordVec first) {
  const WordVec near =
      hn::Add(first, hn::Add(hn::Mul(row.index, all_words(columns)), column.index));
  const WordVec far = hn::Add(near, all_words(columns));
  return Real(1.0f / 65535) * ((Real(1.0f) - row.t) * mixed_neighbours(table, near, column.t) +
                               row.t * mixed_neighbours(table, far, column.t));
}
HWY_INLINE Real bilinear(const std::uint32_t* table, std::uint32_t columns, const TablePlace& row,
                         const TablePlace& column) {
  return bilinear(table, columns, row, column, hn::Zero(Words()));
}

HWY_INLINE Real root_of_cosine(Real cosine) { return sqrt(clamp(cosine, 0.0f, 1.0f)); }

struct ReflectionAlbedoReal {
  Real scale, bias;
  HWY_INLINE Real total() const { return scale + bias; }
};

class AlbedosReal {
 public:
  HWY_INLINE explicit AlbedosReal(const AlbedoPairs& tables) : tables_(tables) {}

  HWY_INLINE ReflectionAlbedoReal reflection(Real cosine, Real roughness) const {
    const TablePlace row = table_place(roughness, kAlbedoRoughnesses);
    const TablePlace column = table_place(root_of_cosine(cosine), kAlbedoCosines);
    return {bilinear(words(tables_.reflection_scale), kAlbedoCosines, row, column),
            bilinear(words(tables_.reflection_bias), kAlbedoCosines, row, column)};
  }
  HWY_INLINE ReflectionAlbedoReal brushed(const Real3& wo, Real alpha_x, Real alpha_y) const {
    const Bool along_x = alpha_x > alpha_y;
    const Real wide = sqrt(select(along_x, alpha_x, alpha_y));
    const Real narrow = sqrt(select(along_x, alpha_y, alpha_x));
    const Real level = sqrt(wo.x * wo.x + wo.y * wo.y);
    const Real ratio = abs(select(along_x, wo.x, wo.y)) / level;
    const TablePlace across = table_place(narrow, kBrushedNodes);
    const TablePlace spread =
        table_place(where(narrow < 1.0f, (wide - narrow) / (Real(1.0f) - narrow)), kBrushedNodes);
    const TablePlace azimuth = table_place(select(level > 0.0f, ratio, 1.0f), kBrushedNodes);
    const TablePlace column = table_place(root_of_cosine(wo.z), kBrushedCosines);
    const WordVec first = hn::Add(hn::Mul(across.index, all_words(kBrushedNodes)), spread.index);
    ReflectionAlbedoReal sum{0.0f, 0.0f};
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      const std::uint32_t i = corner & 1, j = corner >> 1;
      const WordVec sheet = hn::Mul(hn::Add(first, all_words(i * kBrushedNodes + j)),
                                    all_words(kBrushedNodes * kBrushedCosines));
      const Real weight =
          (i == 1 ? across.t : Real(1.0f) - across.t) * (j == 1 ? spread.t : Real(1.0f) - spread.t);
      sum.scale = sum.scale + weight * bilinear(words(tables_.brushed_scale), kBrushedCosines,
                                                azimuth, column, sheet);
      sum.bias = sum.bias + weight * bilinear(words(tables_.brushed_bias), kBrushedCosines, azimuth,
                                              column, sheet);
    }
    return sum;
  }
  HWY_INLINE Real refraction(Real cosine, Real roughness, Real eta) const {
    const TablePlace row = table_place(roughness, kRefractionRoughnesses);
    const TablePlace column = table_place(root_of_cosine(cosine), kRefractionCosines);
    constexpr float kScale = (kLargestEta + 1) / (kLargestEta - 1);
    const Real x = sqrt(Real(kScale) * abs(eta - 1.0f) / (eta + 1.0f));
    return select(
        eta > 1.0f,
        refraction_sheets(words(tables_.refraction_in), kRefractionInEtas, x, row, column),
        refraction_sheets(words(tables_.refraction_out), kRefractionOutEtas, x, row, column));
  }
  HWY_INLINE Real sheen(Real cosine, Real roughness) const {
    return Real(kSheenScale) * bilinear(words(tables_.sheen), kSheenCosines,
                                        table_place(roughness, kSheenRoughnesses),
                                        table_place(root_of_cosine(cosine), kSheenCosines));
  }

 private:
  // Without a call into std::array, whose functions are templates.
  template <class Table>
  HWY_INLINE static const std::uint32_t* words(const Table& table) {
    return reinterpret_cast<const std::uint32_t*>(&table);
  }

  HWY_INLINE static Real refraction_sheets(const std::uint32_t* data, std::uint32_t etas, Real x,
                                           const TablePlace& row, const TablePlace& column) {
    constexpr std::uint32_t kSheet = kRefractionRoughnesses * kRefractionCosines;
    const TablePlace sheet = table_place(x, etas);
    const WordVec near = hn::Mul(sheet.index, all_words(kSheet));
    const WordVec far = hn::Add(near, all_words(kSheet));
    return (Real(1.0f) - sheet.t) * bilinear(data, kRefractionCosines, row, column, near) +
           sheet.t * bilinear(data, kRefractionCosines, row, column, far);
  }

  const AlbedoPairs& tables_;
};

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
