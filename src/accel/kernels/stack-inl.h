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

#if HWY_TARGET <= HWY_AVX2

// All of the topmost entries at once: how many are too far is data, not a branch.
HWY_INLINE ChildRef pop_nearest(PendingStack& stack, float t_best) {
  const Words d;
  while (true) {
    const WordVec keys = hn::LoadU(d, stack.keys + stack.top - kLanes);
    const FloatVec near = hn::BitCast(Floats(), hn::AndNot(hn::Set(d, 15), keys));
    const std::uint32_t in_time = bits_of(hn::Le(near, all(t_best)));
    if (HWY_LIKELY(in_time != 0)) {
      const auto above = static_cast<std::size_t>(__builtin_clz(in_time)) - (32 - kLanes) + 1;
      stack.top -= above;
      return ChildRef(stack.children[stack.top]);
    }
    stack.top -= kLanes;
  }
}

#else

HWY_INLINE ChildRef pop_nearest(PendingStack& stack, float t_best) {
  while (true) {
    --stack.top;
    float near;
    __builtin_memcpy(&near, stack.keys + stack.top, sizeof near);
    if (near <= t_best) return ChildRef(stack.children[stack.top]);
  }
}

#endif

HWY_INLINE ChildRef pop_any(PendingStack& stack) { return ChildRef(stack.children[--stack.top]); }

// Asks for the memory that visiting `child` will read: seven cache lines of a node, five or more of
// a leaf. Where these are is computed without a branch, which half the time would be predicted
// wrongly; what is empty gives some address, and asking for that is harmless.
HWY_INLINE void prefetch(const WideBvhView& bvh, ChildRef child) {
  const std::uint64_t bits = child.bits;
  const std::uint64_t if_leaf = 0 - (bits >> 31);
  const auto rows = reinterpret_cast<std::uint64_t>(bvh.rows.data());
  const auto nodes = reinterpret_cast<std::uint64_t>(bvh.nodes.data());
  const std::uint64_t leaf = rows + (bits & ChildRef::kMaxRow) * sizeof(LeafRow);
  const std::uint64_t node = nodes + bits * sizeof(WideNode);
  const char* begin = reinterpret_cast<const char*>((leaf & if_leaf) | (node & ~if_leaf));
  for (int line = 0; line < 7; ++line) __builtin_prefetch(begin + 64 * line);
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
