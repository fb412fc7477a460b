// Compiled once for each instruction set, by Highway's foreach_target.
#include "accel/kernels/dispatch.h"
#include "render/kernels/path_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/kernels/targets.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "render/kernels/camera-inl.h"
#include "render/kernels/scatter_paths-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Only a constant: dispatch.cpp of the traversal decides which of them the processor can run.
constexpr PathKernels kPathKernels = {"", start_paths, scatter_paths, cut_paths, average_sums};

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dapple {
namespace {

constexpr PathKernels named(std::string_view isa, PathKernels kernels) {
  kernels.isa = isa;
  return kernels;
}

// The last one runs everywhere.
constexpr PathKernels kAllPathKernels[] = {
#if HWY_TARGETS & HWY_AVX3
    named("avx512", N_AVX3::kPathKernels),
#endif
#if HWY_TARGETS & HWY_AVX2
    named("avx2", N_AVX2::kPathKernels),
#endif
#if HWY_TARGETS & HWY_SSE4
    named("sse4", N_SSE4::kPathKernels),
#endif
#if HWY_TARGETS & HWY_SSSE3
    named("ssse3", N_SSSE3::kPathKernels),
#endif
    named("portable", HWY_STATIC_DISPATCH(kPathKernels)),
};

}  // namespace

const PathKernels& path_kernels() {
  const std::string_view isa = kernels().isa;
  const PathKernels* table = kAllPathKernels;
  while (table->isa != isa && table->isa != "portable") ++table;
  return *table;
}

}  // namespace dapple
#endif  // HWY_ONCE
