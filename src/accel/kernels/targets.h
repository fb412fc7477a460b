// The kernel tables that were compiled, one for each instruction set that the processor has.
#pragma once

#include <span>

#include "accel/kernels/dispatch.h"

namespace dapple {

// Best first, never empty.
[[nodiscard]] std::span<const KernelTable* const> kernel_tables();

}  // namespace dapple
