// EnvironmentLight for one direction or sample a lane, operation for operation.
#include "math/fast_functions-inl.h"
#include "shading/environment_view.h"

#if defined(DAPPLE_SHADING_ENVIRONMENT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_SHADING_ENVIRONMENT_INL_H
#undef DAPPLE_SHADING_ENVIRONMENT_INL_H
#else
#define DAPPLE_SHADING_ENVIRONMENT_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

struct UvVec {
  FloatVec u, v;
};

HWY_INLINE UvVec environment_uv(const EnvironmentView& light, FloatVec3 d) {
  const FloatVec around = fast_atan2(d.z, d.x);
  const FloatVec u =
      hn::Add(hn::Add(hn::Mul(around, all(0.5f * kInvPi)), all(0.5f)), all(light.turn));
  return {hn::Sub(u, hn::Floor(u)), hn::Mul(fast_acos(d.y), all(kInvPi))};
}

HWY_INLINE SinCosVec sin_cos_signed_turns(FloatVec turns) {
  const FloatVec quarter_turns = hn::Mul(turns, all(4.0f));
  const FloatVec nearest = hn::Floor(hn::Add(quarter_turns, all(0.5f)));
  const FloatVec x = hn::Mul(hn::Sub(quarter_turns, nearest), all(1.57079632679f));
  return sin_cos_of_quadrant(x, hn::BitCast(Words(), hn::ConvertTo(Ints(), nearest)));
}

HWY_INLINE FloatVec3 environment_direction(const EnvironmentView& light, UvVec uv) {
  const SinCosVec polar = sin_cos_turns(hn::Mul(all(0.5f), uv.v));
  const SinCosVec around = sin_cos_signed_turns(hn::Sub(hn::Sub(uv.u, all(0.5f)), all(light.turn)));
  return {hn::Mul(polar.sin, around.cos), polar.cos, hn::Mul(polar.sin, around.sin)};
}

// Powers of two from biased exponents: mantissa times 2^(exponent - 136).
HWY_INLINE FloatVec3 decode_rgbe(WordVec word) {
  const WordVec byte = all_words(255);
  const WordVec exponent = hn::ShiftRight<24>(word);
  const FloatVec step = floats_of_bits(hn::ShiftLeft<23>(hn::Sub(exponent, all_words(9))));
  const FloatVec scale = hn::IfThenElseZero(float_mask(hn::Ne(exponent, hn::Zero(Words()))), step);
  return {hn::Mul(scale, to_floats(hn::And(word, byte))),
          hn::Mul(scale, to_floats(hn::And(hn::ShiftRight<8>(word), byte))),
          hn::Mul(scale, to_floats(hn::And(hn::ShiftRight<16>(word), byte)))};
}

HWY_INLINE FloatVec3 environment_texel(const EnvironmentView& light, WordVec index) {
  if (light.rgbe != nullptr) return decode_rgbe(gather(light.rgbe, index));
  const WordVec first = hn::Add(index, hn::Add(index, index));
  const auto* words = reinterpret_cast<const std::uint32_t*>(light.rgb);
  return {floats_of_bits(gather(words, first)), floats_of_bits(gather(words + 1, first)),
          floats_of_bits(gather(words + 2, first))};
}

// Columns or rows of texels; within the picture even where `x` is not a number.
HWY_INLINE WordVec texels_at(FloatVec x, std::int32_t count) {
  return hn::Min(to_words(x), all_words(static_cast<std::uint32_t>(count) - 1));
}

HWY_INLINE FloatVec3 environment_lookup(const EnvironmentView& light, UvVec uv) {
  const FloatVec zero = hn::Zero(Floats()), one = all(1.0f);
  const FloatVec width = all(static_cast<float>(light.width));
  const FloatVec height = all(static_cast<float>(light.height));
  const FloatVec x = hn::Sub(hn::Mul(uv.u, width), all(0.5f));
  const FloatVec y = hn::Sub(hn::Mul(uv.v, height), all(0.5f));
  const FloatVec i = hn::Floor(x), j = hn::Floor(y);
  const FloatVec fx = hn::Sub(x, i), fy = hn::Sub(y, j);
  const FloatVec last = hn::Sub(height, one);
  const FloatVec next = hn::Add(i, one);
  const WordVec x0 =
      texels_at(hn::IfThenElse(hn::Lt(i, zero), hn::Sub(width, one), i), light.width);
  const WordVec x1 = texels_at(hn::IfThenElse(hn::Lt(next, width), next, zero), light.width);
  const WordVec stride = all_words(static_cast<std::uint32_t>(light.width));
  const WordVec y0 = hn::Mul(texels_at(larger(j, zero), light.height), stride);
  const WordVec y1 = hn::Mul(texels_at(smaller(hn::Add(j, one), last), light.height), stride);
  const FloatVec rest_x = hn::Sub(one, fx), rest_y = hn::Sub(one, fy);
  const FloatVec3 upper = rest_x * environment_texel(light, hn::Add(y0, x0)) +
                          fx * environment_texel(light, hn::Add(y0, x1));
  const FloatVec3 lower = rest_x * environment_texel(light, hn::Add(y1, x0)) +
                          fx * environment_texel(light, hn::Add(y1, x1));
  return all(light.colour) * (rest_y * upper + fy * lower);
}

