// What `ray` and `ray_bvh` share.
#pragma once

#include "accel/accel.h"

namespace dapple {

// The whole program: arguments OUTFILE NX NY NS [SCENE]; the exit code is the result.
int run_classic_render(int argc, char** argv, AccelKind kind);

}  // namespace dapple
