#include "parallel/pinning.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>

#include "parallel/parallel.h"

namespace dapple {
namespace {

TEST(Pinning, EveryThreadOfTheTeamHasOneAllowedCore) {
  const std::vector<int> before = allowed_cores();
  ASSERT_FALSE(before.empty());
  const int threads_before = thread_count();
  const int threads = static_cast<int>(before.size()) + 1;
  {
    const PinnedTeam team(threads);
    EXPECT_TRUE(team.pinned());
    EXPECT_EQ(thread_count(), threads);
    std::mutex mutex;
    std::set<int> used;
    std::atomic<int> wrong{0};
    parallel_for_dynamic(1000, [&](std::size_t) {
      const std::vector<int> own = allowed_cores();
      if (own.size() != 1) ++wrong;
      const std::lock_guard lock(mutex);
      used.insert(own.begin(), own.end());
    });
    EXPECT_EQ(wrong, 0);
    for (const int core : used) {
      EXPECT_NE(std::find(before.begin(), before.end(), core), before.end());
    }
  }
  EXPECT_EQ(allowed_cores(), before);
  EXPECT_EQ(thread_count(), threads_before);
}

TEST(Pinning, OneTeamAfterAnotherStartsFromAllCores) {
  const std::vector<int> before = allowed_cores();
  { const PinnedTeam one(1); }
  const PinnedTeam team(static_cast<int>(before.size()));
  // Each thread waits for all others, so that each has exactly one turn.
  std::mutex mutex;
  std::set<int> used;
  std::atomic<std::size_t> arrived{0};
  parallel_for_dynamic(before.size(), [&](std::size_t) {
    ++arrived;
    while (arrived < before.size()) sched_yield();
    const std::lock_guard lock(mutex);
    for (const int core : allowed_cores()) used.insert(core);
  });
  EXPECT_EQ(used, std::set<int>(before.begin(), before.end()));
}

}  // namespace
}  // namespace dapple
