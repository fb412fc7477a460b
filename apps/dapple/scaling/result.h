// A finished study: all that its output files say.
#pragma once

#include <string>
#include <vector>

#include "dapple/scaling/summary.h"

namespace dapple::scaling {

// What the work of one thread is.
struct BaseWork {
  std::string scene;
  int width = 0, height = 0;
  int ray_samples = 0, ray_bvh_samples = 0;  // per pixel
  int build_objects = 0;
};

struct Result {
  BaseWork base;
  Machine machine;
  Measurements measurements;
  std::vector<Curve> curves;
  std::vector<std::string> warnings;
};

}  // namespace dapple::scaling
