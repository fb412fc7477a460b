#include <gtest/gtest.h>

#include "harness/interleave.h"
#include "harness/samples.h"
#include "harness/table.h"
#include "parallel/parallel.h"

namespace dapple::bench {
namespace {

Samples samples_of(std::vector<double> walls) {
  Samples samples;
  for (const double wall : walls) samples.runs.push_back({wall, 0});
  return samples;
}

TEST(Samples, MedianIsTheMiddleOrTheMeanOfTheTwoMiddles) {
  EXPECT_EQ(median_of({3, 1, 2}), 2);
  EXPECT_EQ(median_of({4, 1, 3, 2}), 2.5);
}

TEST(Samples, OneCoreCountsProcessorTimeAndAllCoresWallTime) {
  Samples samples;
  samples.runs = {{2.0, 1.0}};
  samples.cores = Cores::one;
  EXPECT_EQ(samples.median(), 1.0);
  samples.cores = Cores::all;
  EXPECT_EQ(samples.median(), 2.0);
}

TEST(Samples, RatioPairsRunsOfTheSameRound) {
  const Ratio ratio = time_ratio(samples_of({2, 6, 4}), samples_of({1, 2, 4}));
  EXPECT_EQ(ratio.median, 2);  // 4 over 2
  EXPECT_EQ(ratio.low, 1);
  EXPECT_EQ(ratio.high, 3);
}

TEST(Interleave, EveryTaskRunsOncePerRoundAfterItsPreparation) {
  std::string order;
  std::vector<Task> tasks;
  for (const char* name : {"a", "b", "c"}) {
    tasks.push_back({name, [&order] { order += '('; }, [&order, name] { order += name; }});
  }
  const auto samples = run_interleaved(tasks, 3, WarmUp::none);
  EXPECT_EQ(order, "(a(b(c(b(c(a(c(a(b");
  ASSERT_EQ(samples.size(), 3u);
  for (const Samples& s : samples) EXPECT_EQ(s.runs.size(), 3u);
}

TEST(Cores, ScopeSetsThreadsAndAffinityAndPutsThemBack) {
  const int before = thread_count();
  cpu_set_t affinity_before, inside, after;
  sched_getaffinity(0, sizeof(affinity_before), &affinity_before);
  {
    const CoreScope scope(Cores::one);
    EXPECT_EQ(thread_count(), 1);
    sched_getaffinity(0, sizeof(inside), &inside);
    EXPECT_EQ(CPU_COUNT(&inside), 1);
  }
  sched_getaffinity(0, sizeof(after), &after);
  EXPECT_TRUE(CPU_EQUAL(&affinity_before, &after));
  EXPECT_EQ(thread_count(), before);
}

TEST(Table, MarkdownAlignsNumbersToTheRight) {
  Table table({"what", "s"});
  table.add_row({"a", "1.0"});
  EXPECT_EQ(table.markdown(),
            "| what |   s |\n"
            "| ---- | --: |\n"
            "| a    | 1.0 |\n");
}

}  // namespace
}  // namespace dapple::bench
