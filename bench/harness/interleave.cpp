#include "harness/interleave.h"

#include <chrono>
#include <thread>

namespace dapple::bench {
namespace {

// An OpenMP worker waits for more work in a loop, some 15 ms, before it sleeps; on the core of the
// next task it would take half of that time from it.
constexpr std::chrono::milliseconds kUntilWorkersSleep{50};

Seconds run_once(const Task& task) {
  const CoreScope scope(task.cores);
  if (task.prepare) task.prepare();
  std::this_thread::sleep_for(kUntilWorkersSleep);
  const Stopwatch stopwatch;
  task.run();
  return stopwatch.elapsed();
}

}  // namespace

std::vector<Samples> run_interleaved(std::span<const Task> tasks, int rounds, WarmUp warm_up) {
  std::vector<Samples> samples;
  for (const Task& task : tasks) samples.push_back({task.name, task.cores, {}});
  if (warm_up == WarmUp::one_round) {
    for (const Task& task : tasks) run_once(task);
  }
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const std::size_t turn = (i + static_cast<std::size_t>(round)) % tasks.size();
      samples[turn].runs.push_back(run_once(tasks[turn]));
    }
  }
  return samples;
}

}  // namespace dapple::bench
