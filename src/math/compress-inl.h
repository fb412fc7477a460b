// The lanes of a mask first, in their order; behind them stand zeros or copies of lane 0, which
// serve as an index where any of the others does.
//
// Not Highway's own: with gcc that copies its table of two kilobytes to the stack in each call for
// what has no such instruction.
#include "math/simd-inl.h"

#if defined(DAPPLE_MATH_COMPRESS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_MATH_COMPRESS_INL_H
#undef DAPPLE_MATH_COMPRESS_INL_H
#else
#define DAPPLE_MATH_COMPRESS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

#if HWY_TARGET <= HWY_AVX3

HWY_INLINE WordVec compress_lanes(WordVec v, std::uint32_t bits) {
  return WordVec{_mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), v.raw)};
}

#elif HWY_TARGET == HWY_AVX2

// For each mask of eight lanes: which lane goes to lane i, in the i-th four bits.
struct LaneOrders {
  std::uint32_t of[256];

  constexpr LaneOrders() : of{} {
    for (std::uint32_t bits = 0; bits < 256; ++bits) {
      std::uint32_t count = 0;
      for (std::uint32_t lane = 0; lane < 8; ++lane) {
        if ((bits >> lane & 1) != 0) of[bits] |= lane << (4 * count++);
      }
    }
  }
};
inline constexpr LaneOrders kLaneOrders;

HWY_INLINE WordVec compress_lanes(WordVec v, std::uint32_t bits) {
  const __m256i order = _mm256_set1_epi32(static_cast<int>(kLaneOrders.of[bits]));
  const __m256i shifts = _mm256_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28);
  // Of the index of a lane, only the lowest three bits count.
  return WordVec{_mm256_permutevar8x32_epi32(v.raw, _mm256_srlv_epi32(order, shifts))};
}

#elif HWY_TARGET == HWY_SCALAR

HWY_INLINE WordVec compress_lanes(WordVec v, std::uint32_t) { return v; }

#else

// For each mask of four lanes: which byte goes to byte i.
struct alignas(16) ByteOrders {
  std::uint8_t of[16][16];

  constexpr ByteOrders() : of{} {
    for (std::uint32_t bits = 0; bits < 16; ++bits) {
      for (std::uint8_t& byte : of[bits]) byte = 0x80;  // zero
      std::uint32_t count = 0;
      for (std::uint32_t byte = 0; byte < 16; ++byte) {
        if ((bits >> (byte / 4) & 1) != 0) of[bits][count++] = static_cast<std::uint8_t>(byte);
      }
    }
  }
};
inline constexpr ByteOrders kByteOrders;

HWY_INLINE WordVec compress_lanes(WordVec v, std::uint32_t bits) {
  const hn::Repartition<std::uint8_t, Words> bytes;
  const auto order = hn::Load(bytes, kByteOrders.of[bits]);
  return hn::BitCast(Words(), hn::TableLookupBytes(hn::BitCast(bytes, v), order));
}

#endif

HWY_INLINE WordVec compress(WordVec v, FloatMask mask) { return compress_lanes(v, bits_of(mask)); }
HWY_INLINE FloatVec compress(FloatVec v, FloatMask mask) {
  return floats_of_bits(compress(bits_of_floats(v), mask));
}
HWY_INLINE FloatVec3 compress(FloatVec3 v, FloatMask mask) {
  return {compress(v.x, mask), compress(v.y, mask), compress(v.z, mask)};
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
