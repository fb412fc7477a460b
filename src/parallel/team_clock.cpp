#include "parallel/team_clock.h"

#include <time.h>

namespace dapple {
namespace {

struct Instant {
  double wall = 0, cpu = 0;
};

double seconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Instant now() { return {seconds_of(CLOCK_MONOTONIC), seconds_of(CLOCK_THREAD_CPUTIME_ID)}; }

// What this thread is measured for; its own, so that no other thread touches it.
struct ThreadClock {
  BusyTime* busy = nullptr;  // null when nobody asked
  bool running = false;
  Instant start;

  void begin() {
    running = true;
    start = now();
  }
  void end() {
    const Instant stop = now();
    busy->wall += stop.wall - start.wall;
    busy->cpu += stop.cpu - start.cpu;
    running = false;
  }
};

thread_local ThreadClock thread_clock;

}  // namespace

std::vector<BusyTime> ThreadTimes::busy() const {
  std::vector<BusyTime> result;
  for (const Slot& slot : slots_) result.push_back(slot.busy);
  return result;
}

TeamClock::TeamClock(ThreadTimes* times, int thread_count) : times_(times) {
  if (times_ != nullptr) times_->slots_.assign(static_cast<std::size_t>(thread_count), {});
}

TeamClock::Member::Member(const TeamClock& team, int thread) {
  if (team.times_ == nullptr) return;
  thread_clock.busy = &team.times_->slots_.at(static_cast<std::size_t>(thread)).busy;
}

TeamClock::Member::~Member() { thread_clock.busy = nullptr; }

WorkSpan::WorkSpan() : started_(thread_clock.busy != nullptr && !thread_clock.running) {
  if (thread_clock.busy != nullptr) ++thread_clock.busy->pieces;
  if (started_) thread_clock.begin();
}

WorkSpan::~WorkSpan() {
  if (started_) thread_clock.end();
}

WaitSpan::WaitSpan() : paused_(thread_clock.running) {
  if (paused_) thread_clock.end();
}

WaitSpan::~WaitSpan() {
  if (paused_) thread_clock.begin();
}

}  // namespace dapple
