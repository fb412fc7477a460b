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

constexpr KernelTable kTable = {kIsa, intersect_wide, occluded_wide, intersect_linear,
                                occluded_linear};

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dapple {
namespace {

struct Level {
  std::int64_t target;
  const KernelTable* table;
};

// Best first. The last one runs everywhere.
constexpr Level kLevels[] = {
#if HWY_TARGETS & HWY_AVX3
    {HWY_AVX3, &N_AVX3::kTable},
#endif
#if HWY_TARGETS & HWY_AVX2
    {HWY_AVX2, &N_AVX2::kTable},
#endif
#if HWY_TARGETS & HWY_SSE4
    {HWY_SSE4, &N_SSE4::kTable},
#endif
#if HWY_TARGETS & HWY_SSSE3
    {HWY_SSSE3, &N_SSSE3::kTable},
#endif
    {HWY_STATIC_TARGET, &HWY_STATIC_DISPATCH(kTable)},
};

// No container: its functions would be weak symbols of an object that holds AVX-512 code.
struct TableList {
  const KernelTable* tables[sizeof(kLevels) / sizeof(kLevels[0])] = {};
  std::size_t count = 0;

  TableList() {
    const std::int64_t supported = hwy::SupportedTargets() | HWY_STATIC_TARGET;
    for (const Level& level : kLevels) {
      if ((supported & level.target) != 0) tables[count++] = level.table;
    }
  }
};

}  // namespace

std::span<const KernelTable* const> kernel_tables() {
  static const TableList list;
  return {list.tables, list.count};
}

}  // namespace dapple
#endif  // HWY_ONCE
