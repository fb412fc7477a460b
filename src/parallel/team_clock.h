// Within parallel/: the clocks that fill ThreadTimes. Each costs a pointer test when nobody asked.
#pragma once

#include "parallel/thread_times.h"

namespace dapple {

// One a loop or team of tasks, made before its threads are.
class TeamClock {
 public:
  TeamClock(ThreadTimes* times, int thread_count);

  // While it lives, what the calling thread does in WorkSpans counts as work of that thread.
  class Member {
   public:
    Member(const TeamClock& team, int thread);
    ~Member();
    Member(const Member&) = delete;
    Member& operator=(const Member&) = delete;
  };

 private:
  ThreadTimes* times_;
};

// A piece of work of this thread. One inside another counts as part of the outer one.
class WorkSpan {
 public:
  WorkSpan();
  ~WorkSpan();
  WorkSpan(const WorkSpan&) = delete;
  WorkSpan& operator=(const WorkSpan&) = delete;

 private:
  bool started_;
};

// Waiting, which is no work; pieces that the thread takes up meanwhile are.
class WaitSpan {
 public:
  WaitSpan();
  ~WaitSpan();
  WaitSpan(const WaitSpan&) = delete;
  WaitSpan& operator=(const WaitSpan&) = delete;

 private:
  bool paused_;
};

}  // namespace dapple
