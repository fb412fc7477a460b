#include "dapple/scaling/plan.h"

#include <gtest/gtest.h>

namespace dapple::scaling {
namespace {

TEST(Plan, EveryConfigurationOnceAndOneThreadServesBothModes) {
  const std::vector<WorkKind> works = {WorkKind::ray, WorkKind::build};
  const std::vector<int> threads = {1, 2, 4};
  const std::vector<Configuration> expected = {{WorkKind::ray, 1, 1},   {WorkKind::ray, 2, 1},
                                               {WorkKind::ray, 2, 2},   {WorkKind::ray, 4, 1},
                                               {WorkKind::ray, 4, 4},   {WorkKind::build, 1, 1},
                                               {WorkKind::build, 2, 1}, {WorkKind::build, 2, 2},
                                               {WorkKind::build, 4, 1}, {WorkKind::build, 4, 4}};
  EXPECT_EQ(make_plan(works, threads), expected);
}

TEST(Plan, ThreadCountsAreSortedUniqueAndHaveOne) {
  EXPECT_EQ(tidy_thread_counts({4, 2, 4}), (std::vector<int>{1, 2, 4}));
  EXPECT_EQ(tidy_thread_counts({}), (std::vector<int>{1}));
  EXPECT_EQ(default_thread_counts(1), (std::vector<int>{1}));
  EXPECT_EQ(default_thread_counts(2), (std::vector<int>{1, 2}));
  EXPECT_EQ(default_thread_counts(12), (std::vector<int>{1, 2, 4, 8, 12}));
}

TEST(Plan, NamesAreReadBack) {
  for (const WorkKind kind : {WorkKind::ray, WorkKind::ray_bvh, WorkKind::build}) {
    EXPECT_EQ(*parse_work(work_name(kind)), kind);
  }
  EXPECT_EQ(parse_work("cook").error().code, Errc::usage);
}

}  // namespace
}  // namespace dapple::scaling
