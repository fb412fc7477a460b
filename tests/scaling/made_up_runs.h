// Measurements that nobody made: times that follow a law exactly.
#pragma once

#include "dapple/scaling/laws.h"
#include "dapple/scaling/result.h"

namespace dapple::scaling {

// One thread takes a second; the serial fraction is that of Amdahl's law for a factor of 1 and of
// Gustafson's otherwise.
inline double time_by_law(const Configuration& c, double serial) {
  if (c.factor == 1) return 1 / amdahl_speedup(serial, c.threads);
  return c.factor / gustafson_speedup(serial, c.threads);
}

inline Sample sample_of(double seconds, int threads) {
  Sample sample;
  sample.wall = seconds;
  sample.cpu = seconds * threads;
  for (int i = 0; i < threads; ++i) sample.busy.push_back({seconds, seconds, 1});
  return sample;
}

inline Measurements made_up_runs(std::vector<WorkKind> works, std::vector<int> threads, int rounds,
                                 double serial) {
  Measurements m;
  m.plan = make_plan(works, threads);
  m.threads = std::move(threads);
  m.rounds = rounds;
  m.pinned = true;
  for (const Configuration& c : m.plan) {
    m.samples.emplace_back(rounds, sample_of(time_by_law(c, serial), c.threads));
  }
  return m;
}

inline Machine quiet_machine(int cores) {
  Machine machine;
  machine.processor = "Imagined \"X\", 3 GHz";
  machine.cores = machine.cores_online = cores;
  return machine;
}

}  // namespace dapple::scaling
