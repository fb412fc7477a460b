#include "util/unwritten_vector.h"

#include <sys/mman.h>

#include <cstdint>
#include <new>

#include "util/huge_array.h"

namespace dapple {

void* allocate_unwritten(std::size_t bytes) {
  void* address = ::operator new(bytes);
  const auto begin = reinterpret_cast<std::uintptr_t>(address);
  const std::uintptr_t first = (begin + kHugePage - 1) / kHugePage * kHugePage;
  const std::uintptr_t last = (begin + bytes) / kHugePage * kHugePage;
  // A wish; may be refused.
  if (first < last) ::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
  return address;
}

}  // namespace dapple
