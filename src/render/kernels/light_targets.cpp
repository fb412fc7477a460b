// Compiled once for each instruction set, by Highway's foreach_target.
#include "accel/kernels/dispatch.h"
#include "render/kernels/light_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/kernels/light_targets.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "render/kernels/light_paths-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Only a constant: dispatch.cpp of the traversal decides which of them the processor can run.
constexpr LightKernels kLightKernels = {
    "",          start_chunk,          draw_chunk, sample_environment_chunk, describe_chunk,
    shade_chunk, see_environment_chunk};

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dapple {
namespace {

constexpr LightKernels named(std::string_view isa, LightKernels kernels) {
  kernels.isa = isa;
  return kernels;
}

// The last one runs everywhere.
constexpr LightKernels kAllLightKernels[] = {
#if HWY_TARGETS & HWY_AVX3
    named("avx512", N_AVX3::kLightKernels),
#endif
#if HWY_TARGETS & HWY_AVX2
    named("avx2", N_AVX2::kLightKernels),
#endif
#if HWY_TARGETS & HWY_SSE4
    named("sse4", N_SSE4::kLightKernels),
#endif
#if HWY_TARGETS & HWY_SSSE3
    named("ssse3", N_SSSE3::kLightKernels),
#endif
    named("portable", HWY_STATIC_DISPATCH(kLightKernels)),
};

}  // namespace

const LightKernels& light_kernels() {
  const std::string_view isa = kernels().isa;
  const LightKernels* table = kAllLightKernels;
  while (table->isa != isa && table->isa != "portable") ++table;
  return *table;
}

}  // namespace dapple
#endif  // HWY_ONCE
