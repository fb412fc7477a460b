#include "parallel/thread_times.h"

#include <gtest/gtest.h>
#include <time.h>

#include <stdexcept>

#include "parallel/parallel.h"
#include "parallel/tasks.h"
#include "parallel/team_clock.h"

namespace dapple {
namespace {

constexpr double kPiece = 0.002;  // seconds

void sleep_for(double seconds) {
  const timespec time{0, static_cast<long>(seconds * 1e9)};
  nanosleep(&time, nullptr);
}

// Keeps the processor busy for so long.
void work_for(double seconds) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double end = now() + seconds;
  while (now() < end) {
  }
}

class ThreadTimesTest : public testing::Test {
 protected:
  void SetUp() override { set_thread_count(2); }
  void TearDown() override { set_thread_count(0); }

  BusyTime sum() const {
    BusyTime sum;
    for (const BusyTime& thread : times_.busy()) {
      sum.wall += thread.wall;
      sum.cpu += thread.cpu;
      sum.pieces += thread.pieces;
    }
    return sum;
  }

  ThreadTimes times_;
};

TEST_F(ThreadTimesTest, ALoopCountsEveryPieceAndItsTime) {
  parallel_for_dynamic(
      20, [](std::size_t) { work_for(kPiece); }, &times_);
  EXPECT_EQ(times_.busy().size(), 2u);
  EXPECT_EQ(sum().pieces, 20u);
  // The clocks are read outside the piece, so they can only show more.
  EXPECT_GE(sum().cpu, 20 * kPiece);
  EXPECT_GE(sum().wall, 20 * kPiece);
}

TEST_F(ThreadTimesTest, SleepingIsWallTimeAlone) {
  parallel_for_dynamic(
      10, [](std::size_t) { sleep_for(0.01); }, &times_);
  EXPECT_GE(sum().wall, 0.1);
  EXPECT_LT(sum().cpu, sum().wall / 2);
}

TEST_F(ThreadTimesTest, ALoopBeginsAnew) {
  parallel_for_dynamic(
      20, [](std::size_t) {}, &times_);
  parallel_for_dynamic(
      3, [](std::size_t) {}, &times_);
  EXPECT_EQ(sum().pieces, 3u);
}

TEST_F(ThreadTimesTest, AnExceptionEndsItsPiece) {
  const auto loop = [&] {
    parallel_for_dynamic(
        1, [](std::size_t) { throw std::runtime_error("x"); }, &times_);
  };
  EXPECT_THROW(loop(), std::runtime_error);
  EXPECT_EQ(sum().pieces, 1u);
  // Nothing goes on being measured.
  parallel_for_dynamic(1, [](std::size_t) { work_for(kPiece); });
  EXPECT_LT(sum().cpu, kPiece);
}

TEST_F(ThreadTimesTest, WaitingIsNoWorkButPiecesMeanwhileAre) {
  {
    const TeamClock clock(&times_, 1);
    const TeamClock::Member member(clock, 0);
    const WorkSpan work;
    sleep_for(0.01);
    const WaitSpan wait;
    sleep_for(0.5);
    const WorkSpan meanwhile;
    sleep_for(0.01);
  }
  EXPECT_EQ(sum().pieces, 2u);
  EXPECT_GE(sum().wall, 0.02);
  EXPECT_LT(sum().wall, 0.5);
}

TEST_F(ThreadTimesTest, EveryTaskIsAPiece) {
  const auto root = [] {
    TaskGroup tasks;
    for (int i = 0; i < 4; ++i) tasks.run([] { sleep_for(0.01); });
    tasks.wait();
  };
  run_with_tasks(kTeamWork, root, &times_);
  EXPECT_EQ(sum().pieces, 5u);  // with the root
  EXPECT_GE(sum().wall, 0.04);
}

TEST_F(ThreadTimesTest, NestedTasksAreCountedOnce) {
  run_with_tasks(
      kTeamWork,
      [] {
        TaskGroup outer;
        outer.run([] {
          TaskGroup inner;
          for (int i = 0; i < 4; ++i) inner.run([] { work_for(kPiece); });
          inner.wait();
          work_for(kPiece);
        });
        outer.wait();
      },
      &times_);
  EXPECT_GE(sum().cpu, 5 * kPiece);
  EXPECT_LT(sum().cpu, 10 * kPiece);  // counted twice it would be 10
}

TEST_F(ThreadTimesTest, LittleWorkIsOneThreads) {
  run_with_tasks(
      1, [] { work_for(kPiece); }, &times_);
  EXPECT_EQ(sum().pieces, 1u);
  EXPECT_GE(sum().cpu, kPiece);
}

}  // namespace
}  // namespace dapple
