// The choice of instruction set: forced levels are the ones that run.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "accel/kernels/dispatch.h"
#include "accel/kernels/targets.h"

namespace dapple::test {
namespace {

TEST(Isa, ThereIsALevelAndTheBestIsTheDefault) {
  ASSERT_FALSE(available_isas().empty());
  EXPECT_FALSE(kernels().isa.empty());
}

TEST(Isa, EachLevelHasItsOwnKernels) {
  std::set<std::string_view> names;
  std::set<const void*> functions;
  for (const KernelTable* table : kernel_tables()) {
    names.insert(table->isa);
    functions.insert(reinterpret_cast<const void*>(table->intersect_wide));
    functions.insert(reinterpret_cast<const void*>(table->intersect_linear));
  }
  EXPECT_EQ(names.size(), kernel_tables().size());
  EXPECT_EQ(functions.size(), 2 * kernel_tables().size());
}

TEST(Isa, TheForcedLevelIsTheOneInUse) {
  for (const KernelTable* table : kernel_tables()) {
    ASSERT_TRUE(force_isa(table->isa));
    EXPECT_EQ(kernels().isa, table->isa);
    EXPECT_EQ(kernels().intersect_wide, table->intersect_wide);
    EXPECT_EQ(kernels().occluded_wide, table->occluded_wide);
    EXPECT_EQ(kernels().intersect_linear, table->intersect_linear);
    EXPECT_EQ(kernels().occluded_linear, table->occluded_linear);
  }
  ASSERT_TRUE(force_isa(available_isas().front()));
}

TEST(Isa, AnUnknownLevelIsAnErrorThatListsThem) {
  const std::string before(kernels().isa);
  const Status status = force_isa("mmx");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, Errc::usage);
  for (const std::string_view isa : available_isas()) {
    EXPECT_NE(status.error().message.find(isa), std::string::npos);
  }
  EXPECT_EQ(kernels().isa, before);
}

// The environment is read once in a process, so each case needs one of its own.
[[noreturn]] void exit_with_environment(const char* value, std::string_view expected,
                                        bool expect_error) {
  setenv("DAPPLE_ISA", value, 1);
  const bool right = kernels().isa == expected && !check_isa_override() == expect_error;
  std::_Exit(right ? 0 : 1);
}

TEST(IsaDeathTest, TheEnvironmentChoosesTheLevel) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const std::string_view isa : available_isas()) {
    EXPECT_EXIT(exit_with_environment(std::string(isa).c_str(), isa, false),
                ::testing::ExitedWithCode(0), "");
  }
  EXPECT_EXIT(exit_with_environment("mmx", available_isas().front(), true),
              ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace dapple::test
