#include "util/float_mode.h"

#include <gtest/gtest.h>

#if defined(__SSE__)

namespace dapple {
namespace {

constexpr unsigned kFlushToZero = 0x8000;

float tiny_product() {
  volatile float a = 1e-30f, b = 1e-10f;
  return a * b;  // a denormal number
}

TEST(FloatMode, KeepsDenormalsInsideAndGivesBackWhatWasBefore) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | kFlushToZero);
  EXPECT_EQ(tiny_product(), 0.0f);
  {
    const StandardFloatMode standard;
    EXPECT_GT(tiny_product(), 0.0f);
  }
  EXPECT_EQ(tiny_product(), 0.0f);
  _mm_setcsr(before);
}

}  // namespace
}  // namespace dapple

#endif
