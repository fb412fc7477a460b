// The kernel tables that were compiled, one for each instruction set that the processor has.
#pragma once

#include <vector>

#include "accel/kernels/dispatch.h"

namespace dapple {

// Best first, never empty.
[[nodiscard]] const std::vector<const KernelTable*>& kernel_tables();

}  // namespace dapple