// One distribution a lane of PiecewiseConstant2d, `cells` long, from these elements on.
struct CellSearch {
  const float* cdfs;
  const std::uint32_t* guides;
  WordVec first_cdf, first_guide;
  std::uint32_t cells;
};
struct CellVec {
  WordVec cell;
  FloatVec within, mass;
};

HWY_INLINE FloatVec gather_floats(const float* base, WordVec index) {
  return hn::GatherIndex(Floats(), base, hn::BitCast(Ints(), index));
}

// The last cell that begins at or before u.
HWY_INLINE CellVec find_cell(const CellSearch& in, FloatVec u) {
  const Words d;
  const WordVec one = all_words(1), last = all_words(in.cells - 1);
  const FloatVec scaled = hn::Mul(u, all(static_cast<float>(in.cells)));
  const WordVec bucket = hn::Min(to_words(scaled), last);
  WordVec cell = gather(in.guides, hn::Add(in.first_guide, bucket));
  FloatVec begin = gather_floats(in.cdfs, hn::Add(in.first_cdf, cell));
  // Where rounding put u into the next bucket.
  for (;;) {
    const WordMask back = hn::And(word_mask(hn::Gt(begin, u)), hn::Gt(cell, hn::Zero(d)));
    if (HWY_LIKELY(hn::AllFalse(d, back))) break;
    cell = hn::Sub(cell, hn::IfThenElseZero(back, one));
    begin = gather_floats(in.cdfs, hn::Add(in.first_cdf, cell));
  }
  FloatVec end = gather_floats(in.cdfs, hn::Add(in.first_cdf, hn::Add(cell, one)));
  for (;;) {
    const WordMask forth = hn::And(word_mask(hn::Le(end, u)), hn::Lt(cell, last));
    if (hn::AllFalse(d, forth)) break;
    cell = hn::Add(cell, hn::IfThenElseZero(forth, one));
    begin = hn::IfThenElse(float_mask(forth), end, begin);
    end = gather_floats(in.cdfs, hn::Add(in.first_cdf, hn::Add(cell, one)));
  }
  const FloatVec mass = hn::Sub(end, begin);
  const FloatVec within =
      hn::IfThenElse(hn::Gt(mass, hn::Zero(Floats())), hn::Div(hn::Sub(u, begin), mass), all(0.5f));
  return {cell, smaller(within, all(0x1.fffffep-1f)), mass};
}

HWY_INLINE FloatVec per_solid_angle(FloatVec pdf, FloatVec cosine) {
  const FloatVec zero = hn::Zero(Floats()), one = all(1.0f);
  const FloatVec squared = hn::Mul(hn::Sub(one, cosine), hn::Add(one, cosine));
  const FloatVec sine = hn::Sqrt(larger(squared, zero));
  const FloatVec density = hn::Div(pdf, hn::Mul(all(2.0f * kPi * kPi), sine));
  return hn::IfThenElseZero(hn::Gt(sine, zero), density);
}

struct EnvironmentSampleVec {
  FloatVec3 direction, radiance;
  FloatVec pdf;
};

HWY_INLINE EnvironmentSampleVec sample_environment(const EnvironmentView& light, FloatVec u,
                                                   FloatVec v) {
  const WordVec zero = hn::Zero(Words());
  const FloatVec columns = all(static_cast<float>(light.columns));
  const FloatVec rows = all(static_cast<float>(light.rows));
  const CellVec row = find_cell({light.cdfs, light.guides, zero, zero, light.rows}, v);
  const WordVec first_cdf =
      hn::Add(all_words(light.rows + 1), hn::Mul(row.cell, all_words(light.columns + 1)));
  const WordVec first_guide =
      hn::Add(all_words(light.rows), hn::Mul(row.cell, all_words(light.columns)));
  const CellVec cell =
      find_cell({light.cdfs, light.guides, first_cdf, first_guide, light.columns}, u);
  const UvVec uv = {hn::Div(hn::Add(to_floats(cell.cell), cell.within), columns),
                    hn::Div(hn::Add(to_floats(row.cell), row.within), rows)};
  const FloatVec pdf = hn::Mul(hn::Mul(hn::Mul(row.mass, cell.mass), columns), rows);
  const FloatVec3 direction = environment_direction(light, uv);
  return {direction, environment_lookup(light, uv), per_solid_angle(pdf, direction.y)};
}

HWY_INLINE WordVec cells_of(FloatVec x, std::uint32_t count) {
  const FloatVec scaled = hn::Mul(larger(x, hn::Zero(Floats())), all(static_cast<float>(count)));
  return hn::Min(to_words(scaled), all_words(count - 1));
}

HWY_INLINE FloatVec environment_pdf(const EnvironmentView& light, UvVec uv, FloatVec cosine) {
  const WordVec one = all_words(1);
  const WordVec x = cells_of(uv.u, light.columns), y = cells_of(uv.v, light.rows);
  const WordVec at =
      hn::Add(hn::Add(all_words(light.rows + 1), x), hn::Mul(y, all_words(light.columns + 1)));
  const FloatVec of_row =
      hn::Sub(gather_floats(light.cdfs, hn::Add(y, one)), gather_floats(light.cdfs, y));
  const FloatVec of_cell =
      hn::Sub(gather_floats(light.cdfs, hn::Add(at, one)), gather_floats(light.cdfs, at));
  const FloatVec cells = all(static_cast<float>(light.columns * light.rows));
  return per_solid_angle(hn::Mul(hn::Mul(of_row, of_cell), cells), cosine);
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
