// The stack of children that a search has yet to visit, the nearest on top.
//
// An entry is the distance at which the ray enters the child's box and the child. Distances are
// not negative, so their bits order as integers; the four lowest bits are replaced by the child's
// lane, which makes an entry's distance a little too small: a child may be visited for nothing,
// never missed.
#include "accel/kernels/leaf-inl.h"
#include "scene/wide_bvh.h"

#if defined(DAPPLE_KERNELS_STACK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_STACK_INL_H
#undef DAPPLE_KERNELS_STACK_INL_H
#else
#define DAPPLE_KERNELS_STACK_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Every level of the tree leaves at most all children but one behind. Below the entries stands
// one vector of entries that are always near enough and denote no child; above them, room for
// whole vectors to be stored.
inline constexpr std::size_t kStackBottom = 16;
inline constexpr std::size_t kStackSize = kStackBottom + kMaxWideDepth * (kWideWidth - 1) + 1 + 32;

struct PendingStack {
  std::uint32_t keys[kStackSize];      // bits of the entry distance
  std::uint32_t children[kStackSize];  // bits of a ChildRef
  std::size_t top;
};

// Once, before the first use; what stands at the bottom is never written again.
HWY_INLINE void make_bottom(PendingStack& stack) {
  for (std::size_t i = 0; i < kStackBottom; ++i) {
    stack.keys[i] = 0xff800000u;  // -infinity
    stack.children[i] = ChildRef::kEmpty;
  }
}

HWY_INLINE void clear(PendingStack& stack) { stack.top = kStackBottom; }

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

// Bitonic sort [Batcher68] of the first 4, 8 or 16 lanes, the largest first.
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
HWY_INLINE void push_children(LaneHits hits, const ChildRef* children, std::size_t /*bottom*/,
                              PendingStack& stack) {
  const Words d;
  const WordVec lane = hn::Iota(d, 0);
  const WordVec near = hn::BitCast(d, hits.t);
  const WordVec keys = hn::Or(hn::AndNot(hn::Set(d, 15), near), lane);
  const auto count = static_cast<std::size_t>(__builtin_popcount(hits.mask.raw));
  WordVec sorted{_mm512_maskz_compress_epi32(hits.mask.raw, keys.raw)};
  sorted = count <= 4 ? sort_4(sorted) : sort_16(sorted);
  const WordVec refs = hn::Load(d, reinterpret_cast<const std::uint32_t*>(children));
  hn::StoreU(sorted, d, stack.keys + stack.top);
  hn::StoreU(WordVec{_mm512_permutexvar_epi32(sorted.raw, refs.raw)}, d,
             stack.children + stack.top);
  stack.top += count;
}

HWY_INLINE ChildRef pop_nearest(PendingStack& stack, float t_best) {
  const Words d;
  while (true) {
    const WordVec keys = hn::LoadU(d, stack.keys + stack.top - 16);
    const FloatVec near = hn::BitCast(Floats(), hn::AndNot(hn::Set(d, 15), keys));
    const auto in_time = static_cast<std::uint32_t>(hn::Le(near, all(t_best)).raw);
    if (HWY_LIKELY(in_time != 0)) {
      const auto above = static_cast<std::size_t>(__builtin_clz(in_time)) - 15;
      stack.top -= above;
      return ChildRef(stack.children[stack.top]);
    }
    stack.top -= 16;
  }
}

#else

// Puts the children that were hit on the stack by insertion, the nearest on top. `bottom` is where
// the children of this node begin.
HWY_INLINE void push_children(LaneHits hits, const ChildRef* children, std::size_t bottom,
                              PendingStack& stack) {
  alignas(64) float near[kLanes];
  hn::Store(hits.t, Floats(), near);
  for (std::uint32_t bits = bits_of(hits.mask); bits != 0;) {
    const std::uint32_t lane = take_lowest(bits);
    std::uint32_t key;
    __builtin_memcpy(&key, near + lane, sizeof key);
    std::size_t place = stack.top++;
    for (; place != bottom && stack.keys[place - 1] < key; --place) {
      stack.keys[place] = stack.keys[place - 1];
      stack.children[place] = stack.children[place - 1];
    }
    stack.keys[place] = key;
    stack.children[place] = children[lane].bits;
  }
}

HWY_INLINE ChildRef pop_nearest(PendingStack& stack, float t_best) {
  while (true) {
    --stack.top;
    float near;
    __builtin_memcpy(&near, stack.keys + stack.top, sizeof near);
    if (near <= t_best) return ChildRef(stack.children[stack.top]);
  }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
