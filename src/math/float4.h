// Four floats at once, with what every x86-64 and every compiler has: the builder's boxes,
// texels.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace dapple {

#if defined(__SSE2__)

struct Float4 {
  __m128 v;

  static Float4 load(const float* p) { return {_mm_loadu_ps(p)}; }
  static Float4 all(float x) { return {_mm_set1_ps(x)}; }
  static Float4 of(float a, float b, float c, float d) { return {_mm_setr_ps(a, b, c, d)}; }
  static Float4 of_bytes(const std::uint8_t* p) {
    std::int32_t word;
    std::memcpy(&word, p, sizeof(word));
    const __m128i zero = _mm_setzero_si128();
    const __m128i halves = _mm_unpacklo_epi8(_mm_cvtsi32_si128(word), zero);
    return {_mm_cvtepi32_ps(_mm_unpacklo_epi16(halves, zero))};
  }
  void store(float* p) const { _mm_storeu_ps(p, v); }
  // The first three lanes; the fourth becomes 0.
  Float4 xyz() const { return {_mm_and_ps(v, _mm_castsi128_ps(_mm_set_epi32(0, -1, -1, -1)))}; }
  // Truncated to integers.
  void store_truncated(int* p) const {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(p), _mm_cvttps_epi32(v));
  }
};

inline Float4 min(Float4 a, Float4 b) { return {_mm_min_ps(a.v, b.v)}; }
inline Float4 max(Float4 a, Float4 b) { return {_mm_max_ps(a.v, b.v)}; }
inline Float4 operator+(Float4 a, Float4 b) { return {_mm_add_ps(a.v, b.v)}; }
inline Float4 operator-(Float4 a, Float4 b) { return {_mm_sub_ps(a.v, b.v)}; }
inline Float4 operator*(Float4 a, Float4 b) { return {_mm_mul_ps(a.v, b.v)}; }

#else

struct Float4 {
  float v[4];

  static Float4 load(const float* p) { return {{p[0], p[1], p[2], p[3]}}; }
  static Float4 all(float x) { return {{x, x, x, x}}; }
  static Float4 of(float a, float b, float c, float d) { return {{a, b, c, d}}; }
  static Float4 of_bytes(const std::uint8_t* p) {
    return {{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]),
             static_cast<float>(p[3])}};
  }
  void store(float* p) const {
    for (int i = 0; i < 4; ++i) p[i] = v[i];
  }
  Float4 xyz() const { return {{v[0], v[1], v[2], 0.0f}}; }
  void store_truncated(int* p) const {
    for (int i = 0; i < 4; ++i) p[i] = static_cast<int>(v[i]);
  }
};

template <class F>
Float4 per_lane(Float4 a, Float4 b, F f) {
  return {{f(a.v[0], b.v[0]), f(a.v[1], b.v[1]), f(a.v[2], b.v[2]), f(a.v[3], b.v[3])}};
}
inline Float4 min(Float4 a, Float4 b) {
  return per_lane(a, b, [](float x, float y) { return x < y ? x : y; });
}
inline Float4 max(Float4 a, Float4 b) {
  return per_lane(a, b, [](float x, float y) { return x > y ? x : y; });
}
inline Float4 operator+(Float4 a, Float4 b) {
  return per_lane(a, b, [](float x, float y) { return x + y; });
}
inline Float4 operator-(Float4 a, Float4 b) {
  return per_lane(a, b, [](float x, float y) { return x - y; });
}
inline Float4 operator*(Float4 a, Float4 b) {
  return per_lane(a, b, [](float x, float y) { return x * y; });
}

#endif

}  // namespace dapple
