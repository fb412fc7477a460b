// Puts the children of a node that a ray enters on its stack.
//
// How many there are is not known to a branch predictor, so vectors sort them without branches
// where the instruction set has what that takes.
#include "accel/kernels/stack-inl.h"
#include "math/compress-inl.h"

#if defined(DAPPLE_KERNELS_PUSH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_PUSH_INL_H
#undef DAPPLE_KERNELS_PUSH_INL_H
#else
#define DAPPLE_KERNELS_PUSH_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

inline constexpr std::size_t kNodeVecs = kWideWidth / kLanes;

#if HWY_TARGET <= HWY_AVX3

// One step of a sorting network: lane i and lane partner[i] are put in order, the larger one into
// the lanes of `larger`.
template <int kPartnerDistance>
HWY_INLINE WordVec exchange(WordVec v, __mmask16 larger) {
  WordVec partner;
  if (kPartnerDistance == 1) {
    partner = hn::Shuffle2301(v);
  } else if (kPartnerDistance == 2) {
    partner = hn::Shuffle1032(v);
  } else if (kPartnerDistance == 4) {
    partner = WordVec{_mm512_shuffle_i32x4(v.raw, v.raw, _MM_SHUFFLE(2, 3, 0, 1))};
  } else {
    partner = WordVec{_mm512_shuffle_i32x4(v.raw, v.raw, _MM_SHUFFLE(1, 0, 3, 2))};
  }
  return WordVec{
      _mm512_mask_max_epu32(_mm512_min_epu32(v.raw, partner.raw), larger, v.raw, partner.raw)};
}

// Bitonic sort [Batcher68] of the first 4 or 16 lanes, the largest first.
HWY_INLINE WordVec sort_4(WordVec v) {
  v = exchange<1>(v, 0x9999);
  v = exchange<2>(v, 0x3333);
  return exchange<1>(v, 0x5555);
}
HWY_INLINE WordVec sort_16(WordVec v) {
  v = exchange<1>(v, 0x9999);
  v = exchange<2>(v, 0xc3c3);
  v = exchange<1>(v, 0xa5a5);
  v = exchange<4>(v, 0xf00f);
  v = exchange<2>(v, 0xcc33);
  v = exchange<1>(v, 0xaa55);
  v = exchange<8>(v, 0x00ff);
  v = exchange<4>(v, 0x0f0f);
  v = exchange<2>(v, 0x3333);
  return exchange<1>(v, 0x5555);
}

// Puts the children that were hit on the stack, all at once, the nearest on top.
HWY_INLINE void push_children(const LaneHits* hits, const ChildRef* children, PendingStack& stack) {
  const Words d;
  const std::uint32_t hit = bits_of(hits->mask);
  const WordVec near = hn::BitCast(d, hits->t);
  const WordVec keys = hn::Or(hn::AndNot(hn::Set(d, 15), near), hn::Iota(d, 0));
  const auto count = static_cast<std::size_t>(__builtin_popcount(hit));
  WordVec sorted = compress_lanes(keys, hit);
  sorted = count <= 4 ? sort_4(sorted) : sort_16(sorted);
  const WordVec refs = hn::Load(d, reinterpret_cast<const std::uint32_t*>(children));
  hn::StoreU(sorted, d, stack.keys + stack.top);
  hn::StoreU(WordVec{_mm512_permutexvar_epi32(sorted.raw, refs.raw)}, d,
             stack.children + stack.top);
  stack.top += count;
}

#elif HWY_TARGET == HWY_AVX2

template <int kPartnerDistance, int kLarger>
HWY_INLINE __m256i exchange(__m256i v) {
  const __m256i partner = kPartnerDistance == 1   ? _mm256_shuffle_epi32(v, 0xb1)
                          : kPartnerDistance == 2 ? _mm256_shuffle_epi32(v, 0x4e)
                                                  : _mm256_permute2x128_si256(v, v, 1);
  return _mm256_blend_epi32(_mm256_min_epu32(v, partner), _mm256_max_epu32(v, partner), kLarger);
}

// Bitonic sort [Batcher68], the largest first.
HWY_INLINE __m256i sort_8(__m256i v) {
  v = exchange<1, 0x99>(v);
  v = exchange<2, 0xc3>(v);
  v = exchange<1, 0xa5>(v);
  v = exchange<4, 0x0f>(v);
  v = exchange<2, 0x33>(v);
  return exchange<1, 0x55>(v);
}

