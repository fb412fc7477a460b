// What else ran on the machine.
#pragma once

namespace dapple::scaling {

struct Activity {
  double other_cores = 0;   // cores that other processes kept busy, on average
  double stolen_cores = 0;  // cores that the host gave to other virtual machines, on average

  double cores() const { return other_cores + stolen_cores; }
};

// From its making on; the system counts in steps of a hundredth of a second. Where the system does
// not tell, nothing else ran.
class ActivityMeter {
 public:
  ActivityMeter() : start_(read()) {}
  Activity elapsed() const;

 private:
  struct Reading {
    double wall = 0, own = 0, busy = 0, stolen = 0;  // seconds; the last two of all processors
  };
  static Reading read();

  Reading start_;
};

}  // namespace dapple::scaling
