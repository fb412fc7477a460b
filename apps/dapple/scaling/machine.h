// On what machine a study ran, and what else ran there meanwhile.
#pragma once

#include <string>

namespace dapple::scaling {

struct Machine {
  std::string processor;
  int cores = 0;         // that this process may use
  int cores_online = 0;  // of the machine
  double memory_gib = 0;
  std::string system;
  std::string isa;                         // the kernels' instruction set
  double load_before = 0, load_after = 0;  // mean number of runnable threads of the last minute
  double other_cores = 0;                  // cores that other processes kept busy, on average
  double stolen_cores = 0;  // cores that the host gave to other virtual machines, on average
};

[[nodiscard]] Machine describe_machine();

// From its making to finish().
class ActivityMeter {
 public:
  ActivityMeter();
  // Fills in load_after and the cores that others had.
  void finish(Machine& machine) const;

 private:
  struct Reading {
    double wall = 0, own = 0, busy = 0, stolen = 0;  // seconds; the last two of all processors
  };
  static Reading read();

  Reading start_;
};

}  // namespace dapple::scaling
