// Four floats together in memory, one such quad a lane, as vectors of their first, second, third
// and fourth numbers. For quads that stand anywhere this takes far fewer operations than gathers.
#include "math/simd-inl.h"

#if defined(DAPPLE_MATH_QUADS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_MATH_QUADS_INL_H
#undef DAPPLE_MATH_QUADS_INL_H
#else
#define DAPPLE_MATH_QUADS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

struct Quads {
  FloatVec of[4];
};

#if HWY_TARGET == HWY_SCALAR

template <class PlaceOf>
HWY_INLINE Quads load_quads(PlaceOf place_of) {
  const float* quad = place_of(0);
  return {{all(quad[0]), all(quad[1]), all(quad[2]), all(quad[3])}};
}
template <class PlaceOf>
HWY_INLINE void store_quads(const Quads& quads, PlaceOf place_of) {
  float* quad = place_of(0);
  for (std::size_t i = 0; i < 4; ++i) quad[i] = hn::GetLane(quads.of[i]);
}

#else

using Quad = hn::Vec<hn::FixedTag<float, 4> >;

HWY_INLINE Quad load_quad(const float* quad) { return hn::LoadU(hn::FixedTag<float, 4>(), quad); }
HWY_INLINE void store_quad(Quad v, float* quad) { hn::StoreU(v, hn::FixedTag<float, 4>(), quad); }

// Blocks of 128 bits: those of lanes i, i + 4, i + 8 and so on make vector i.
#if HWY_TARGET <= HWY_AVX3
template <class PlaceOf>
HWY_INLINE FloatVec load_blocks(PlaceOf place_of, std::size_t i) {
  __m512 v = _mm512_castps128_ps512(load_quad(place_of(i)).raw);
  v = _mm512_insertf32x4(v, load_quad(place_of(i + 4)).raw, 1);
  v = _mm512_insertf32x4(v, load_quad(place_of(i + 8)).raw, 2);
  return FloatVec{_mm512_insertf32x4(v, load_quad(place_of(i + 12)).raw, 3)};
}
template <class PlaceOf>
HWY_INLINE void store_blocks(FloatVec v, PlaceOf place_of, std::size_t i) {
  store_quad(Quad{_mm512_castps512_ps128(v.raw)}, place_of(i));
  store_quad(Quad{_mm512_extractf32x4_ps(v.raw, 1)}, place_of(i + 4));
  store_quad(Quad{_mm512_extractf32x4_ps(v.raw, 2)}, place_of(i + 8));
  store_quad(Quad{_mm512_extractf32x4_ps(v.raw, 3)}, place_of(i + 12));
}
#elif HWY_TARGET == HWY_AVX2
template <class PlaceOf>
HWY_INLINE FloatVec load_blocks(PlaceOf place_of, std::size_t i) {
  const __m256 v = _mm256_castps128_ps256(load_quad(place_of(i)).raw);
  return FloatVec{_mm256_insertf128_ps(v, load_quad(place_of(i + 4)).raw, 1)};
}
template <class PlaceOf>
HWY_INLINE void store_blocks(FloatVec v, PlaceOf place_of, std::size_t i) {
  store_quad(Quad{_mm256_castps256_ps128(v.raw)}, place_of(i));
  store_quad(Quad{_mm256_extractf128_ps(v.raw, 1)}, place_of(i + 4));
}
#else
static_assert(kLanes == 4);
template <class PlaceOf>
HWY_INLINE FloatVec load_blocks(PlaceOf place_of, std::size_t i) {
  return load_quad(place_of(i));
}
template <class PlaceOf>
HWY_INLINE void store_blocks(FloatVec v, PlaceOf place_of, std::size_t i) {
  store_quad(v, place_of(i));
}
#endif

// Rows and columns of each 4 x 4 block exchanged.
HWY_INLINE Quads transpose(const Quads& quads) {
  const Floats d;
  const hn::RepartitionToWide<Floats> pairs;
  const auto low = [&](std::size_t i) HWY_ATTR {
    return hn::BitCast(pairs, hn::InterleaveLower(d, quads.of[i], quads.of[i + 1]));
  };
  const auto high = [&](std::size_t i) HWY_ATTR {
    return hn::BitCast(pairs, hn::InterleaveUpper(d, quads.of[i], quads.of[i + 1]));
  };
  const auto a = low(0), b = low(2), c = high(0), e = high(2);
  return {{hn::BitCast(d, hn::InterleaveLower(pairs, a, b)),
           hn::BitCast(d, hn::InterleaveUpper(pairs, a, b)),
           hn::BitCast(d, hn::InterleaveLower(pairs, c, e)),
           hn::BitCast(d, hn::InterleaveUpper(pairs, c, e))}};
}

// The quads at place_of(lane) of all lanes.
template <class PlaceOf>
HWY_INLINE Quads load_quads(PlaceOf place_of) {
  return transpose({{load_blocks(place_of, 0), load_blocks(place_of, 1), load_blocks(place_of, 2),
                     load_blocks(place_of, 3)}});
}
template <class PlaceOf>
HWY_INLINE void store_quads(const Quads& quads, PlaceOf place_of) {
  const Quads blocks = transpose(quads);
  for (std::size_t i = 0; i < 4; ++i) store_blocks(blocks.of[i], place_of, i);
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
