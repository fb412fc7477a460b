#include "dapple/scaling/core_guard.h"

#include <gtest/gtest.h>

#include "parallel/pinning.h"

namespace dapple::scaling {
namespace {

TEST(CoreGuard, KeepsItsCoresBusyAndTheCallerFree) {
  const std::vector<int> cores = allowed_cores();
  {
    const CoreGuard guard(cores);
    const double start = guard.cpu_seconds();
    while (guard.cpu_seconds() - start < 0.01) sched_yield();  // ends only if its threads run
    EXPECT_EQ(allowed_cores(), cores);
  }
  EXPECT_EQ(allowed_cores(), cores);
}

TEST(CoreGuard, OfNoCoresDoesNothing) {
  const CoreGuard guard({});
  EXPECT_EQ(guard.cpu_seconds(), 0);
}

}  // namespace
}  // namespace dapple::scaling
