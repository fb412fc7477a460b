// Compiled once for each instruction set, by Highway's foreach_target.
#include "accel/kernels/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/kernels/targets.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "accel/kernels/linear-inl.h"
#include "accel/kernels/wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX3
constexpr const char* kIsa = "avx512";
#elif HWY_TARGET == HWY_AVX2
constexpr const char* kIsa = "avx2";
#elif HWY_TARGET == HWY_SSE4
constexpr const char* kIsa = "sse4";
#elif HWY_TARGET == HWY_SSSE3
constexpr const char* kIsa = "ssse3";
#else
constexpr const char* kIsa = "portable";
#endif

const KernelTable* table() {
  static const KernelTable kTable = {kIsa, intersect_wide, occluded_wide, intersect_linear,
                                     occluded_linear};
  return &kTable;
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dapple {

HWY_EXPORT(table);

namespace {

// No container: its functions would be weak symbols of an object that holds AVX-512 code.
struct TableList {
  const KernelTable* tables[64] = {};
  std::size_t count = 0;
};

TableList list_tables() {
  TableList list;
  // Lower bits of a target are better instruction sets.
  std::int64_t remaining = hwy::SupportedTargets() & HWY_TARGETS;
  while (remaining != 0) {
    const std::int64_t best = remaining & -remaining;
    remaining &= remaining - 1;
    hwy::SetSupportedTargetsForTest(best);
    hwy::GetChosenTarget().Update(best);
    list.tables[list.count++] = HWY_DYNAMIC_DISPATCH(table)();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return list;
}

}  // namespace

std::span<const KernelTable* const> kernel_tables() {
  static const TableList list = list_tables();
  return {list.tables, list.count};
}

}  // namespace dapple
#endif  // HWY_ONCE
