#include "tests/architecture/kernel_symbols.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"

namespace dapple::architecture {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

// Paths of object files, one a line, as the build system wrote them.
std::vector<std::string> objects_in(const std::string& list) {
  const auto slash = list.rfind('/');
  return lines_of(
      read_source_tree(list.substr(0, slash), {list.substr(slash + 1)}).at(list.substr(slash + 1)));
}

TEST(KernelSymbols, KernelsShareNoWeakFunction) {
  std::size_t kernels = 0;
  for (const std::string& object : objects_in(DAPPLE_MODULE_OBJECTS)) {
    const std::string symbols = run_nm(object);
    if (!holds_kernels(symbols)) continue;
    ++kernels;
    EXPECT_THAT(shared_weak_functions(symbols), IsEmpty()) << object;
  }
  EXPECT_GT(kernels, 0u);
}

TEST(KernelSymbols, LeakIsFoundInAnObject) {
  const auto objects = objects_in(DAPPLE_LEAKY_OBJECTS);
  ASSERT_THAT(objects, Not(IsEmpty()));
  EXPECT_THAT(shared_weak_functions(run_nm(objects[0])),
              ElementsAre("float dapple::leaky::twice<float>(float)"));
}

TEST(KernelSymbols, WhatCounts) {
  EXPECT_THAT(shared_weak_functions("0000000000000000 W std::vector<int>::push_back(int&&)\n"
                                    "0000000000000000 W dapple::N_AVX3::f<int>(int)\n"
                                    "0000000000000000 T dapple::g()\n"
                                    "0000000000000000 t dapple::h()\n"
                                    "0000000000000000 V typeinfo for dapple::A\n"
                                    "0000000000000000 u dapple::table\n"),
              ElementsAre("std::vector<int>::push_back(int&&)"));
}

}  // namespace
}  // namespace dapple::architecture