// Lane i of the second vector behind the first `count` lanes of the first, zeros behind `both`.
HWY_INLINE __m256i join(WordVec first, WordVec second, std::size_t count, std::size_t both) {
  const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  const __m256i begin = _mm256_set1_epi32(static_cast<int>(count));
  const __m256i end = _mm256_set1_epi32(static_cast<int>(both));
  const __m256i moved = _mm256_permutevar8x32_epi32(second.raw, _mm256_sub_epi32(lane, begin));
  const __m256i in_first = _mm256_cmpgt_epi32(begin, lane);
  return _mm256_and_si256(_mm256_blendv_epi8(moved, first.raw, in_first),
                          _mm256_cmpgt_epi32(end, lane));
}

// Puts the children that were hit on the stack, all at once, the nearest on top.
HWY_INLINE void push_children(const LaneHits* hits, const ChildRef* children, PendingStack& stack) {
  const Words d;
  const auto* refs = reinterpret_cast<const std::uint32_t*>(children);
  WordVec keys[kNodeVecs];
  std::size_t counts[kNodeVecs];
  for (std::uint32_t i = 0; i < kNodeVecs; ++i) {
    const WordVec near = hn::AndNot(hn::Set(d, 15), hn::BitCast(d, hits[i].t));
    const std::uint32_t hit = bits_of(hits[i].mask);
    keys[i] = compress_lanes(hn::Or(near, hn::Iota(d, i * kLanes)), hit);
    counts[i] = static_cast<std::size_t>(__builtin_popcount(hit));
  }
  const std::size_t count = counts[0] + counts[1];
  const std::size_t bottom = stack.top;
  stack.top += count;
  if (HWY_LIKELY(count <= kLanes)) {
    const WordVec sorted{sort_8(join(keys[0], keys[1], counts[0], count))};
    const WordVec child = hn::And(sorted, hn::Set(d, 15));
    hn::StoreU(sorted, d, stack.keys + bottom);
    hn::StoreU(gather(refs, child), d, stack.children + bottom);
    return;
  }
  hn::StoreU(keys[0], d, stack.keys + bottom);
  hn::StoreU(keys[1], d, stack.keys + bottom + counts[0]);
  for (std::size_t i = bottom; i < stack.top; ++i) {
    const std::uint32_t key = stack.keys[i];
    std::size_t place = i;
    for (; place != bottom && stack.keys[place - 1] < key; --place) {
      stack.keys[place] = stack.keys[place - 1];
    }
    stack.keys[place] = key;
  }
  for (std::size_t i = bottom; i < stack.top; ++i) {
    stack.children[i] = refs[stack.keys[i] & 15];
  }
}

#else

// Puts the children that were hit on the stack by insertion, the nearest on top.
HWY_INLINE void push_children(const LaneHits* hits, const ChildRef* children, PendingStack& stack) {
  const std::size_t bottom = stack.top;
  for (std::size_t i = 0; i < kNodeVecs; ++i) {
    alignas(64) float near[kLanes];
    hn::Store(hits[i].t, Floats(), near);
    for (std::uint32_t bits = bits_of(hits[i].mask); bits != 0;) {
      const std::uint32_t lane = take_lowest(bits);
      std::uint32_t key;
      __builtin_memcpy(&key, near + lane, sizeof key);
      std::size_t place = stack.top++;
      for (; place != bottom && stack.keys[place - 1] < key; --place) {
        stack.keys[place] = stack.keys[place - 1];
        stack.children[place] = stack.children[place - 1];
      }
      stack.keys[place] = key;
      stack.children[place] = children[i * kLanes + lane].bits;
    }
  }
}

#endif

#if HWY_TARGET <= HWY_AVX2

// The same in no order, for rays that only ask whether they hit.
HWY_INLINE void push_children_unordered(const LaneHits* hits, const ChildRef* children,
                                        PendingStack& stack) {
  const Words d;
  for (std::size_t i = 0; i < kNodeVecs; ++i) {
    const WordVec refs = hn::Load(d, reinterpret_cast<const std::uint32_t*>(children + i * kLanes));
    const std::uint32_t hit = bits_of(hits[i].mask);
    hn::StoreU(compress_lanes(refs, hit), d, stack.children + stack.top);
    stack.top += static_cast<std::size_t>(__builtin_popcount(hit));
  }
}

#else

HWY_INLINE void push_children_unordered(const LaneHits* hits, const ChildRef* children,
                                        PendingStack& stack) {
  for (std::size_t i = 0; i < kNodeVecs; ++i) {
    for (std::uint32_t bits = bits_of(hits[i].mask); bits != 0;) {
      stack.children[stack.top++] = children[i * kLanes + take_lowest(bits)].bits;
    }
  }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
